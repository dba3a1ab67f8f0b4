// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/triangle_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/drawn_meshes.h"
#include "support/probes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

constexpr double no_limit = 1e300;

WorkingMesh in_unit_box(const Shape& shape) { return working_mesh(scaled(shape, 0.25)); }

double least_distance2(const WorkingMesh& mesh, const Vector3& p, const Vector3& facing) {
  double least = no_limit;
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f) {
    if (mesh.plane[f].normal.dot(facing) < 0.0) continue;
    const Triangle t = mesh.triangle(f);
    least = std::min(least, (at(t, closest_point(t, p)) - p).squaredNorm());
  }
  return least;
}

TEST(TriangleTree, FindsWhatASearchOverAllFacesFinds) {
  for (const Shape& shape : {bumpy_sphere(2), torus(16, 8), one_triangle(), two_triangles()}) {
    const WorkingMesh mesh = in_unit_box(shape);
    const TriangleTree tree(mesh, mesh.connectivity.face_slots(), Parallel(2));
    for (const Vector3& p : probes())
      for (int hint : {SurfacePoint::none, 0}) {
        const SurfacePoint found = tree.nearest(p, hint);
        EXPECT_NEAR(found.distance2, least_distance2(mesh, p, Vector3::Zero()), 1e-15);
        EXPECT_NEAR((at(mesh.triangle(found.face), found.weight) - p).squaredNorm(),
                    found.distance2, 1e-15);
      }
  }
}

TEST(TriangleTree, PassesOverFacesThatFaceAway) {
  const WorkingMesh mesh = in_unit_box(torus(16, 8));
  const TriangleTree tree(mesh, mesh.connectivity.face_slots(), Parallel(1));
  const Vector3 up(0.1, 0.2, 1.0);
  for (const Vector3& p : probes())
    EXPECT_NEAR(tree.nearest_facing(p, up, no_limit, SurfacePoint::none).distance2,
                least_distance2(mesh, p, up), 1e-15);
}

TEST(TriangleTree, FindsNothingBeyondTheLimit) {
  const WorkingMesh mesh = in_unit_box(icosphere(1));
  const TriangleTree tree(mesh, mesh.connectivity.face_slots(), Parallel(1));
  const Vector3 p(0.5, 0.0, 0.0);  // 0.25 away
  EXPECT_FALSE(tree.nearest_facing(p, Vector3::Zero(), 0.2 * 0.2, SurfacePoint::none).found());
  EXPECT_TRUE(tree.nearest_facing(p, Vector3::Zero(), 0.3 * 0.3, SurfacePoint::none).found());
}

TEST(TriangleTree, FollowsVerticesThatMoved) {
  WorkingMesh mesh = in_unit_box(bumpy_sphere(2));
  TriangleTree tree(mesh, mesh.connectivity.face_slots(), Parallel(1));
  for (Vector3& p : mesh.position) p = 0.5 * p + Vector3(0.1, 0.0, 0.0);
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f) mesh.update_plane(f);
  tree.refit(Parallel(1));
  for (const Vector3& p : probes())
    EXPECT_NEAR(tree.nearest(p, SurfacePoint::none).distance2,
                least_distance2(mesh, p, Vector3::Zero()), 1e-15);
}

}  // namespace
}  // namespace curvdecim::test
