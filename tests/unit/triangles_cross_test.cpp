// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/geometry/triangles_cross.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace curvdecim::test {

using namespace detail;

namespace {

const Triangle base = {Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(0, 4, 0)};

Triangle changed(Triangle t, double factor, const Vector3& step) {
  for (Vector3& p : t) p = factor * (p + step);
  return t;
}

Triangle turned(const Triangle& t, int by) { return {t[by % 3], t[(by + 1) % 3], t[(by + 2) % 3]}; }

/// The answer, which is the same in any order, at any corner, at any size and place.
bool cross(const Triangle& s, const Triangle& t) {
  const bool answer = triangles_cross(s, t);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(triangles_cross(turned(s, i), turned(t, k)), answer) << i << ' ' << k;
      EXPECT_EQ(triangles_cross(turned(t, k), turned(s, i)), answer) << i << ' ' << k;
    }
  const Triangle back = {s[0], s[2], s[1]};
  EXPECT_EQ(triangles_cross(back, t), answer);
  for (int power : {-60, -3, 1, 40})
    for (const Vector3& step : {Vector3(0, 0, 0), Vector3(1, -2, 8)})
      EXPECT_EQ(triangles_cross(changed(s, std::ldexp(1.0, power), step),
                                changed(t, std::ldexp(1.0, power), step)),
                answer);
  return answer;
}

TEST(TrianglesCross, WhereAnEdgeGoesThrough) {
  EXPECT_TRUE(cross(base, {Vector3(1, 1, -1), Vector3(1, 1, 1), Vector3(9, 9, 1)}));
  EXPECT_TRUE(cross(base, {Vector3(1, 1, -1), Vector3(2, 1, -1), Vector3(1, 1, 1)}));
  EXPECT_FALSE(cross(base, {Vector3(3, 3, -1), Vector3(3, 3, 1), Vector3(9, 9, 1)}));
  EXPECT_FALSE(cross(base, {Vector3(1, 1, 1), Vector3(2, 1, 1), Vector3(1, 2, 2)}));
  EXPECT_FALSE(cross(base, {Vector3(5, 5, -1), Vector3(5, 5, 1), Vector3(6, 6, 0)}));
}

/// Both planes part the other triangle, but not in the same place.
TEST(TrianglesCross, NotWhereTheyPassEachOtherOnOneLine) {
  EXPECT_FALSE(cross(base, {Vector3(6, 1, -1), Vector3(6, 1, 1), Vector3(8, 1, 1)}));
  EXPECT_TRUE(cross(base, {Vector3(2, 1, -1), Vector3(2, 1, 1), Vector3(8, 1, 1)}));
}

TEST(TrianglesCross, WhereTheyTouch) {
  EXPECT_TRUE(cross(base, {Vector3(1, 1, 0), Vector3(1, 1, 1), Vector3(2, 1, 1)}));
  EXPECT_TRUE(cross(base, {Vector3(1, 0, 0), Vector3(1, -1, 1), Vector3(2, -1, 1)}));
  EXPECT_TRUE(cross(base, {Vector3(1, 1, 0), Vector3(2, 1, 0), Vector3(2, 1, 1)}));
  EXPECT_FALSE(cross(base, {Vector3(1, -1, 0), Vector3(2, -1, 0), Vector3(2, -1, 1)}));
}

TEST(TrianglesCross, WhereTheyOverlapInAPlane) {
  EXPECT_TRUE(cross(base, {Vector3(1, 1, 0), Vector3(2, 1, 0), Vector3(1, 2, 0)}));
  EXPECT_TRUE(cross(base, {Vector3(3, 3, 0), Vector3(-1, 1, 0), Vector3(1, -1, 0)}));
  EXPECT_FALSE(cross(base, {Vector3(3, 3, 0), Vector3(5, 3, 0), Vector3(3, 5, 0)}));
  EXPECT_FALSE(cross(base, {Vector3(1, 1, 1), Vector3(2, 1, 1), Vector3(1, 2, 1)}));
}

/// In one plane but for rounding, which here has one corner on a side and the others on none.
TEST(TrianglesCross, NotWhereTheyAreApartInAboutOnePlane) {
  const Vector3 u(0.1, 0.7, 0.3), v(0.6, -0.2, 0.1), p(0.3, 0.1, 0.9);
  const auto at = [&](double s, double t) { return Vector3(p + s * u + t * v); };
  for (double s : {0.1, 1.0 / 3.0, 0.7})
    for (double t : {0.3, 1.1, 7.0 / 9.0}) {
      const Triangle one = {at(0, 0), at(s, 0), at(0, t)};
      EXPECT_FALSE(triangles_cross(one, {at(s, t), at(1.3 * s, t), at(s, 1.7 * t)}));
      EXPECT_FALSE(triangles_cross({at(s, t), at(1.3 * s, t), at(s, 1.7 * t)}, one));
      EXPECT_TRUE(triangles_cross(one, {at(0.3 * s, 0.2 * t), at(s, t), at(0.1 * s, t)}));
    }
}

