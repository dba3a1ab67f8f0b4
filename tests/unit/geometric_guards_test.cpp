// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"
#include "vcg_ext/guard/limits.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

Vector3 tilted(double degrees) {
  const double radians = degrees * M_PI / 180.0;
  return {std::sin(radians), 0.0, std::cos(radians)};
}

bool turned(double degrees, double cos_limit) {
  return turns_too_far(tilted(0), {tilted(degrees), 0.5}, cos_limit);
}

TEST(NormalFlip, IsATurnBeyondTheLimit) {
  const double limit = std::cos(30.0 * M_PI / 180.0);
  EXPECT_FALSE(turned(29, limit));
  EXPECT_TRUE(turned(31, limit));
  EXPECT_TRUE(turned(180, limit));
}

TEST(NormalFlip, IsNoneWithoutANormalBefore) {
  EXPECT_FALSE(turns_too_far(Vector3::Zero(), {tilted(180), 0.5}, 0.0));
}

TEST(NormalFlip, IsNoneWithoutANormalAfter) {
  EXPECT_FALSE(turns_too_far(tilted(0), FacePlane{}, 0.5));
}

TEST(NormalFlip, IsNoneWithALimitOf180Degrees) { EXPECT_FALSE(turned(180, -1.0)); }

/// An isosceles triangle with a base of 1; the flatter, the worse its shape.
Triangle of_height(double height) {
  return {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0.5, height, 0)};
}

double quality_of_height(double height) { return shape_quality(of_height(height), 0.5 * height); }

bool spoiled(double height_before, double height_after, double least) {
  return spoils_shape(of_height(height_after), 0.5 * height_after, least,
                      [&] { return quality_of_height(height_before); });
}

TEST(TriangleShape, IsSpoiledWhenItGetsWorseThanTheLimit) {
  const double limit = quality_of_height(0.01);
  EXPECT_TRUE(spoiled(0.5, 0.009, limit));
  EXPECT_FALSE(spoiled(0.5, 0.011, limit));
}

TEST(TriangleShape, OfABadFaceMayGetBetter) {
  const double limit = quality_of_height(0.01);
  EXPECT_FALSE(spoiled(0.001, 0.005, limit));
  EXPECT_TRUE(spoiled(0.005, 0.001, limit));
}

TEST(TriangleShape, OfAFaceWithoutAreaMayStaySo) { EXPECT_FALSE(spoiled(0.0, 0.0, 0.01)); }

TEST(TriangleAfter, MovesTheCornerAtEitherEnd) {
  const WorkingMesh mesh = working_mesh(two_triangles());
  const Vector3 x(9, 9, 9);
  EXPECT_EQ(triangle_after(mesh, 1, {0, 1}, x)[0], x);
  EXPECT_EQ(triangle_after(mesh, 1, {0, 1}, x)[1], mesh.position[2]);
  EXPECT_EQ(triangle_after(mesh, 0, {1, 3}, x)[1], x);
}

// --- the measures the guards use -----------------------------------------------------------------

TEST(Triangle, HasANormalAndAnArea) {
  const FacePlane plane = face_plane({Vector3(0, 0, 5), Vector3(2, 0, 5), Vector3(0, 2, 5)});
  EXPECT_EQ(plane.normal, Vector3(0, 0, 1));
  EXPECT_EQ(plane.area, 2.0);
}

TEST(Triangle, WithoutAreaHasNoNormal) {
  const FacePlane plane = face_plane({Vector3(0, 0, 0), Vector3(1, 1, 1), Vector3(2, 2, 2)});
  EXPECT_EQ(plane.normal, Vector3(0, 0, 0));
  EXPECT_EQ(plane.area, 0.0);
}

TEST(Triangle, HasCornerAnglesThatSumToPi) {
  const Triangle needle{Vector3(0, 0, 0), Vector3(1, 1e-9, 0), Vector3(1, -1e-9, 0)};
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
    sum += corner_angle(needle[i], needle[(i + 1) % 3], needle[(i + 2) % 3]);
  EXPECT_NEAR(sum, M_PI, 1e-15);
  EXPECT_NEAR(corner_angle(needle[0], needle[1], needle[2]), 2e-9, 1e-20);
}

TEST(Triangle, ShapeIsOneWhenEquilateralAndZeroWithoutArea) {
  const Triangle equilateral{Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0.5, std::sqrt(0.75), 0)};
  EXPECT_NEAR(shape_quality(equilateral, face_plane(equilateral).area), 1.0, 1e-15);
  EXPECT_EQ(shape_quality(equilateral, 0.0), 0.0);
  EXPECT_EQ(shape_quality({Vector3::Zero(), Vector3::Zero(), Vector3::Zero()}, 0.0), 0.0);
}

}  // namespace
}  // namespace curvdecim::test
