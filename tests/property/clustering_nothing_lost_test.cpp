// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex clustering: cancel, selection, attributes. What must be as it was, is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "support/clustering.h"
#include "support/drawn_meshes.h"
#include "support/expectations.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// --- cancel --------------------------------------------------------------------------------------

TEST(ClusteringCancel, AtAnyCallLeavesTheMeshAsItWas) {
  for (const ClusteringParams& params : {to_clusters(300), with_cells(0.1)})
    expect_cancel_leaves(unit_ball(4), [&](RichMesh& mesh, const Progress& progress) {
      return cluster(mesh, params, progress);
    });
}

// --- selection -----------------------------------------------------------------------------------

class ClusteringSelection : public testing::TestWithParam<NamedRepresentative> {
 protected:
  ClusteringParams params(ClusteringParams params) const {
    params.selected_only = true;
    return GetParam().of(params);
  }
};

TEST_P(ClusteringSelection, FacesOutsideAreTheSameToTheBit) {
  for (const Shape& shape : {plane_grid(24), unit_ball(4)})
    for (bool manifold : {false, true}) {
      RichMesh mesh;
      fill_with_attributes(mesh, shape);
      const int selected = select_faces(mesh, is_left), others = mesh.fn - selected;
      const std::multiset<std::string> before = unselected_faces(mesh);
      ClusteringParams p = params(with_cells(0.2));
      p.manifold_edges = manifold;
      cluster(mesh, p);
      EXPECT_EQ(unselected_faces(mesh), before);
      EXPECT_LT(mesh.fn - others, selected / 2);
      EXPECT_EQ(topology(shape_of(mesh)).unreferenced_vertices, 0);
    }
}

TEST_P(ClusteringSelection, MeetsTheRestWithoutAGap) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(4));
  select_faces(mesh, is_left);
  cluster(mesh, params(with_cells(0.2)));
  EXPECT_EQ(topology(shape_of(mesh)).boundary_loops, 0);
}

TEST_P(ClusteringSelection, TargetCountsTheSelectedFaces) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(4));
  const int selected = select_faces(mesh, is_left), others = mesh.fn - selected;
  const ClusteringReport report = cluster(mesh, params(to_clusters(selected / 3)));
  EXPECT_EQ(report.stopped_by, StopReason::Target);
  EXPECT_NEAR(mesh.fn - others, selected / 3, 0.02 * selected / 3);
}

INSTANTIATE_TEST_SUITE_P(All, ClusteringSelection, testing::ValuesIn(all_representatives()),
                         representative_name);

/// Faces outside stay even if they are good for nothing, and so do vertices that no face uses.
TEST(ClusteringSelection, BadElementsOutsideAreLeftAlone) {
  Shape shape = plane_grid(12);
  shape.vertices.push_back({nan, 2, 2});
  const int lonely = shape.vertex_count() - 1, corner = lonely - 1;
  shape.faces.push_back(shape.faces.back());
  shape.faces.push_back({lonely, lonely, corner});
  RichMesh mesh;
  fill_with_attributes(mesh, shape);
  select_faces(mesh, is_left);
  const std::multiset<std::string> before = unselected_faces(mesh);
  ClusteringParams params = with_cells(0.3);
  params.selected_only = true;
  cluster(mesh, params);
  EXPECT_EQ(unselected_faces(mesh), before);
}

// --- attributes ----------------------------------------------------------------------------------

class ClusteringAttributes : public testing::TestWithParam<NamedRepresentative> {
 protected:
  ClusteringAttributes() { fill_with_attributes(mesh_, plane_grid(20)); }

  RichMesh mesh_;
  const ClusteringParams params_ = GetParam().of(with_cells(0.25));
};

TEST_P(ClusteringAttributes, AffineInPositionAreExact) {
  cluster(mesh_, params_);
  expect_affine_attributes(mesh_);
}

TEST_P(ClusteringAttributes, WedgeCoordinatesFollowThePlane) {
  cluster(mesh_, params_);
  expect_affine_wedges(mesh_);
}

TEST_P(ClusteringAttributes, WedgeCoordinatesOfTwoChartsDoNotMix) {
  put_right_half_on_a_page(mesh_);
  const ClusteringReport report = cluster(mesh_, params_);
  expect_two_charts(mesh_, report);
}

TEST_P(ClusteringAttributes, WedgeCoordinatesOfOneChartDoNotTear) {
  cluster(mesh_, params_);
  expect_no_tear(mesh_);
}

TEST_P(ClusteringAttributes, OfAFaceAreThoseOfAFaceOfTheInput) {
  cluster(mesh_, params_);
  expect_faces_of_the_input(mesh_);
}

TEST_P(ClusteringAttributes, NormalsFitTheFacesAfterwards) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(4));
  cluster(mesh, GetParam().of(with_cells(0.2)));
  expect_face_normals_that_fit(mesh);
  for (const RichVertex& v : mesh.vert) ASSERT_NEAR(v.cN().Norm(), 1.0, 1e-12);
}

TEST_P(ClusteringAttributes, ThatAreNotFiniteDoNotSpread) {
  if (GetParam().name == "MeanByQuality") return;  // refused by name, see below
  for (int v : {3, 130, 300}) mesh_.vert[v].Q() = nan;
  cluster(mesh_, params_);
  EXPECT_LE(std::count_if(mesh_.vert.begin(), mesh_.vert.end(),
                          [](const RichVertex& v) { return std::isnan(v.cQ()); }),
            3);
}

INSTANTIATE_TEST_SUITE_P(All, ClusteringAttributes, testing::ValuesIn(all_representatives()),
                         representative_name);

TEST(ClusteringElements, DeletedOnesDoNotCount) {
  RichMesh mesh, clean;
  fill(clean, unit_ball(3));
  Shape shape = unit_ball(3);
  shape.vertices.push_back({7, 8, 9});
  shape.faces.insert(shape.faces.begin() + 5, Corners{0, 1, shape.vertex_count() - 1});
  fill(mesh, shape);
  vcg::tri::Allocator<RichMesh>::DeleteFace(mesh, mesh.face[5]);
  vcg::tri::Allocator<RichMesh>::DeleteVertex(mesh, mesh.vert.back());
  cluster(mesh, with_cells(0.2)), cluster(clean, with_cells(0.2));
  EXPECT_EQ(shape_of(mesh), shape_of(clean));
  EXPECT_EQ(mesh.vn, static_cast<int>(mesh.vert.size()));
  EXPECT_EQ(mesh.fn, static_cast<int>(mesh.face.size()));
}

TEST(ClusteringElements, AdjacencyOfTheHostDoesNotDangle) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(2));
  build_adjacency(mesh);
  cluster(mesh, with_cells(0.3));
  expect_no_adjacency(mesh);
}

TEST(ClusteringElements, TheBoundingBoxFitsAfterwards) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(3));
  cluster(mesh, with_cells(0.3));
  expect_box_that_fits(mesh);
}

}  // namespace
}  // namespace curvdecim::test
