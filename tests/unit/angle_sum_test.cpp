// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/geometry/angle_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace curvdecim::detail {
namespace {

double sum_of(const std::vector<double>& angles, double size = 1.0) {
  AngleSum sum;
  for (double angle : angles) sum.add(size * std::cos(angle), size * std::sin(angle));
  return sum.value();
}

TEST(AngleSum, IsThatOfTheAngles) {
  for (int turns = 1; turns < 40; ++turns) {
    std::vector<double> angles;
    double expected = 0.0;
    for (int i = 0; i < turns; ++i) {
      angles.push_back(std::fmod(0.37 + 1.9 * i, M_PI));
      expected += angles.back();
      ASSERT_NEAR(sum_of(angles), expected, 1e-14 * (i + 1));
      ASSERT_NEAR(sum_of(angles, 1e-30), expected, 1e-14 * (i + 1));
    }
  }
}

TEST(AngleSum, TellsNoneFromAWholeTurn) {
  EXPECT_EQ(sum_of({}), 0.0);
  EXPECT_NEAR(sum_of(std::vector<double>(6, M_PI / 3.0)), 2.0 * M_PI, 1e-15 * 6);
  EXPECT_NEAR(sum_of(std::vector<double>(6, M_PI / 3.0 - 1e-9)), 2.0 * M_PI - 6e-9, 1e-15 * 6);
  EXPECT_NEAR(sum_of(std::vector<double>(6, M_PI / 3.0 + 1e-9)), 2.0 * M_PI + 6e-9, 1e-15 * 6);
}

TEST(AngleSum, CountsHalfTurns) {
  AngleSum sum;
  for (int i = 1; i < 6; ++i) {
    sum.add(-2.0, 0.0);
    EXPECT_DOUBLE_EQ(sum.value(), i * M_PI);
  }
}

TEST(AngleSum, TakesTheEnds) {
  AngleSum sum;
  sum.add(0.0, 0.0);
  EXPECT_EQ(sum.value(), 0.0);
  sum.add(1.0, 0.0);
  EXPECT_EQ(sum.value(), 0.0);
  sum.add(std::numeric_limits<double>::min(), std::numeric_limits<double>::min());
  EXPECT_NEAR(sum.value(), M_PI / 4.0, 1e-15);
  for (int i = 0; i < 5000; ++i) sum.add(1.0, 1.0);  // a hub
  EXPECT_NEAR(sum.value(), 5001.0 * M_PI / 4.0, 1e-9);
}

}  // namespace
}  // namespace curvdecim::detail
