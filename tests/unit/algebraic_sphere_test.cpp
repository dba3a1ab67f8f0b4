// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/geometry/algebraic_sphere.h"

#include <gtest/gtest.h>

#include <cmath>

namespace curvdecim::test {

using namespace detail;

namespace {

/// Seen from the origin.
AlgebraicSphere sphere_around(const Vector3& centre, double radius) {
  const double q = 0.5 / radius;
  return {q * (centre.squaredNorm() - radius * radius), -2.0 * q * centre, q};
}

const Vector3 centre(3, -2, 5);
constexpr double radius = 0.7;
const Vector3 sideways = Vector3(1, 2, -2) / 3.0;

TEST(AlgebraicSphere, IsZeroOnTheSurfaceAndADistanceNearIt) {
  const AlgebraicSphere s = sphere_around(centre, radius);
  EXPECT_NEAR(s.value(centre + radius * sideways), 0.0, 1e-13);
  EXPECT_NEAR(s.gradient(centre + radius * sideways).norm(), 1.0, 1e-13);
  for (double near : {-1e-4, 1e-4})
    EXPECT_NEAR(s.value(centre + (radius + near) * sideways), near, near * near);
}

TEST(AlgebraicSphere, NormalisedHasTheSameSurfaceAndAGradientOfLengthOne) {
  const AlgebraicSphere s = sphere_around(centre, radius);
  for (double factor : {1e-9, 1.0, 1e9}) {
    const AlgebraicSphere n = (s * factor).normalised();
    EXPECT_NEAR(n.q, s.q, 1e-12);
    EXPECT_NEAR(n.pratt_norm2(), 1.0, 1e-12);
  }
}

TEST(AlgebraicSphere, WithoutRealPointsIsNormalisedAtTheOrigin) {
  const AlgebraicSphere none{1.0, {0.5, 0, 0}, 1.0};
  ASSERT_LT(none.pratt_norm2(), 0.0);
  EXPECT_DOUBLE_EQ(none.normalised().l.norm(), 1.0);
}

TEST(AlgebraicSphere, ThatIsConstantNormalisesToNothing) {
  const AlgebraicSphere nothing = AlgebraicSphere{2.0, Vector3::Zero(), 0.0}.normalised();
  EXPECT_EQ(nothing.c, 0.0);
}

TEST(AlgebraicSphere, IsTheSameFunctionFromAnotherOrigin) {
  const AlgebraicSphere s = sphere_around(centre, radius);
  const Vector3 step(0.3, 4, -1), x(-2, 1, 0.5);
  EXPECT_NEAR(s.with_origin_moved(step).value(x - step), s.value(x), 1e-12);
  EXPECT_NEAR((s.with_origin_moved(step).gradient(x - step) - s.gradient(x)).norm(), 0.0, 1e-12);
}

TEST(AlgebraicSphere, ProjectsAlongTheRadiusFromBothSides) {
  const AlgebraicSphere s = sphere_around(centre, radius);
  for (double distance : {0.1, 0.69, 0.7, 3.0, 1e4}) {
    const Vector3 projected = s.project(centre + distance * sideways);
    EXPECT_NEAR((projected - centre - radius * sideways).norm(), 0.0, 1e-11) << distance;
  }
}

TEST(AlgebraicSphere, LeavesItsCentreWhereItIs) {
  const AlgebraicSphere s = sphere_around(Vector3::Zero(), radius);
  EXPECT_EQ(s.project(Vector3::Zero()), Vector3::Zero());
}

TEST(AlgebraicSphere, MayBeAPlane) {
  const AlgebraicSphere plane{-2.0, {0, 0, 1}, 0.0};
  EXPECT_EQ(plane.value({7, 8, 5}), 3.0);
  EXPECT_EQ(plane.project({7, 8, 5}), Vector3(7, 8, 2));
  EXPECT_EQ(plane.normalised().c, -2.0);
}

/// One that grows out of a plane projects like it: nothing is divided by the curvature.
TEST(AlgebraicSphere, ThatIsNearlyAPlaneProjectsLikeOne) {
  const AlgebraicSphere s{-2.0, {0, 0, 1}, 1e-14};
  EXPECT_NEAR((s.project({7, 8, 5}) - Vector3(7, 8, 2)).norm(), 0.0, 1e-11);
}

TEST(Interpolation, OfASphereWithItselfIsThatSphere) {
  const AlgebraicSphere s = sphere_around(centre, radius);
  for (double t : {0.0, 0.2, 0.5, 1.0}) {
    const AlgebraicSphere between = interpolated(s, s, t).normalised();
    EXPECT_NEAR(between.q, s.q, 1e-14);
    EXPECT_NEAR(between.c, s.c, 1e-12);
    EXPECT_NEAR((between.l - s.l).norm(), 0.0, 1e-12);
  }
}

TEST(Interpolation, GivesBothEnds) {
  const AlgebraicSphere a = sphere_around(centre, radius), b = sphere_around({0, 1, 0}, 2.0);
  EXPECT_EQ(interpolated(a, b, 0.0).q, a.q);
  EXPECT_EQ(interpolated(a, b, 1.0).l, b.l);
}

}  // namespace
}  // namespace curvdecim::test
