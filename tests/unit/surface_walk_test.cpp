// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/refine/match.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

TEST(SurfaceWalk, EndsAtTheNearestPointOfARoundSurface) {
  const WorkingMesh mesh = working_mesh(icosphere(3));
  const int faces = mesh.connectivity.face_slots();
  const TriangleTree<WorkingMesh> tree(mesh, faces, Parallel(1));
  for (int f = 0; f < faces; ++f) {
    const Triangle t = mesh.triangle(f);
    const Vector3 p = 1.1 * (0.5 * t[0] + 0.3 * t[1] + 0.2 * t[2]);
    for (int start : {f, (f + 1) % faces, (f + faces / 4) % faces})
      EXPECT_NEAR(walk_to_nearest(mesh, p, start, any_face).distance2,
                  tree.nearest(p, SurfacePoint::none).distance2, 1e-12)
          << f << " from " << start;
  }
}

TEST(SurfaceWalk, GoesOnAroundACorner) {
  const WorkingMesh mesh = working_mesh(plane_grid(4));
  const Vector3 p(0.9, 0.9, 0.2);
  for (int start = 0; start < mesh.connectivity.face_slots(); ++start)
    EXPECT_NEAR(walk_to_nearest(mesh, p, start, any_face).distance2, 0.04, 1e-15) << start;
}

TEST(SurfaceWalk, StaysOnItsSheet) {
  const Shape sheets = side_by_side({plane_grid(2), translated(plane_grid(2), {0.0, 0.0, 1.0})});
  const WorkingMesh mesh = working_mesh(sheets);
  const Vector3 p(0.3, 0.3, 0.1);
  EXPECT_NEAR(walk_to_nearest(mesh, p, 0, any_face).distance2, 0.01, 1e-15);
  EXPECT_NEAR(walk_to_nearest(mesh, p, sheets.face_count() - 1, any_face).distance2, 0.81, 1e-15);
}

TEST(SurfaceWalk, IsNotFoundWhereItMayNotStart) {
  const WorkingMesh mesh = working_mesh(plane_grid(2));
  const auto none = [](const Vector3&) { return false; };
  EXPECT_FALSE(walk_to_nearest(mesh, {0.3, 0.3, 0.1}, 0, none).found());
}

}  // namespace
}  // namespace curvdecim::test
