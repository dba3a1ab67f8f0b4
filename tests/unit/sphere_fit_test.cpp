// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/geometry/sphere_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace curvdecim::test {

using namespace detail;

namespace {

struct Sample {
  Vector3 point, normal;
  double weight;
};

/// All over a cap of a sphere, seen from the origin, with weights that vary.
std::vector<Sample> cap(const Vector3& centre, double radius, double noise = 0.0) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<Sample> samples;
  for (int i = 0; i < 60; ++i) {
    const Vector3 n = Vector3(number(random), number(random), 2.0).normalized();
    const Vector3 shaken = noise * Vector3(number(random), number(random), number(random));
    samples.push_back({centre + radius * n + shaken, n, 1.5 + number(random)});
  }
  return samples;
}

SphereSums sums_of(const std::vector<Sample>& samples, const Vector3& origin) {
  SphereSums sums;
  for (const Sample& s : samples) sums.add(s.point - origin, s.normal, s.weight);
  return sums;
}

void expect_same(const SphereSums& a, const SphereSums& b, double tolerance) {
  EXPECT_NEAR(a.weight, b.weight, tolerance);
  EXPECT_NEAR((a.point - b.point).norm(), 0.0, tolerance);
  EXPECT_NEAR((a.normal - b.normal).norm(), 0.0, tolerance);
  EXPECT_NEAR(a.point2, b.point2, tolerance);
  EXPECT_NEAR(a.normal_point, b.normal_point, tolerance);
}

TEST(SphereFit, ReproducesASphere) {
  for (double radius : {1e-3, 1.0, 1e3}) {
    const Vector3 centre = radius * Vector3(2, -1, 3);
    const AlgebraicSphere s = sums_of(cap(centre, radius), Vector3::Zero()).fit();
    EXPECT_NEAR(0.5 / s.q / radius, 1.0, 1e-11);
    EXPECT_NEAR((-0.5 / s.q * s.l - centre).norm() / radius, 0.0, 1e-10);
  }
}

/// In a frame of its own; coordinates of a million radii cost six of sixteen digits.
TEST(SphereFit, ReproducesASphereFarFromTheOrigin) {
  const Vector3 centre(1e6, -1e6, 5e5);
  const std::vector<Sample> samples = cap(centre, 1.0);
  const AlgebraicSphere s = sums_of(samples, samples[0].point).fit();
  EXPECT_NEAR(0.5 / s.q, 1.0, 1e-8);
  EXPECT_NEAR((samples[0].point - 0.5 / s.q * s.l - centre).norm(), 0.0, 1e-8);
}

TEST(SphereFit, OfInwardNormalsIsTheSphereTurnedInsideOut) {
  std::vector<Sample> samples = cap({0, 0, 0}, 2.0);
  for (Sample& s : samples) s.normal *= -1.0;
  EXPECT_NEAR(sums_of(samples, Vector3::Zero()).fit().q, -0.25, 1e-12);
}

TEST(SphereFit, ReproducesAPlane) {
  SphereSums sums;
  for (double x : {0.0, 1.0, 2.0})
    for (double y : {0.0, 3.0}) sums.add({x, y, 5.0}, {0, 0, 1}, 1.0 + x);
  const AlgebraicSphere plane = sums.fit();
  EXPECT_NEAR(plane.q, 0.0, 1e-14);
  EXPECT_NEAR(plane.value({7, 7, 5}), 0.0, 1e-12);
  EXPECT_NEAR(plane.value({7, 7, 6}), 1.0, 1e-12);
}

/// Half of its curvature in every direction, and the surface in the mean.
TEST(SphereFit, OfACylinderHasItsMeanCurvature) {
  SphereSums sums;
  constexpr int count = 20;
  for (int i = -count; i <= count; ++i)
    for (int j = -count; j <= count; ++j) {
      const double angle = 0.01 * i, z = 0.01 * j;
      const Vector3 n(std::cos(angle), std::sin(angle), 0.0);
      sums.add(n + Vector3(0, 0, z), n, 1.0);
    }
  const AlgebraicSphere s = sums.with_origin_moved({1, 0, 0}).fit();
  EXPECT_NEAR(2.0 * s.q, 0.5, 0.005);
  EXPECT_NEAR(s.value(Vector3::Zero()), 0.0, 0.01);
}

