// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/geometry/closest_point.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace curvdecim::test {

using namespace detail;

namespace {

const Triangle unit{Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0)};

struct Region {
  const char* name;
  Vector3 point, nearest;
};

void PrintTo(const Region& region, std::ostream* out) { *out << region.name; }

class ClosestPoint : public testing::TestWithParam<Region> {};

TEST_P(ClosestPoint, IsFoundInEveryRegion) {
  const Vector3 found = at(unit, closest_point(unit, GetParam().point));
  EXPECT_LT((found - GetParam().nearest).norm(), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Regions, ClosestPoint,
                         testing::Values(Region{"Inside", {0.2, 0.3, 7}, {0.2, 0.3, 0}},
                                         Region{"FirstCorner", {-1, -1, 1}, {0, 0, 0}},
                                         Region{"SecondCorner", {3, -1, 1}, {1, 0, 0}},
                                         Region{"ThirdCorner", {-1, 3, 1}, {0, 1, 0}},
                                         Region{"FirstEdge", {0.4, -2, 0}, {0.4, 0, 0}},
                                         Region{"SecondEdge", {1, 1, -3}, {0.5, 0.5, 0}},
                                         Region{"ThirdEdge", {-2, 0.6, 0}, {0, 0.6, 0}},
                                         Region{"OnACorner", {1, 0, 0}, {1, 0, 0}}),
                         [](const testing::TestParamInfo<Region>& region) {
                           return std::string(region.param.name);
                         });

TEST(ClosestPointOf, ATriangleTellsOnWhichEdgeOrCornerItIs) {
  const Triangle t{Vector3(0.1, 0.2, 0.3), Vector3(1.7, 0.3, 0.1), Vector3(0.7, 1.9, 0.2)};
  const auto not_zero = [&](const Vector3& p) {
    const Barycentric w = closest_point(t, p);
    return std::array<bool, 3>{w[0] != 0.0, w[1] != 0.0, w[2] != 0.0};
  };
  EXPECT_EQ(not_zero({0.8, 0.8, 3.0}), (std::array{true, true, true}));
  EXPECT_EQ(not_zero({0.9, -2.0, 0.5}), (std::array{true, true, false}));
  EXPECT_EQ(not_zero({5.0, -0.7, 0.3}), (std::array{false, true, false}));
}

TEST(ClosestPointOf, ATriangleWithoutAreaIsOnItsLongestEdge) {
  const Triangle line{Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(3, 0, 0)};
  EXPECT_LT((at(line, closest_point(line, {2, 5, 0})) - Vector3(2, 0, 0)).norm(), 1e-15);
}

TEST(ClosestPointOf, ATriangleInOnePointIsThatPoint) {
  const Triangle point{Vector3(1, 2, 3), Vector3(1, 2, 3), Vector3(1, 2, 3)};
  EXPECT_EQ(at(point, closest_point(point, {7, 7, 7})), Vector3(1, 2, 3));
}

TEST(ClosestPointOf, AnyTriangleIsNearerThanEverySample) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto vector = [&] { return Vector3(number(engine), number(engine), number(engine)); };
  for (int round = 0; round < 200; ++round) {
    const Triangle t{vector(), vector(), vector()};
    const Vector3 p = 2.0 * vector();
    const Barycentric weight = closest_point(t, p);
    EXPECT_NEAR(weight[0] + weight[1] + weight[2], 1.0, 1e-14);
    for (double w : weight) EXPECT_GE(w, 0.0);
    const double found = (at(t, weight) - p).norm();
    constexpr int steps = 12;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const Barycentric sample{double(i) / steps, double(j) / steps,
                                 double(steps - i - j) / steps};
        ASSERT_LE(found, (at(t, sample) - p).norm() + 1e-12);
      }
  }
}

}  // namespace
}  // namespace curvdecim::test
