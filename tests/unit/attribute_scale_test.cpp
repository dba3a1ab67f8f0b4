// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/attribute_scale.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/texture.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// A square of side 1 in 2 * cells^2 faces, with u = x / length and v = y / length.
WorkingMesh textured_square(int cells, double length) {
  WorkingMesh mesh = working_mesh(plane_grid(cells));
  give_texture(mesh, [&](int f, int i) {
    const Vector3 p = mesh.triangle(f)[i];
    return Vector2(p.x() / length, p.y() / length);
  });
  return mesh;
}

TEST(AttributeScale, OfATextureIsTheSquaredLengthOfItsUnit) {
  EXPECT_NEAR(texture_scale2(textured_square(8, 0.25), Parallel(1)), 0.0625, 1e-12);
}

TEST(AttributeScale, OfColoursGrowsWithTheLengthInWhichTheyChange) {
  WorkingMesh mesh = textured_square(8, 1.0);
  const auto scale = [&](double length) {
    mesh.color.clear();
    for (const Vector3& p : mesh.position) mesh.color.emplace_back(p.x() / length, 0.5, 0.5);
    return color_scale2(mesh, Parallel(1));
  };
  EXPECT_GT(scale(1.0), 0.0);
  EXPECT_NEAR(scale(2.0), 4.0 * scale(1.0), 1e-12);
}

TEST(AttributeScale, IsNoneOfWhatIsAllAlike) {
  WorkingMesh mesh = working_mesh(plane_grid(4));
  EXPECT_EQ(texture_scale2(mesh, Parallel(1)), 0.0);
  EXPECT_EQ(color_scale2(mesh, Parallel(1)), 0.0);
  give_texture(mesh, [](int, int) { return Vector2(0.5, 0.5); });
  mesh.color.assign(mesh.texture.size(), Vector3(0.1, 0.2, 0.3));
  EXPECT_EQ(texture_scale2(mesh, Parallel(1)), 0.0);
  EXPECT_EQ(color_scale2(mesh, Parallel(1)), 0.0);
}

TEST(AttributeScale, IsTheSameForAnyNumberOfThreads) {
  const WorkingMesh mesh = textured_square(100, 0.3);
  for (int threads : {2, 5})
    EXPECT_EQ(texture_scale2(mesh, Parallel(threads)), texture_scale2(mesh, Parallel(1)));
}

}  // namespace
}  // namespace curvdecim::test