TEST(SphereFit, StandsNoise) {
  const AlgebraicSphere s = sums_of(cap({1, 2, 3}, 1.0, 0.01), Vector3(1, 2, 4)).fit();
  EXPECT_NEAR(0.5 / s.q, 1.0, 0.03);
  EXPECT_NEAR((Vector3(1, 2, 4) - 0.5 / s.q * s.l - Vector3(1, 2, 3)).norm(), 0.0, 0.03);
}

TEST(SphereFit, OfOnePointIsThePlaneThroughIt) {
  SphereSums sums;
  sums.add({1, 2, 3}, {0, 1, 0}, 0.5);
  sums.add({1, 2, 3}, {0, 1, 0}, 2.0);
  const AlgebraicSphere plane = sums.fit();
  EXPECT_EQ(plane.q, 0.0);
  EXPECT_NEAR(plane.value({9, 2.5, 9}), 0.5, 1e-15);
}

TEST(SphereFit, OfNothingIsNothing) {
  const AlgebraicSphere nothing = SphereSums().fit();
  EXPECT_EQ(nothing.c, 0.0);
  EXPECT_EQ(nothing.l, Vector3::Zero());
  EXPECT_EQ(nothing.q, 0.0);
}

TEST(SphereSums, ShiftedAndMergedEqualThoseFromScratch) {
  const std::vector<Sample> a = cap({0, 0, 0}, 1.0), b = cap({1, 0, 0.2}, 1.5);
  const Vector3 at_a(0, 0, 1), at_b(1, 0, 1.7), x(0.4, 0.1, 1.3);
  SphereSums merged = sums_of(a, at_a).with_origin_moved(x - at_a);
  merged += sums_of(b, at_b).with_origin_moved(x - at_b);
  std::vector<Sample> all = a;
  all.insert(all.end(), b.begin(), b.end());
  expect_same(merged, sums_of(all, x), 1e-11);
}

TEST(SphereSums, ScaleExactlyByPowersOfTwo) {
  std::vector<Sample> samples = cap({1, 2, 3}, 1.0);
  const AlgebraicSphere s = sums_of(samples, {1, 2, 4}).fit();
  for (Sample& each : samples) each.point *= 1024.0;
  const AlgebraicSphere scaled = sums_of(samples, 1024.0 * Vector3(1, 2, 4)).fit();
  EXPECT_EQ(scaled.c, 1024.0 * s.c);
  EXPECT_EQ(scaled.l, s.l);
  EXPECT_EQ(scaled.q, s.q / 1024.0);
}

TEST(SphereSums, HaveNoDoubtOfASphere) {
  EXPECT_NEAR(sums_of(cap({1, 2, 3}, 1.0), {1, 2, 4}).doubt(), 0.0, 1e-12);
}

/// A saddle has the curvatures k and -k and the mean 0: k r turns the normal, k r^2 / 2 lifts it.
TEST(SphereSums, DoubtOfASaddleGrowsWithTheFourthPowerOfItsSize) {
  const auto doubt = [](double size) {
    SphereSums sums;
    for (int i = -10; i <= 10; ++i)
      for (int j = -10; j <= 10; ++j) {
        const double x = 0.1 * size * i, y = 0.1 * size * j;
        sums.add({x, y, 0.5 * (x * x - y * y)}, Vector3(-x, y, 1).normalized(), 1.0);
      }
    return sums.doubt();
  };
  EXPECT_NEAR(doubt(0.02) / doubt(0.01), 16.0, 0.1);
  EXPECT_GT(std::sqrt(doubt(0.01)), 0.1 * 0.5 * 0.01 * 0.01);
  EXPECT_LT(std::sqrt(doubt(0.01)), 2.0 * 0.5 * 0.01 * 0.01);
}

}  // namespace
}  // namespace curvdecim::test
