// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/geometry/morton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace curvdecim::test {

using namespace detail;

namespace {

TEST(Morton, SpreadsEveryBitToEveryThirdPlace) {
  for (int bit = 0; bit < 21; ++bit)
    EXPECT_EQ(spread_bits(std::uint64_t{1} << bit), std::uint64_t{1} << (3 * bit)) << bit;
  EXPECT_EQ(spread_bits(std::uint64_t{1} << 21), 0u);
}

TEST(Morton, RisesWithEveryCoordinate) {
  const Vector3 low(-0.5, -0.5, -0.5);
  EXPECT_EQ(morton_code(low), 0u);
  EXPECT_EQ(morton_code({0.5, 0.5, 0.5}), (std::uint64_t{1} << 63) - 1);
  for (int axis = 0; axis < 3; ++axis)
    for (double step : {1e-6, 0.3, 1.0})
      EXPECT_GT(morton_code(low + step * Vector3::Unit(axis)), 0u) << axis << ' ' << step;
}

TEST(Morton, TellsTheAxesApart) {
  const Vector3 low(-0.5, -0.5, -0.5);
  EXPECT_LT(morton_code(low + 0.5 * Vector3::UnitX()), morton_code(low + 0.5 * Vector3::UnitY()));
  EXPECT_LT(morton_code(low + 0.5 * Vector3::UnitY()), morton_code(low + 0.5 * Vector3::UnitZ()));
}

/// In a lattice of 8 x 8 x 8 points, each run of 8 in the order of the curve is a cube of 2 x 2
/// x 2.
TEST(Morton, WhatIsNearOnTheCurveIsNearInSpace) {
  constexpr int side = 8;
  std::vector<Vector3> points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z)
        points.push_back((Vector3(x, y, z) + Vector3::Constant(0.5)) / side -
                         Vector3::Constant(0.5));
  std::sort(points.begin(), points.end(),
            [](const Vector3& p, const Vector3& q) { return morton_code(p) < morton_code(q); });
  for (std::size_t run = 0; run < points.size(); run += 8) {
    Vector3 low = points[run], high = low;
    for (std::size_t i = run; i < run + 8; ++i)
      low = low.cwiseMin(points[i]), high = high.cwiseMax(points[i]);
    EXPECT_NEAR((high - low).maxCoeff(), 1.0 / side, 1e-12) << run;
  }
}

}  // namespace
}  // namespace curvdecim::test
