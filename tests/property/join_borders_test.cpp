// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of which neighbours share no vertex.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/properties.h"
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

RichVertex& vertex_at(RichMesh& mesh, const vcg::Point3d& p) {
  return *std::find_if(mesh.vert.begin(), mesh.vert.end(),
                       [&](const RichVertex& v) { return v.cP() == p; });
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

TEST(JoinBorders, WhereNormalsDifferButNotWhereColoursDo) {
  RichMesh mesh;
  fill_with_soup(mesh);  // with the normal of its face at every corner
  EXPECT_TRUE(says(decimate(mesh, to_faces(100)), "Joined 1152 pairs"));
  EXPECT_EQ(topology(shape_of(mesh)).boundary_loops, 0);

  RichMesh painted;
  fill_with_soup(painted);
  vertex_at(painted, {0.5, 0.5, 1.0}).C() = {1, 2, 3, 255};
  const DecimationReport report = decimate(painted, to_faces(100));
  EXPECT_TRUE(says(report, "2 pairs of border edges that lie on each other were not joined"));
  EXPECT_EQ(topology(shape_of(painted)).boundary_loops, 1);
}

TEST(JoinBorders, NotWhereCustomValuesDiffer) {
  RichMesh mesh;
  fill_with_soup(mesh);
  auto custom = vcg::tri::Allocator<RichMesh>::AddPerVertexAttribute<int>(mesh, "custom");
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) custom[v] = static_cast<int>(v);
  EXPECT_FALSE(says(decimate(mesh, to_faces(100)), "Joined"));
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
