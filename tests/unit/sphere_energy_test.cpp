// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/metric/sphere_ring.h"

#include <gtest/gtest.h>

namespace curvdecim::test {

using namespace detail;

namespace {

const AlgebraicSphere sphere{0.3, {0.2, -0.9, 0.4}, 0.35};
const Triangle triangle = {Vector3(0.1, 0.2, -0.3), Vector3(1.4, -0.2, 0.5),
                           Vector3(0.3, 1.1, 0.8)};

/// use(x) at the middles of n^2 equal parts of the triangle, averaged.
template <class Use>
double mean_by_parts(const Triangle& t, int n, Use use) {
  const Vector3 u = (t[1] - t[0]) / n, v = (t[2] - t[0]) / n;
  double sum = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      sum += use(t[0] + (i + 1.0 / 3.0) * u + (j + 1.0 / 3.0) * v);
      if (i + j + 1 < n) sum += use(t[0] + (i + 2.0 / 3.0) * u + (j + 2.0 / 3.0) * v);
    }
  return sum / (n * n);
}

TEST(SphereEnergy, MeanIsThatOfNumericalIntegration) {
  const double mean =
      mean_by_parts(triangle, 400, [](const Vector3& x) { return sphere.value(x); });
  EXPECT_NEAR(mean_over(sphere, triangle), mean, 1e-5);
  EXPECT_GT(std::abs(mean), 0.1);
}

TEST(SphereEnergy, MeanSquareIsThatOfNumericalIntegration) {
  const double mean = mean_by_parts(
      triangle, 400, [](const Vector3& x) { return sphere.value(x) * sphere.value(x); });
  EXPECT_NEAR(mean_square_over(sphere, triangle), mean, 1e-5);
  EXPECT_GT(mean, 0.1);
}

/// The rule has the degree 4: cutting the triangle up changes nothing.
TEST(SphereEnergy, MeanSquareIsExact) {
  const Vector3 ab = 0.5 * (triangle[0] + triangle[1]), bc = 0.5 * (triangle[1] + triangle[2]),
                ca = 0.5 * (triangle[2] + triangle[0]);
  const Triangle parts[] = {
      {triangle[0], ab, ca}, {ab, triangle[1], bc}, {ca, bc, triangle[2]}, {bc, ca, ab}};
  double mean = 0.0;
  for (const Triangle& part : parts) mean += 0.25 * mean_square_over(sphere, part);
  EXPECT_NEAR(mean_square_over(sphere, triangle), mean, 1e-13);
}

TEST(SphereEnergy, OfAPlaneAboveATriangleIsItsHeight) {
  const AlgebraicSphere plane{-2.0, {0, 0, 1}, 0.0};
  const Triangle flat = {Vector3(0, 0, 5), Vector3(2, 0, 5), Vector3(0, 1, 5)};
  EXPECT_DOUBLE_EQ(mean_over(plane, flat), 3.0);
  EXPECT_NEAR(mean_square_over(plane, flat), 9.0, 1e-12);
}

/// Faces on both sides do not cancel, as the printed signed sum would.
TEST(RingEnergy, CountsFacesOnBothSides) {
  const AlgebraicSphere plane{0.0, {0, 0, 1}, 0.0};
  const Triangle above = {Vector3(0, 0, 1), Vector3(2, 0, 1), Vector3(0, 1, 1)},
                 below = {Vector3(0, 0, -1), Vector3(2, 0, -1), Vector3(0, 1, -1)};
  RingEnergy energy;
  energy.add(plane, above), energy.add(plane, below);
  EXPECT_DOUBLE_EQ(energy.area, 2.0);
  EXPECT_DOUBLE_EQ(energy.of(SphereEnergy::Poster), 2.0);
  EXPECT_NEAR(energy.of(SphereEnergy::Squared), 2.0, 1e-12);
}

}  // namespace
}  // namespace curvdecim::test
