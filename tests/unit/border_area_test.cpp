// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/metric/border_area.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// The plane for a border edge, and the area vector of the face at it.
std::optional<KeepingPlane> plane_of(const WorkingMesh& mesh, Edge edge) {
  EdgeNeighborhood around;
  around.gather(mesh.connectivity, edge);
  const Vector3 half = 0.5 * (mesh.position[edge.b] - mesh.position[edge.a]);
  return border_area_plane(mesh, edge, half, mesh.plane[around.wings()[0]].area_vector());
}

/// A fan around vertex 0 whose border has no two edges alike.
Shape uneven_fan() {
  return mapped(fan(9), [](const Point& p) {
    return Point(p.x() + 0.2 * p.y() * p.y(), 0.7 * p.y() - 0.1 * p.x() * p.x(), 0.0);
  });
}

TEST(BorderArea, IsTheSameWhereverTheVertexLiesOnThePlane) {
  for (Edge edge : {Edge{1, 2}, {4, 5}, {1, 9}}) {
    WorkingMesh mesh = working_mesh(uneven_fan());
    const double before = area(shape_of(mesh));
    const auto plane = plane_of(mesh, edge);
    ASSERT_TRUE(plane);
    const Vector3 middle = 0.5 * (mesh.position[edge.a] + mesh.position[edge.b]);
    const Vector3& gradient = plane->gradient;
    const Vector3 along = Vector3::UnitZ().cross(gradient).normalized();
    for (double t : {-0.1, 0.0, 0.1}) {
      WorkingMesh merged = mesh;
      const Vector3 x = middle + gradient * (plane->offset / gradient.squaredNorm()) + t * along;
      collapse_edge(
          merged, edge, x, [](auto&&...) {}, [](auto&&...) {});
      EXPECT_NEAR(area(shape_of(merged)), before, 1e-12);
    }
  }
}

TEST(BorderArea, HasNoPlaneInsideOrAtACorner) {
  EXPECT_FALSE(plane_of(working_mesh(plane_grid(4)), {12, 13}));
  EXPECT_FALSE(plane_of(working_mesh(plane_grid(4)), {0, 1}));
  EXPECT_TRUE(plane_of(working_mesh(plane_grid(4)), {1, 2}));
}

}  // namespace
}  // namespace curvdecim::test
