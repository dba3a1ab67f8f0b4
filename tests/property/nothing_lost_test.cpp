// SPDX-License-Identifier: GPL-3.0-or-later
// Cancel, selection, attributes: what must be as it was, is.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/fingerprint.h"
#include "support/properties.h"
#include "support/rich_mesh.h"

namespace curvdecim::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Shape unit_ball(int subdivisions) {
  return translated(scaled(icosphere(subdivisions), 0.5), {0.5, 0.5, 0.5});
}

// --- cancel --------------------------------------------------------------------------------------

TEST(Cancel, AtAnyCallLeavesTheMeshAsItWas) {
  const Shape shape = unit_ball(4);
  int calls = 0;
  RichMesh counted;
  fill_with_attributes(counted, shape);
  decimate(counted, to_faces(500), [&](int, const char*) { return ++calls > 0; });
  ASSERT_GT(calls, 2);
  for (int last = 1; last <= calls; ++last) {
    RichMesh mesh;
    fill_with_attributes(mesh, shape);
    const std::string before = bytes_of(mesh);
    int call = 0;
    const DecimationReport report =
        decimate(mesh, to_faces(500), [&](int, const char*) { return ++call < last; });
    EXPECT_EQ(report.stopped_by, StopReason::Cancelled);
    EXPECT_EQ(report.faces, shape.face_count());
    EXPECT_EQ(bytes_of(mesh), before) << "cancelled at call " << last;
    EXPECT_EQ(call, last) << "went on after it was cancelled";
  }
}

TEST(Progress, RisesFrom0To100AndNamesItsStages) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(4));
  std::map<std::string, int> reached;
  decimate(mesh, to_faces(500), [&](int percent, const char* stage) {
    EXPECT_GE(percent, std::max(0, reached[stage]));
    EXPECT_LE(percent, 100);
    reached[stage] = percent;
    return true;
  });
  EXPECT_FALSE(reached.empty());
  EXPECT_EQ(reached.count(""), 0u);
}

// --- selection -----------------------------------------------------------------------------------

bool is_left(const vcg::Point3d& p) { return p[0] < 0.5; }

TEST(Selection, FacesOutsideAreTheSameToTheBit) {
  for (const Shape& shape : {plane_grid(16), unit_ball(3)}) {
    RichMesh mesh;
    fill_with_attributes(mesh, shape);
    const int selected = select_faces(mesh, is_left), others = mesh.fn - selected;
    std::multiset<std::string> before, after;
    for (const RichFace& f : mesh.face)
      if (!f.IsS()) before.insert(bytes_of(f));
    EdgeCollapseParams params = to_faces(selected / 4);
    params.selected_only = true;
    const DecimationReport report = decimate(mesh, params);
    for (const RichFace& f : mesh.face)
      if (!f.IsS()) after.insert(bytes_of(f));
    EXPECT_EQ(after, before);
    EXPECT_EQ(report.stopped_by, StopReason::Target);
    EXPECT_LE(mesh.fn - others, selected / 4);
    EXPECT_GE(mesh.fn - others, selected / 4 - 1);
  }
}

TEST(Selection, BadFacesOutsideAreLeftAlone) {
  Shape shape = plane_grid(12);
  shape.faces.push_back(shape.faces.back());
  RichMesh mesh;
  fill_with_attributes(mesh, shape);
  const int selected = select_faces(mesh, is_left), others = mesh.fn - selected;
  EdgeCollapseParams params = to_faces(selected / 2);
  params.selected_only = true;
  decimate(mesh, params);
  EXPECT_EQ(
      std::count_if(mesh.face.begin(), mesh.face.end(), [](const RichFace& f) { return !f.IsS(); }),
      others);
}

TEST(Selection, PolygonEdgesOutsideAreLeftAlone) {
  RichMesh mesh;
  fill_with_attributes(mesh, plane_grid(12));
  for (RichFace& f : mesh.face) f.SetF(0);
  const int selected = select_faces(mesh, is_left);
  EdgeCollapseParams params = to_faces(selected / 2);
  params.selected_only = true;
  decimate(mesh, params);
  for (const RichFace& f : mesh.face) ASSERT_TRUE(f.IsS() || f.IsF(0));
}

TEST(Selection, FractionCountsTheSelectedFaces) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(3));
  const int selected = select_faces(mesh, is_left), others = mesh.fn - selected;
  EdgeCollapseParams params;
  params.target_fraction = 0.5;
  params.selected_only = true;
  decimate(mesh, params);
  EXPECT_LE(mesh.fn - others, selected / 2);
  EXPECT_GE(mesh.fn - others, selected / 2 - 1);
}

// --- elements that take no part ------------------------------------------------------------------

TEST(DeletedElements, AreCompactedAwayAndChangeNothing) {
  const Shape shape = unit_ball(2);
  RichMesh clean, holey;
  fill_with_attributes(clean, shape);
  Shape with_more = side_by_side({one_triangle(), shape});
  fill_with_attributes(holey, with_more);
  vcg::tri::Allocator<RichMesh>::DeleteFace(holey, holey.face[0]);
  for (int v : {0, 1, 2}) vcg::tri::Allocator<RichMesh>::DeleteVertex(holey, holey.vert[v]);
  decimate(clean, to_faces(100));
  decimate(holey, to_faces(100));
  EXPECT_EQ(shape_of(holey), shape_of(clean));
  EXPECT_EQ(holey.fn, static_cast<int>(holey.face.size()));
  EXPECT_EQ(holey.vn, static_cast<int>(holey.vert.size()));
}