/// The plane is turned by so little that only some signs are beyond rounding.
TEST(TrianglesCross, NotWhereTheyShareACornerInAboutOnePlane) {
  const auto at = [](double y, double z) { return Vector3(1.836970198721030e-16 * y, y, z); };
  const Triangle one = {at(-0.5, 0.375), at(-0.625, 0.25), at(-0.6875, 0.53125)};
  const Triangle other = {at(-0.5, 0.5625), at(-0.6875, 0.53125), at(-0.625, 0.625)};
  EXPECT_FALSE(triangles_cross(one, other));
  EXPECT_FALSE(triangles_cross(other, one));
}

TEST(TrianglesCross, NotAtACornerThatTheyShare) {
  EXPECT_FALSE(cross(base, {Vector3(0, 0, 0), Vector3(-1, 0, 1), Vector3(0, -1, 1)}));
  EXPECT_FALSE(cross(base, {Vector3(0, 0, 0), Vector3(-4, 0, 0), Vector3(0, -4, 0)}));
  EXPECT_FALSE(cross(base, {Vector3(0, 0, 0), Vector3(-4, 0, 0), Vector3(-1, 4, 0)}));
}

TEST(TrianglesCross, BeyondACornerThatTheyShare) {
  EXPECT_TRUE(cross(base, {Vector3(0, 0, 0), Vector3(1, 1, -1), Vector3(1, 1, 1)}));
  EXPECT_TRUE(cross(base, {Vector3(0, 0, 0), Vector3(9, 9, -1), Vector3(9, 9, 1)}));
  EXPECT_TRUE(cross(base, {Vector3(0, 0, 0), Vector3(3, 1, 0), Vector3(9, -1, 0)}));
  EXPECT_TRUE(cross(base, {Vector3(0, 0, 0), Vector3(2, 0, 0), Vector3(2, -1, 1)}));
}

TEST(TrianglesCross, WhereOneIsFoldedOntoTheOtherAtAnEdge) {
  EXPECT_TRUE(cross(base, {Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(1, 1, 0)}));
  EXPECT_FALSE(cross(base, {Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(1, -1, 0)}));
  EXPECT_FALSE(cross(base, {Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(1, 1, 0.125)}));
  EXPECT_TRUE(cross(base, base));
}

TEST(TrianglesCross, WhereOneHasNoArea) {
  EXPECT_TRUE(cross(base, {Vector3(1, 1, -1), Vector3(1, 1, 1), Vector3(1, 1, 3)}));
  EXPECT_FALSE(cross(base, {Vector3(5, 5, -1), Vector3(5, 5, 1), Vector3(5, 5, 3)}));
  EXPECT_FALSE(cross(base, {Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(2, 0, 0)}));
}

/// Reaches through the base, and past its edge, by this much.
Triangle pin(double depth, double past_edge) {
  return {Vector3(1, past_edge, -depth), Vector3(1, past_edge, 1), Vector3(2, 1, 1)};
}

bool cross_deeper(const Triangle& s, const Triangle& t) {
  constexpr double depth = 0.01;
  const bool answer = triangles_cross_deeper(depth, s, t);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(triangles_cross_deeper(depth, turned(s, i), turned(t, k)), answer);
      EXPECT_EQ(triangles_cross_deeper(depth, turned(t, k), turned(s, i)), answer);
    }
  return answer;
}

TEST(TrianglesCrossDeeper, WhereOneGoesFurtherThroughTheOther) {
  EXPECT_TRUE(cross_deeper(base, pin(0.011, 1.0)));
  EXPECT_FALSE(cross_deeper(base, pin(0.009, 1.0)));
  EXPECT_TRUE(cross_deeper(base, {Vector3(0, 0, 0), Vector3(1, 1, -1), Vector3(1, 1, 1)}));
}

/// As the corner of a face that only lies on another one's edge, but for rounding.
TEST(TrianglesCrossDeeper, NotWhereItIsAtTheOthersEdge) {
  EXPECT_TRUE(cross_deeper(base, pin(0.011, 0.011)));
  const Triangle upright = {Vector3(1, 0.009, -1), Vector3(1, 0.009, 1), Vector3(1, -1, 1)};
  EXPECT_FALSE(cross_deeper(base, upright));
  EXPECT_TRUE(triangles_cross(base, upright));
}

TEST(TrianglesCrossDeeper, NotWhereTheyOverlapInAPlaneOrShareAnEdge) {
  EXPECT_FALSE(cross_deeper(base, {Vector3(1, 1, 0), Vector3(2, 1, 0), Vector3(1, 2, 0)}));
  EXPECT_FALSE(cross_deeper(base, {Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(1, 1, 0)}));
  EXPECT_FALSE(cross_deeper(base, base));
}

TEST(OrientedPlane, HasNoSideWhereRoundingCouldTurnIt) {
  const Vector3 a(0.1, 0.2, 0.3), b(0.7, 0.2, 0.4), c(0.3, 0.9, 0.5);
  const Vector3 inside = (a + b + c) / 3.0, normal = (b - a).cross(c - a);
  const OrientedPlane plane(a, b, c);
  EXPECT_EQ(plane.side(inside), 0);
  EXPECT_EQ(plane.side(inside + 1e-14 * normal), 1);
  EXPECT_EQ(plane.side(inside - 1e-14 * normal), -1);
}

}  // namespace
}  // namespace curvdecim::test
