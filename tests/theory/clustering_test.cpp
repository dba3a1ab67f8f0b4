// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex clustering where the right answer is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/clustering.h"
#include "support/drawn_meshes.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST(ClusteredPlane, StaysInItsPlane) {
  for (double angle : {0.0, 0.8, 2.0}) {
    const Shape square = rotated(plane_grid(24), angle, {1, 2, 3});
    const Point normal = double_area(square, square.faces[0]).normalized();
    for (const NamedRepresentative& representative : shape_representatives()) {
      if (representative.representative == Representative::CellCenter && angle != 0.0) continue;
      const Shape after = clustered(square, representative.of(with_cells(0.25))).shape;
      for (const Point& p : after.vertices)
        EXPECT_LE(std::abs(normal.dot(p - square.vertices[0])), 4 * epsilon * diagonal(square))
            << representative.name;
    }
  }
}

TEST(ClusteredPlane, ByQuadricsKeepsItsOutlineAndArea) {
  for (double angle : {0.0, 0.8, 2.0}) {
    const Shape square = rotated(plane_grid(24), angle, {1, 2, 3});
    const Shape after = clustered(square, with_cells(0.25)).shape;
    EXPECT_NEAR(area(after), 1.0, 0.01);
    for (const Point& corner : rotated(two_triangles(), angle, {1, 2, 3}).vertices)
      EXPECT_TRUE(has_vertex(after, corner, 0.01));
    EXPECT_EQ(topology(after).boundary_loops, 1);
  }
}

TEST(ClusteredBox, ByQuadricsKeepsItsCorners) {
  const Point size(1, 2, 3);
  const Shape after = clustered(dense_box(12, size), with_cells(0.9)).shape;
  EXPECT_LT(after.face_count(), dense_box(12, size).face_count() / 4);
  EXPECT_NEAR(volume(after), size.prod(), 0.01);
  for (int corner = 0; corner < 8; ++corner) {
    const Point p((corner & 1) * size.x(), (corner >> 1 & 1) * size.y(), (corner >> 2) * size.z());
    EXPECT_TRUE(has_vertex(after, p, 2e-3 * size.norm())) << p.transpose();
  }
}

TEST(ClusteredBox, ByMeansLosesThem) {
  ClusteringParams params = with_cells(0.9);
  params.representative = Representative::Mean;
  EXPECT_LT(volume(clustered(dense_box(12, {1, 2, 3}), params).shape), 5.7);
}

/// The planes around a cell meet outside a convex surface, its vertices lie inside.
TEST(ClusteredSphere, HasItsVerticesNearTheSurface) {
  const Shape sphere = icosphere(5);
  const double side = 0.2 / std::sqrt(3.0), sagitta = side * side;  // of a cell, generously
  for (const NamedRepresentative& representative : shape_representatives()) {
    if (representative.representative == Representative::CellCenter) continue;
    for (const Point& p : clustered(sphere, representative.of(with_cells(0.2))).shape.vertices)
      EXPECT_NEAR(p.norm(), 1.0, sagitta) << representative.name;
  }
}

TEST(ClusteredSphere, ByQuadricsKeepsMoreOfItsVolumeThanByMeans) {
  const Shape sphere = icosphere(5);
  ClusteringParams params = with_cells(0.4);
  const double by_quadrics = volume(clustered(sphere, params).shape);
  params.representative = Representative::Mean;
  const double by_means = volume(clustered(sphere, params).shape);
  EXPECT_LT(std::abs(by_quadrics - volume(sphere)), 0.5 * std::abs(by_means - volume(sphere)));
}

/// The number of vertices goes with the area over that of a cell.
TEST(ClusteredSphere, HasAQuarterOfTheFacesInCellsOfTwiceTheSize) {
  const Shape sphere = icosphere(6);
  const double fine = clustered(sphere, with_cells(0.15)).shape.face_count();
  const double coarse = clustered(sphere, with_cells(0.3)).shape.face_count();
  EXPECT_NEAR(fine / coarse, 4.0, 0.4);
}

}  // namespace
}  // namespace curvdecim::test