TEST(UnreferencedVertices, Survive) {
  Shape shape = unit_ball(2);
  shape.vertices.insert(shape.vertices.begin() + 7, Point(3, 4, 5));
  for (Corners& face : shape.faces)
    for (int& v : face) v += v >= 7;
  const Shape after = decimated(shape, to_faces(100)).shape;
  EXPECT_EQ(topology(after).unreferenced_vertices, 1);
  EXPECT_EQ(std::count(after.vertices.begin(), after.vertices.end(), Point(3, 4, 5)), 1);
}

// --- attributes ----------------------------------------------------------------------------------

class Attributes : public testing::TestWithParam<Placement> {
 protected:
  Attributes() {
    fill_with_attributes(mesh_, plane_grid(20));
    params_ = to_faces(100);
    params_.preset = Preset::Custom;
    params_.placement = GetParam();
  }

  RichMesh mesh_;
  EdgeCollapseParams params_;
};

TEST_P(Attributes, AffineInPositionAreExact) {
  constexpr double percent = 0.01;
  decimate(mesh_, params_);
  for (const RichVertex& v : mesh_.vert) {
    EXPECT_NEAR(v.cQ(), affine(v.cP()), percent);
    EXPECT_NEAR(v.cR(), affine(v.cP()), percent);
    EXPECT_NEAR(v.cT().u(), v.cP()[0], 1.0 / 1024);
    EXPECT_NEAR(v.cT().v(), v.cP()[1], 1.0 / 1024);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(v.cC()[k], affine_color(v.cP())[k], 255 * percent);
  }
}

TEST_P(Attributes, NormalsAreThoseOfThePlane) {
  decimate(mesh_, params_);
  for (const RichVertex& v : mesh_.vert) EXPECT_LT((v.cN() - vcg::Point3d(0, 0, 1)).Norm(), 1e-12);
  for (const RichFace& f : mesh_.face) EXPECT_LT((f.cN() - vcg::Point3d(0, 0, 1)).Norm(), 1e-12);
}

TEST_P(Attributes, OfAFaceAreThoseOfAFaceOfTheInput) {
  decimate(mesh_, params_);
  std::set<double> seen;
  for (const RichFace& f : mesh_.face) {
    const int was = static_cast<int>(f.cQ());
    EXPECT_EQ(f.cC(), vcg::Color4b(static_cast<unsigned char>(was % 256),
                                   static_cast<unsigned char>(was / 256), 1, 255));
    EXPECT_TRUE(seen.insert(f.cQ()).second);
  }
}

INSTANTIATE_TEST_SUITE_P(Placements, Attributes,
                         testing::Values(Placement::Optimal, Placement::Line,
                                         Placement::EndpointOrMidpoint, Placement::HalfEdge));

TEST(FaceNormals, FitTheFacesAfterwards) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(3));
  decimate(mesh, to_faces(200));
  for (const RichFace& f : mesh.face) {
    const vcg::Point3d normal = ((f.cP(1) - f.cP(0)) ^ (f.cP(2) - f.cP(0))).Normalize();
    ASSERT_LT((f.cN() - normal).Norm(), 1e-9);
  }
}

TEST(BoundingBox, FitsTheMeshAfterwards) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(2));
  decimate(mesh, to_faces(20));
  vcg::Box3d box;
  for (const RichVertex& v : mesh.vert) box.Add(v.cP());
  EXPECT_EQ(mesh.bbox.min, box.min);
  EXPECT_EQ(mesh.bbox.max, box.max);
}

TEST(CustomAttributes, StayWithTheirVerticesAndFaces) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(3));
  auto at = vcg::tri::Allocator<RichMesh>::AddPerVertexAttribute<vcg::Point3d>(mesh, "where");
  auto number = vcg::tri::Allocator<RichMesh>::AddPerFaceAttribute<double>(mesh, "number");
  for (RichVertex& v : mesh.vert) at[v] = v.cP();
  for (RichFace& f : mesh.face) number[f] = f.cQ();
  EdgeCollapseParams params = to_faces(200);
  params.preset = Preset::Custom;
  params.placement = Placement::HalfEdge;
  decimate(mesh, params);
  for (const RichVertex& v : mesh.vert) EXPECT_EQ(at[v], v.cP());
  for (const RichFace& f : mesh.face) EXPECT_EQ(number[f], f.cQ());
  vcg::tri::Allocator<RichMesh>::DeletePerVertexAttribute(
      mesh, "where");  // a mesh does not free them itself
  vcg::tri::Allocator<RichMesh>::DeletePerFaceAttribute(mesh, "number");
}

TEST(AttributesThatAreNotFinite, DoNotSpread) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(3));
  for (int v : {3, 30, 300}) mesh.vert[v].Q() = nan;
  decimate(mesh, to_faces(200));
  EXPECT_LE(std::count_if(mesh.vert.begin(), mesh.vert.end(),
                          [](const RichVertex& v) { return std::isnan(v.cQ()); }),
            3);
}

TEST(Adjacency, OfTheHostDoesNotDangle) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(2));
  vcg::tri::UpdateTopology<RichMesh>::VertexFace(mesh);
  vcg::tri::UpdateTopology<RichMesh>::FaceFace(mesh);
  decimate(mesh, to_faces(50));
  for (const RichVertex& v : mesh.vert) EXPECT_TRUE(v.cVFp() == nullptr);
  for (const RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(f.cFFp(i) == nullptr);
}

}  // namespace
}  // namespace curvdecim::test
