// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of which neighbours share no vertex.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/removal.h"
#include "support/rich_mesh.h"
#include "support/touching.h"

namespace curvdecim::test {

namespace {

bool says(const DecimationReport& report, const std::string& words) {
  return std::any_of(report.notes.begin(), report.notes.end(), [&](const std::string& note) {
    return note.find(words) != std::string::npos;
  });
}

template <class Params>
Params apart(Params params) {
  params.join_borders = false;
  return params;
}

/// A dense box in the unit cube, every face by itself, with its attributes.
void fill_with_soup(RichMesh& mesh) {
  fill_with_attributes(mesh, soup_of(dense_box(8, {1, 1, 1})));
}

TEST(JoinBorders, OfASoupAndOfQuadsLeavesNoSeam) {
  const Shape box = dense_box(8, {1, 1, 1});
  for (const Shape& before : {soup_of(box), quads_of(box)})
    for (const AnyParams& params : {AnyParams(to_faces(60)), AnyParams(spheres_to_faces(60))}) {
      const auto [after, report] = decimated(before, params);
      EXPECT_EQ(report.stopped_by, StopReason::Target);
      EXPECT_TRUE(says(report, "pairs of border edges that lay on each other"));
      EXPECT_FALSE(says(report, "border vertices lie where"));
      EXPECT_EQ(topology(after).boundary_loops, 0);
      EXPECT_EQ(topology(after).components, 1);
      EXPECT_EQ(topology(after).unreferenced_vertices, 0);
      EXPECT_NEAR(volume(after), 1.0, 1e-6);
    }
}

TEST(JoinBorders, OfVertexRemovalLeavesNoSeamAndMovesNothing) {
  const Shape box = dense_box(8, {1, 1, 1});
  for (const Shape& before : {soup_of(box), quads_of(box)}) {
    const auto [after, report] = thinned(before, removal_to(60));
    EXPECT_TRUE(says(report, "pairs of border edges that lay on each other"));
    EXPECT_EQ(topology(after).boundary_loops, 0);
    EXPECT_EQ(topology(after).components, 1);
    EXPECT_NEAR(volume(after), 1.0, 1e-12);
    for (const Point& p : after.vertices)
      EXPECT_NE(std::find(before.vertices.begin(), before.vertices.end(), p),
                before.vertices.end());
  }
}

TEST(JoinBorders, OfVertexRemovalKeepsACopyForEachValueInOnePlace) {
  RichMesh mesh;
  fill_with_soup(mesh);
  for (std::size_t f = 0; f < mesh.face.size(); ++f)  // each face of the box has its own
    for (int i = 0; i < 3; ++i)
      mesh.face[f].V(i)->Q() = mesh.face[f].cN()[0] + 2.0 * mesh.face[f].cN()[1];
  const DecimationReport report = remove(mesh, removal_to(100));
  const Shape after = shape_of(mesh);
  EXPECT_TRUE(says(report, "come out as copies in one place"));
  EXPECT_EQ(topology(welded(after)).boundary_loops, 0);
  for (const RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i) EXPECT_EQ(f.cV(i)->cQ(), f.cV(0)->cQ());
}

TEST(JoinBorders, OfTouchingPartsClosesEach) {
  for (bool turned : {false, true}) {
    const Shape before = soup_of(boxes_at_a_face(turned, 6));
    const Shape after = decimated(before, to_faces(60)).shape;
    EXPECT_LE(after.face_count(), 60);
    EXPECT_EQ(topology(after).boundary_loops, 0);
    EXPECT_EQ(topology(after).components, 2);
    EXPECT_NEAR(volume(after), 2.0, 1e-6);
  }
}

TEST(JoinBorders, ChangesNothingWithoutBordersInOnePlace) {
  for (const Shape& shape : {bumpy_sphere(3), plane_grid(16), book(3, 8)})
    EXPECT_EQ(decimated(shape, to_faces(100)).shape, decimated(shape, apart(to_faces(100))).shape);
}

TEST(JoinBorders, OffLeavesTheSeamsAndSaysSo) {
  const auto [after, report] = decimated(soup_of(dense_box(8, {1, 1, 1})), apart(to_faces(60)));
  EXPECT_GT(topology(after).components, 1);
  EXPECT_TRUE(says(report, "border vertices lie where"));
}

TEST(JoinBorders, LeavesAMeshAloneThatIsSmallEnough) {
  const Shape soup = soup_of(cube());
  EXPECT_EQ(decimated(soup, to_faces(12)).shape, soup);
}

TEST(JoinBorders, CountsTheVerticesThatAreLeft) {
  EdgeCollapseParams params = to_faces(0);
  params.target_vertices = 40;
  const Shape after = decimated(soup_of(dense_box(8, {1, 1, 1})), params).shape;
  EXPECT_LE(after.vertex_count(), 40);
  EXPECT_GE(after.vertex_count(), 39);
}

TEST(JoinBorders, WhereNormalsDifferToo) {
  RichMesh mesh;
  fill_with_soup(mesh);  // with the normal of its face at every corner
  EXPECT_TRUE(says(decimate(mesh, to_faces(100)), "Joined 1152 pairs"));
  EXPECT_EQ(topology(shape_of(mesh)).boundary_loops, 0);
}

TEST(JoinBorders, WhereCustomValuesDifferWithACopyForEach) {
  RichMesh mesh;
  fill_with_soup(mesh);
  auto custom = vcg::tri::Allocator<RichMesh>::AddPerVertexAttribute<int>(mesh, "custom");
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) custom[v] = static_cast<int>(v);
  EXPECT_TRUE(says(decimate(mesh, to_faces(100)), "come out as copies in one place"));
  const Shape after = shape_of(mesh);
  EXPECT_GT(topology(after).boundary_loops, 0);
  EXPECT_EQ(topology(welded(after)).boundary_loops, 0);
  EXPECT_EQ(topology(after).unreferenced_vertices, 0);
  EXPECT_NEAR(volume(welded(after)), 1.0, 1e-6);
}

constexpr double other_chart = 10.0;  // added to u there

/// Which chart the texture coordinate is of.
int chart_of(const RichVertex& v) { return v.cT().u() > other_chart / 2.0; }

/// A flat square, every face by itself; texture coordinates are the position, on two charts that
/// meet in the middle.
void fill_with_charts(RichMesh& mesh) {
  fill_with_attributes(mesh, soup_of(plane_grid(24)));
  for (RichFace& f : mesh.face) {
    const bool other = f.cP(0)[0] + f.cP(1)[0] + f.cP(2)[0] > 1.5;
    for (int i = 0; i < 3; ++i)
      f.V(i)->T() = vcg::TexCoord2d(f.cP(i)[0] + (other ? other_chart : 0.0), f.cP(i)[1]);
  }
}

TEST(JoinBorders, OfTwoChartsLeavesNoCrackAndMixesNoValues) {
  for (Preset preset : {Preset::Fast, Preset::Balanced, Preset::Best})
    for (int target : {300, 60, 12}) {
      SCOPED_TRACE(target);
      RichMesh mesh;
      fill_with_charts(mesh);
      EdgeCollapseParams params = to_faces(target);
      params.preset = preset;
      EXPECT_TRUE(says(decimate(mesh, params), "come out as copies in one place"));
      const Shape closed = welded(shape_of(mesh));
      EXPECT_EQ(topology(closed).boundary_loops, 1);
      EXPECT_EQ(topology(closed).components, 1);
      EXPECT_NEAR(area(closed), 1.0, 1e-6);
      for (const RichFace& f : mesh.face)
        for (int i = 0; i < 3; ++i) {
          EXPECT_EQ(chart_of(*f.cV(i)), chart_of(*f.cV(0)));
          EXPECT_NEAR(f.cV(i)->cT().v(), f.cP(i)[1], 0.1);  // may shift at the seam
        }
    }
}

TEST(JoinBorders, KeepsValuesThatNoSeamIsNear) {
  RichMesh mesh;
  fill_with_charts(mesh);
  decimate(mesh, to_faces(60));
  for (const RichVertex& v : mesh.vert)
    if (std::abs(v.cP()[0] - 0.5) > 0.3) {
      EXPECT_NEAR(v.cT().u() - other_chart * chart_of(v), v.cP()[0], 1e-5);
    }
}

TEST(JoinBorders, OfChartsThatAreCutLeavesThemClosed) {
  const Shape ring = torus(48, 24);
  RichMesh mesh;
  fill(mesh, soup_of(ring));
  for (RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i) f.V(i)->T() = vcg::TexCoord2d(f.cP(0)[0] > 0.0, f.cP(i)[1]);
  const DecimationReport report = decimate(mesh, to_faces(4));
  EXPECT_GE(report.handles_cut, 1);
  EXPECT_EQ(mesh.fn, 4);
  EXPECT_EQ(topology(welded(shape_of(mesh))).boundary_loops, 0);
}

TEST(JoinBorders, OfCopiesIsTheSameOnAnyNumberOfThreads) {
  const auto texture = [](int threads) {
    RichMesh mesh;
    fill_with_charts(mesh);
    EdgeCollapseParams params = to_faces(100);
    params.threads = threads;
    decimate(mesh, params);
    std::vector<double> values;
    for (const RichVertex& v : mesh.vert)
      values.insert(values.end(), {v.cP()[0], v.cP()[1], v.cT().u(), v.cT().v()});
    return values;
  };
  EXPECT_EQ(texture(1), texture(3));
}

TEST(JoinBorders, NotAtFacesThatMayNotChange) {
  RichMesh mesh;
  fill_with_soup(mesh);
  const auto chosen = [](const vcg::Point3d& p) { return p[0] < 0.5; };
  const int selected = select_faces(mesh, chosen);
  const int others = mesh.fn - selected;
  EdgeCollapseParams params = to_faces(selected / 4);
  params.selected_only = true;
  const DecimationReport report = decimate(mesh, params);
  EXPECT_TRUE(says(report, "Joined"));
  EXPECT_EQ(
      std::count_if(mesh.face.begin(), mesh.face.end(), [](const RichFace& f) { return !f.IsS(); }),
      others);
  for (const RichFace& f : mesh.face) {
    if (f.IsS()) continue;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(f.cV(i) - f.cV(0), i);  // vertices of its own
  }
}

}  // namespace
}  // namespace curvdecim::test
