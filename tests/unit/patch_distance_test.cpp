// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/guard/patch_distance.h"

#include <gtest/gtest.h>

#include <random>

#include "support/drawn_meshes.h"
#include "support/properties.h"

namespace curvdecim::test {

using namespace detail;

namespace {

using Patch = PatchDistance::Patch;

Patch patch_of(const Shape& shape) {
  Patch patch;
  for (const Corners& face : shape.faces) patch.push_back(corners_of(shape, face));
  return patch;
}

/// A fan of radius 1 around an apex.
Shape fan_around(const Point& apex, int blades = 6) {
  Shape shape = fan(blades);
  shape.vertices[0] = apex;
  return shape;
}

std::optional<double> bound(const Shape& patch, const Shape& fan) {
  return PatchDistance::bound(patch_of(patch), patch_of(fan), fan.vertices[0]);
}

TEST(PatchDistance, OfAFlatPatchIsZero) {
  const auto distance = bound(fan_around({0.2, -0.1, 0}), fan_around({-0.3, 0.2, 0}));
  ASSERT_TRUE(distance.has_value());
  EXPECT_NEAR(*distance, 0.0, 1e-15);
}

TEST(PatchDistance, OfAPatchToItselfIsZero) {
  const Shape cone = fan_around({0.1, 0.2, 0.5});
  EXPECT_EQ(bound(cone, cone), 0.0);
}

TEST(PatchDistance, OfALiftedApexIsItsHeight) {
  for (double height : {1e-6, 0.1, 0.4}) {
    const Shape flat = fan_around({0, 0, 0}), lifted = fan_around({0, 0, height});
    EXPECT_NEAR(bound(flat, lifted).value(), height, 1e-12);
    EXPECT_NEAR(bound(lifted, flat).value(), height, 1e-12);
  }
}

TEST(PatchDistance, DoesNotDependOnTheDirection) {
  const Shape flat = fan_around({0, 0, 0}), lifted = fan_around({0.1, 0, 0.3});
  const double expected = bound(flat, lifted).value();
  for (double angle : {0.4, 1.7, 3.0})
    EXPECT_NEAR(bound(rotated(flat, angle, {1, -2, 3}), rotated(lifted, angle, {1, -2, 3})).value(),
                expected, 1e-12);
}

/// The two roofs over a square agree at all their vertices; they part where their ridges cross.
TEST(PatchDistance, SeesWhereEdgesCross) {
  const Vector3 a(0, 0, 0), b(1, 0, 1), c(1, 1, 0), d(0, 1, 1);
  EXPECT_NEAR(PatchDistance::bound({{a, b, c}, {a, c, d}}, {{b, c, d}, {b, d, a}}, b).value(), 1.0,
              1e-12);
}

TEST(PatchDistance, IsNoneWhereAFaceTurnsAway) {
  EXPECT_FALSE(bound(fan_around({0, 0, 0}), fan_around({1.5, 0, 0})).has_value());
  EXPECT_FALSE(bound(fan_around({1.5, 0, 0.1}), fan_around({0, 0, 0})).has_value());
}

TEST(PatchDistance, IsNoneWhereTheFanGoesAroundTwice) {
  const int blades = 8;
  Shape twice{{Point::Zero()}, {}};
  for (int i = 0; i < blades; ++i) {
    const double angle = 4.0 * M_PI * i / blades;
    twice.vertices.push_back(
        {(1.0 + 0.1 * i) * std::cos(angle), (1.0 + 0.1 * i) * std::sin(angle), 0});
    twice.faces.push_back({0, 1 + i, 1 + (i + 1) % blades});
  }
  EXPECT_FALSE(bound(fan_around({0, 0, 0}), twice).has_value());
}

TEST(PatchDistance, IsNoneWithoutArea) {
  EXPECT_FALSE(bound(scaled(fan(5), 0.0), scaled(fan(5), 0.0)).has_value());
}

TEST(PatchDistance, IsNeverBelowTheMeasuredDistance) {
  std::mt19937 random(3);
  const auto number = [&] { return std::uniform_real_distribution<double>(-0.4, 0.4)(random); };
  int bounded = 0;
  for (int round = 0; round < 300; ++round) {
    Shape patch = fan(7), fan = patch;
    for (int v = 1; v <= 7; ++v) patch.vertices[v].z() = fan.vertices[v].z() = number();
    patch.vertices[0] = {number(), number(), number()};
    fan.vertices[0] = {number(), number(), number()};
    const auto distance = bound(patch, fan);
    if (!distance) continue;
    ++bounded;
    EXPECT_GE(*distance * (1.0 + 1e-12), two_sided_distance(patch, fan));
  }
  EXPECT_GT(bounded, 100);
}

}  // namespace
}  // namespace curvdecim::test
