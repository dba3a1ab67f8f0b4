// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/edge_charts.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/texture.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

namespace {

constexpr double single_precision = 1e-6;  // of the weights

/// A 4 x 4 grid of which one edge is collapsed. Vertex 12 is its centre.
class EdgeChartsOf : public testing::Test {
 protected:
  /// t: where the vertex goes, from `keep` to `gone`.
  void collapse(int keep, int gone, const Vector3& now, double t = 0.5) {
    EdgeNeighborhood around;
    around.gather(mesh_.connectivity, {std::min(keep, gone), std::max(keep, gone)});
    charts_.gather(mesh_, around, {keep, gone, mesh_.position[keep], mesh_.position[gone], now, t});
    merge_wedges(mesh_, around, charts_);
    mesh_.connectivity.collapse(keep, gone);
    mesh_.position[keep] = now;
  }

  /// By face around v: the coordinate there.
  std::vector<Vector2> at_vertex(int v) const {
    std::vector<Vector2> corners;
    for (int f : mesh_.connectivity.faces_of(v))
      corners.push_back(mesh_.texture[mesh_.wedges.at(mesh_.connectivity, f, v)]);
    return corners;
  }

  WorkingMesh mesh_ = working_mesh(plane_grid(4));
  EdgeCharts charts_;
};

TEST_F(EdgeChartsOf, OneChartFollowsTheSurface) {
  give_plane_texture(mesh_);
  collapse(12, 17, {0.6, 0.45, 0.2});  // above the surface, off the edge
  EXPECT_EQ(charts_.count(), 1);
  ASSERT_FALSE(at_vertex(12).empty());
  for (const Vector2& corner : at_vertex(12))
    EXPECT_LT((corner - Vector2(0.6, 0.45)).norm(), single_precision);
}

TEST_F(EdgeChartsOf, AlongASeamBothSidesTakeTheSamePlaceOfTheEdge) {
  give_plane_texture(mesh_, 0.5);
  collapse(11, 12, {0.52, 0.375, 0.1}, 0.5);  // beside the seam
  EXPECT_EQ(charts_.count(), 2);
  int left = 0, right = 0;
  for (const Vector2& corner : at_vertex(11)) {
    const bool is_right = corner.x() > 0.5 * other_chart;
    ++(is_right ? right : left);
    EXPECT_NEAR(corner.x(), is_right ? 0.5 + other_chart : 0.5, other_chart * single_precision);
    EXPECT_NEAR(corner.y(), 0.375, single_precision);
  }
  EXPECT_GT(left, 0);
  EXPECT_GT(right, 0);
}

TEST_F(EdgeChartsOf, AcrossASeamEachChartKeepsToItself) {
  give_plane_texture(mesh_, 0.5);
  collapse(12, 17, {0.6, 0.5, 0.0});
  int left = 0;
  for (const Vector2& corner : at_vertex(12)) {
    const bool is_right = corner.x() > 0.5 * other_chart;
    if (!is_right) ++left;
    // The left chart ends at the seam; the right one has the place.
    EXPECT_NEAR(corner.x(), is_right ? 0.6 + other_chart : 0.5, other_chart * single_precision);
    EXPECT_NEAR(corner.y(), 0.5, single_precision);
  }
  EXPECT_GT(left, 0);
}

TEST_F(EdgeChartsOf, AVertexThatStaysKeepsItsBitsAndWhatComesToItTakesThem) {
  for (double angle : {0.3, 1.0, 2.2}) {
    mesh_ = working_mesh(rotated(plane_grid(4), angle, {1, 2, 3}));
    give_plane_texture(mesh_);
    const Vector2 before = mesh_.texture[12];
    collapse(12, 17, mesh_.position[12], 0.0);
    for (const Vector2& corner : at_vertex(12)) EXPECT_EQ(corner, before);
  }
}

TEST_F(EdgeChartsOf, WhatGoesOntoASeamStaysInItsChart) {
  give_plane_texture(mesh_, 0.5);
  collapse(12, 7, mesh_.position[12], 0.0);  // from the left
  EXPECT_EQ(charts_.count(), 2);
  for (int f : mesh_.connectivity.faces_of(12)) {
    const Face& wedges = mesh_.wedges.of_face(f);
    const bool is_right = mesh_.texture[wedges[0]].x() > 0.5 * other_chart;
    for (int wedge : wedges) EXPECT_EQ(mesh_.texture[wedge].x() > 0.5 * other_chart, is_right);
  }
}

/// Where a cut ends, a face joins what the two sides of the cut have.
TEST_F(EdgeChartsOf, AFaceJoinsWhatTwoOthersDidNot) {
  give_slit_texture(mesh_);
  collapse(12, 11, mesh_.position[12], 0.0);
  EXPECT_EQ(charts_.count(), 1);
  for (const Vector2& corner : at_vertex(12)) EXPECT_EQ(corner, Vector2(0.5, 0.5));
}

}  // namespace
}  // namespace curvdecim::test
