// SPDX-License-Identifier: GPL-3.0-or-later
// Cancel, selection, attributes: what must be as it was, is.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/expectations.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// --- cancel --------------------------------------------------------------------------------------

TEST(Cancel, AtAnyCallLeavesTheMeshAsItWas) {
  expect_cancel_leaves(unit_ball(4), [](RichMesh& mesh, const Progress& progress) {
    return decimate(mesh, to_faces(500), progress);
  });
}

// --- selection -----------------------------------------------------------------------------------

TEST(Selection, FacesOutsideAreTheSameToTheBit) {
  for (const Shape& shape : {plane_grid(16), unit_ball(3)}) {
    RichMesh mesh;
    fill_with_attributes(mesh, shape);
    const int selected = select_faces(mesh, is_left), others = mesh.fn - selected;
    const std::multiset<std::string> before = unselected_faces(mesh);
    EdgeCollapseParams params = to_faces(selected / 4);
    params.selected_only = true;
    const DecimationReport report = decimate(mesh, params);
    EXPECT_EQ(unselected_faces(mesh), before);
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

/// Faces outside stay even if they are good for nothing, so their vertices must stay as well.
TEST(Selection, VerticesOfBadFacesOutsideAreLeftAlone) {
  for (bool topology : {true, false}) {
    RichMesh mesh;
    Shape shape = plane_grid(12);
    shape.vertices.push_back({2, 2, 2});
    const int lonely = shape.vertex_count() - 1;
    shape.faces.push_back({lonely, lonely, 3});                             // outside
    shape.faces.push_back({lonely, lonely, 5});                             // selected
    for (int v = 0; v < 40; v += 3) shape.faces.push_back({v, v, lonely});  // outside
    fill_with_attributes(mesh, shape);
    int selected = select_faces(mesh, is_left);
    for (std::size_t f = plane_grid(12).faces.size(); f < mesh.face.size(); ++f) {
      selected -= mesh.face[f].IsS();
      mesh.face[f].ClearS();
    }
    mesh.face[plane_grid(12).faces.size() + 1].SetS();
    const std::multiset<std::string> before = unselected_faces(mesh);
    EdgeCollapseParams params = to_faces(selected / 4);
    params.selected_only = true;
    params.preserve_topology = topology;
    decimate(mesh, params);
    for (const RichFace& f : mesh.face) {
      for (int i = 0; i < 3; ++i) {
        ASSERT_GE(f.cV(i), mesh.vert.data());
        ASSERT_LT(f.cV(i), mesh.vert.data() + mesh.vert.size());
      }
    }
    EXPECT_EQ(unselected_faces(mesh), before) << "preserve_topology " << topology;
  }
}

/// Without the topology guard a selected face may fall onto one outside: the selected one goes.
TEST(Selection, FacesOutsideSurviveADuplicateOfThem) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(2));
  const int selected = select_faces(mesh, [](const vcg::Point3d& p) { return p[2] < 0.9; });
  const std::multiset<std::string> before = unselected_faces(mesh);
  EdgeCollapseParams params = to_faces(0);
  params.selected_only = true;
  params.preserve_topology = params.preserve_normal = false;
  ASSERT_GT(selected, 0);
  decimate(mesh, params);
  EXPECT_EQ(unselected_faces(mesh), before);
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
  decimate(mesh_, params_);
  expect_affine_attributes(mesh_);
}

TEST_P(Attributes, WedgeCoordinatesFollowThePlane) {
  decimate(mesh_, params_);
  expect_affine_wedges(mesh_);
}

TEST_P(Attributes, WedgeCoordinatesOfTwoChartsDoNotMix) {
  put_right_half_on_a_page(mesh_);
  const DecimationReport report = decimate(mesh_, params_);
  expect_two_charts(mesh_, report);
  for (const RichFace& f : mesh_.face)
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(f.cWT(i).v(), f.cP(i)[1], 0.2);
}

/// A chart is known by equal coordinates at a vertex; a rounding error would tear it.
TEST_P(Attributes, WedgeCoordinatesOfOneChartDoNotTear) {
  RichMesh mesh;
  const Shape tilted = rotated(plane_grid(20), 0.4, {1, 2, 3});
  fill_with_attributes(mesh, tilted);
  decimate(mesh, params_);
  expect_no_tear(mesh);
}

TEST_P(Attributes, NormalsAreThoseOfThePlane) {
  decimate(mesh_, params_);
  for (const RichVertex& v : mesh_.vert) EXPECT_LT((v.cN() - vcg::Point3d(0, 0, 1)).Norm(), 1e-12);
  for (const RichFace& f : mesh_.face) EXPECT_LT((f.cN() - vcg::Point3d(0, 0, 1)).Norm(), 1e-12);
}

TEST_P(Attributes, OfAFaceAreThoseOfAFaceOfTheInput) {
  decimate(mesh_, params_);
  expect_faces_of_the_input(mesh_);
}

INSTANTIATE_TEST_SUITE_P(Placements, Attributes,
                         testing::Values(Placement::Optimal, Placement::Line,
                                         Placement::EndpointOrMidpoint, Placement::HalfEdge));

TEST(FaceNormals, FitTheFacesAfterwards) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(3));
  decimate(mesh, to_faces(200));
  expect_face_normals_that_fit(mesh);
}

TEST(VertexNormals, HaveLengthOneAndFitTheFacesAfterwards) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(3));
  decimate(mesh, to_faces(200));
  for (const RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i) {
      ASSERT_NEAR(f.cV(i)->cN().Norm(), 1.0, 1e-12);
      ASSERT_GT(f.cV(i)->cN() * f.cN(), 0.7);
    }
}

TEST(BoundingBox, FitsTheMeshAfterwards) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(2));
  decimate(mesh, to_faces(20));
  expect_box_that_fits(mesh);
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

TEST(AttributesThatAreNotFinite, DoNotSpreadFromACornerOfAFace) {
  RichMesh mesh;
  fill_with_attributes(mesh, plane_grid(20));
  int bad = 0;
  for (RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i)
      if (f.cV(i) == &mesh.vert[200]) f.WT(i).u() = nan, ++bad;
  decimate(mesh, to_faces(100));
  for (const RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i) bad -= std::isnan(f.cWT(i).u());
  EXPECT_GE(bad, 0);
}

TEST(Adjacency, OfTheHostDoesNotDangle) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(2));
  build_adjacency(mesh);
  decimate(mesh, to_faces(50));
  expect_no_adjacency(mesh);
}

}  // namespace
}  // namespace curvdecim::test
