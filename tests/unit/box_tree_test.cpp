// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/geometry/box_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/probes.h"
#include "vcg_ext/geometry/point_tree.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// Single precision must not hide a face: coordinates that it has no number for, near and far.
TEST(FourBoxes, AreNeverFurtherThanTheyAreAndHardlyNearer) {
  const Vector3 low(-0.1, 0.2, 1e-9), high(0.3, 0.2, 0.7);
  FourBoxes boxes;
  boxes.set(2, Box{low, high});
  for (Vector3 p : probes())
    for (const Vector3& q :
         {p, Vector3(high + 1e-7 * p.cwiseAbs()), Vector3(0.5 * low + 0.5 * p)}) {
      const double distance2 = (low - q).cwiseMax(q - high).cwiseMax(0.0).squaredNorm();
      const FourBoxes::Four found = boxes.distance2(FourBoxes::Place(q));
      EXPECT_LE(found[2], distance2);
      EXPECT_NEAR(std::sqrt(found[2]), std::sqrt(distance2), 1e-6);
      EXPECT_EQ(found[1], std::numeric_limits<float>::infinity());
    }
}

TEST(FourBoxes, HaveABoxAroundThem) {
  FourBoxes boxes, around;
  boxes.set(0, Box{{0.0, 0.1, 0.2}, {0.1, 0.2, 0.3}});
  boxes.set(3, Box{{-0.2, 0.4, 0.25}, {0.0, 0.5, 0.26}});
  around.set(1, boxes);
  const auto distance2 = [&](const Vector3& p) { return around.distance2(FourBoxes::Place(p))[1]; };
  EXPECT_EQ(distance2({-0.2, 0.1, 0.2}), 0.0f);
  EXPECT_EQ(distance2({0.1, 0.5, 0.3}), 0.0f);
  EXPECT_NEAR(distance2({0.2, 0.1, 0.3}), 0.01, 1e-6);
  EXPECT_NEAR(distance2({0.1, 0.1, 0.0}), 0.04, 1e-6);
}

std::vector<Vector3> spiral(int count) {
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(0.4 * std::cos(0.7 * i), 0.4 * std::sin(0.7 * i), 0.5 - i / (1.0 * count));
  return points;
}

TEST(PointTree, FindsTheNearestThatIsAccepted) {
  for (int count : {1, 7, 8, 9, 500}) {
    const std::vector<Vector3> points = spiral(count);
    const PointTree tree(points);
    for (int step : {1, 3})
      for (const Vector3& p : probes()) {
        double least = HUGE_VAL;
        for (int i = 0; i < count; i += step)
          least = std::min(least, (points[i] - p).squaredNorm());
        const int found = tree.nearest(p, [&](int i) { return i % step == 0; });
        ASSERT_NE(found, PointTree::none);
        EXPECT_EQ(found % step, 0);
        EXPECT_EQ((points[found] - p).squaredNorm(), least);
      }
  }
}

TEST(PointTree, FindsNoneWhereNoneIsAccepted) {
  const auto no_point = [](int) { return false; };
  EXPECT_EQ(PointTree(spiral(20)).nearest(Vector3::Zero(), no_point), PointTree::none);
  EXPECT_EQ(PointTree({}).nearest(Vector3::Zero(), [](int) { return true; }), PointTree::none);
}

}  // namespace
}  // namespace curvdecim::test
