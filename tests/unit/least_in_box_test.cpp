// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/clustering/least_in_box.h"

#include <gtest/gtest.h>

#include <random>

#include "vcg_ext/geometry/quadric.h"

namespace curvdecim::detail {

namespace {

const Vector3 low(-1, -1, -1), high(1, 1, 1);

/// A positive definite quadric.
Quadric random_quadric(std::mt19937& random) {
  const auto number = [&] { return 2.0 * random() / 4294967295.0 - 1.0; };
  Quadric q;
  for (int i = 0; i < 4; ++i)
    q += Quadric::plane(Vector3(number(), number(), number()).normalized(), 3.0 * number(), 1.0);
  q.a = q.a.plus_diagonal(0.01);
  return q;
}

Vector3 least(const Quadric& q) {
  return LeastInBox(q.a, q.b, low, high).from(Vector3(0.1, -0.2, 0.3));
}

TEST(LeastInBox, StaysAtAMinimumInside) {
  Quadric q = Quadric::plane({1, 0, 0}, 0.5, 1.0);
  q += Quadric::plane({0, 1, 0}, -0.25, 2.0);
  q += Quadric::plane({0, 0, 1}, 0.125, 3.0);
  EXPECT_LT((least(q) - Vector3(0.5, -0.25, 0.125)).norm(), 1e-14);
}

TEST(LeastInBox, GoesAlongTheSideItMeets) {
  Quadric q = Quadric::plane(Vector3(1, 1, 0).normalized(), 2.0, 1.0);  // x + y = 2.83
  q += Quadric::plane({0, 0, 1}, 0.5, 1.0);
  q += Quadric::plane(Vector3(1, -1, 0).normalized(), 0.0, 0.1);
  const Vector3 x = least(q);
  EXPECT_LT((x - Vector3(1, 1, 0.5)).norm(), 1e-14);
}

TEST(LeastInBox, IsTheLeastOfTheBox) {
  std::mt19937 random(1);
  int outside = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Quadric q = random_quadric(random);
    const Vector3 free = -Factorization3(q.a).solve(q.b), x = least(q);
    ASSERT_EQ(x.cwiseMax(low).cwiseMin(high), x);
    outside += free.cwiseMax(low).cwiseMin(high) != free;
    constexpr int steps = 8;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j)
        for (int k = 0; k <= steps; ++k)
          ASSERT_LE(q.value(x), q.value(Vector3(i, j, k) * (2.0 / steps) - high) + 1e-12);
  }
  EXPECT_GT(outside, 100);
}

TEST(LeastInBox, DoesNotDependOnTheStart) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 300; ++trial) {
    const Quadric q = random_quadric(random);
    const auto from = [&](const Vector3& x) { return LeastInBox(q.a, q.b, low, high).from(x); };
    for (const Vector3& start : {low, high, Vector3(1, -1, 0)})
      EXPECT_LT((from(start) - least(q)).norm(), 1e-9);
  }
}

TEST(PartInside, IsTheWholeWayOrUpToTheSide) {
  EXPECT_EQ(part_inside({0, 0, 0}, {0.5, 1, -1}, low, high), 1.0);
  EXPECT_EQ(part_inside({0, 0, 0}, {4, 2, 0}, low, high), 0.25);
  EXPECT_EQ(part_inside({0, 1, 0}, {0, 3, 0}, low, high), 0.0);
}

}  // namespace
}  // namespace curvdecim::detail
