// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/geometry/convex_polygon.h"

#include <gtest/gtest.h>

namespace curvdecim::test {

using namespace detail;

namespace {

const Triangle right{Vector3(0, 0, 0), Vector3(2, 0, 0), Vector3(0, 2, 0)};

TEST(ConvexPolygon, KeepsWhatLiesInAHalfSpace) {
  const HalfSpace beyond{Vector3(1, 0, 0), 1.0};
  const ConvexPolygon whole(right), tip = whole.inside(beyond);
  EXPECT_EQ(tip.size(), 3);
  EXPECT_DOUBLE_EQ(tip.area(), 0.5);
  EXPECT_EQ(whole.inside(beyond.opposite()).size(), 4);
  EXPECT_DOUBLE_EQ(whole.inside(beyond.opposite()).area(), 1.5);
}

TEST(ConvexPolygon, OfWhichNothingIsInsideIsNone) {
  EXPECT_LT(ConvexPolygon(right).inside({Vector3(1, 0, 0), 3.0}).size(), 3);
}

TEST(ConvexPolygon, OnThePlaneIsOnBothSides) {
  const HalfSpace above{Vector3(0, 0, 1), 0.0};
  EXPECT_DOUBLE_EQ(ConvexPolygon(right).inside(above).area(), 2.0);
  EXPECT_DOUBLE_EQ(ConvexPolygon(right).inside(above.opposite()).area(), 2.0);
}

TEST(ConvexPolygon, IsInsideTheEdgesOfItsTriangle) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(ConvexPolygon(right).inside(inside_of_edge(right, i)).area(), 2.0);
    EXPECT_GT(inside_of_edge(right, i).depth(center_of(right)), 0.0);
  }
}

}  // namespace
}  // namespace curvdecim::test
