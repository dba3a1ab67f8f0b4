// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/guard/error_bound.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

constexpr double limit = 0.1;

/// What one collapse of `shape` adds to the bound.
double bound_of(const Shape& shape, Edge edge, const Vector3& x) {
  const WorkingMesh mesh = working_mesh(shape);
  EdgeNeighborhood around;
  around.gather(mesh.connectivity, edge);
  return ErrorBound(mesh, limit).after(mesh, around, x);
}

Shape lifted(Shape shape, int v, double height) {
  shape.vertices[v].z() += height;
  return shape;
}

TEST(ErrorBound, IsInactiveWithoutALimit) {
  const WorkingMesh mesh = working_mesh(plane_grid(4));
  EXPECT_FALSE(ErrorBound(mesh, 0.0).active());
  EXPECT_TRUE(ErrorBound(mesh, limit).active());
}

TEST(ErrorBound, AllowsUpToTheLimit) {
  const WorkingMesh mesh = working_mesh(plane_grid(4));
  const ErrorBound bound(mesh, limit);
  EXPECT_TRUE(bound.allows(limit));
  EXPECT_FALSE(bound.allows(std::nextafter(limit, 1.0)));
}

TEST(ErrorBound, OfACollapseInAPlaneIsZero) {
  EXPECT_NEAR(bound_of(plane_grid(4), {12, 17}, {0.6, 0.5, 0.0}), 0.0, 1e-15);
}

TEST(ErrorBound, OfACollapseAlongAStraightBoundaryIsZero) {
  EXPECT_NEAR(bound_of(plane_grid(4), {1, 2}, {0.0, 0.25, 0.0}), 0.0, 1e-15);
  EXPECT_NEAR(bound_of(plane_grid(4), {1, 2}, {0.0, 0.4, 0.0}), 0.0, 1e-15);
}

TEST(ErrorBound, OfAPeakThatIsRemovedIsItsHeight) {
  const Shape peak = lifted(plane_grid(4), 12, 0.05);
  EXPECT_NEAR(bound_of(peak, {12, 17}, peak.vertices[17]), 0.05, 1e-12);
}

TEST(ErrorBound, OfAPeakThatIsMadeIsItsHeight) {
  EXPECT_NEAR(bound_of(plane_grid(4), {12, 17}, {0.6, 0.5, 0.05}), 0.05, 1e-12);
}

TEST(ErrorBound, OfACornerThatIsCutIsNotBelowWhatIsCutOff) {
  // The corner (0, 0) of the square goes to (0, 0.25): the cut leaves it 0.25 / sqrt(2) away.
  EXPECT_GE(bound_of(plane_grid(4), {0, 1}, {0, 0.25, 0}), 0.25 / std::sqrt(2.0) - 1e-12);
}

/// The faces that are left lie over each other, but the boundary is gone from under it: 0 before.
TEST(ErrorBound, OfABoundaryVertexThatGoesInsideIsNotBelowWhatIsCutOff) {
  EXPECT_GE(bound_of(plane_grid(4), {2, 7}, {0.25, 0.5, 0.0}), 0.25 * std::sqrt(0.5));
  EXPECT_NEAR(bound_of(plane_grid(4), {2, 7}, {0.0, 0.5, 0.0}), 0.0, 1e-15);
}

TEST(ErrorBound, IsNeverMoreThanTheVerticesMove) {
  const Shape shape = noisy_sphere(2, 0.05);
  const WorkingMesh mesh = working_mesh(shape);
  for (int f = 0; f < shape.face_count(); ++f) {
    const Edge edge{std::min(shape.faces[f][0], shape.faces[f][1]),
                    std::max(shape.faces[f][0], shape.faces[f][1])};
    const Point x = 0.5 * (shape.vertices[edge.a] + shape.vertices[edge.b]);
    EXPECT_LE(bound_of(shape, edge, x), (shape.vertices[edge.a] - x).norm() + 1e-15);
  }
}

TEST(ErrorBound, AddsUpOverCollapsesOfTheSamePlace) {
  const WorkingMesh mesh = working_mesh(plane_grid(4));
  EdgeNeighborhood around;
  around.gather(mesh.connectivity, {12, 17});
  ErrorBound bound(mesh, limit);
  bound.set(around, 0.03);
  EXPECT_NEAR(bound.after(mesh, around, {0.6, 0.5, 0.02}), 0.05, 1e-12);
  around.gather(mesh.connectivity, {0, 1});  // far away
  EXPECT_NEAR(bound.after(mesh, around, {0, 0, 0}), bound_of(plane_grid(4), {0, 1}, {0, 0, 0}),
              1e-15);
}

}  // namespace
}  // namespace curvdecim::test
