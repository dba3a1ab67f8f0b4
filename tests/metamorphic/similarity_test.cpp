// SPDX-License-Identifier: GPL-3.0-or-later
// What must not matter: the unit of length, the place, the direction, the order, the history, the
// number of threads.
#include <gtest/gtest.h>

#include <cmath>

#include "support/decimation.h"
#include "support/mesh_group.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

std::vector<NamedShape> samples() {
  return {{"noisy_sphere", noisy_sphere(3, 0.02)},
          {"bumpy_sphere", bumpy_sphere(3)},
          {"saddle", saddle(16)},
          {"capped_cylinder", capped_cylinder(24, 8)},
          {"two_components", large_and_small_sphere()}};
}

class Similarity : public testing::TestWithParam<NamedShape> {
 protected:
  const Shape& shape() const { return GetParam().shape; }
  EdgeCollapseParams params() const { return to_faces(shape().face_count() / 4); }
  double rms(const Shape& original) const {
    return two_sided_rms(original, decimated(original, params()).shape);
  }

  /// Below it an error is none.
  double nothing() const { return 2e-5 * diagonal(shape()); }

  /// `moved` is the shape under a similarity of this scale; part: of the error, that it may differ.
  void expect_same_error(const Shape& moved, double scale, double part) const {
    const Shape after = decimated(moved, params()).shape;
    EXPECT_LE(after.face_count(), params().target_faces);
    EXPECT_GE(after.face_count(), params().target_faces - 1);
    EXPECT_NEAR(two_sided_rms(moved, after) / scale, rms(shape()), nothing() + part * rms(shape()));
  }

  /// A result of some hundred faces varies by a few per cent with the order of the vertices, which
  /// follows their place: each single collapse shows. On a larger mesh they even out.
  static constexpr double tolerance = 0.1;
};

TEST_P(Similarity, ScalingByAPowerOfTwoScalesTheBits) {
  for (const Variant& variant : all_variants()) {
    SCOPED_TRACE(variant.name);
    const AnyParams params = variant.with_target(shape().face_count() / 4);
    const Shape expected = decimated(shape(), params).shape;
    for (int exponent : {-60, -7, 1, 60}) {
      const double factor = std::ldexp(1.0, exponent);
      EXPECT_EQ(decimated(scaled(shape(), factor), params).shape, scaled(expected, factor))
          << "2^" << exponent;
    }
  }
}

TEST_P(Similarity, ScalingByAPowerOfTwoScalesTheBitsInSinglePrecision) {
  const Shape expected = decimated_float(shape(), params()).shape;
  for (int exponent = -60; exponent <= 60; exponent += 12) {
    const double factor = std::ldexp(1.0, exponent);
    EXPECT_EQ(decimated_float(scaled(shape(), factor), params()).shape, scaled(expected, factor))
        << "2^" << exponent;
  }
}

TEST_P(Similarity, ScalingByAPowerOfTwoLeavesTheReport) {
  const DecimationReport expected = decimated(shape(), params()).report;
  const DecimationReport report = decimated(scaled(shape(), std::ldexp(1.0, 31)), params()).report;
  EXPECT_EQ(report.cost_last, expected.cost_last);
  EXPECT_EQ(report.rejected, expected.rejected);
}

TEST_P(Similarity, ScalingByAnyFactorGivesTheSameError) {
  for (double factor : {1e-4, 1000.0 / 3.0})
    expect_same_error(scaled(shape(), factor), factor, tolerance);
}

TEST_P(Similarity, FarFromTheOriginItHasTheSameCountAndError) {
  expect_same_error(translated(shape(), {1e7, -1e7, 1e7}), 1.0, tolerance);
}

TEST_P(Similarity, TurnedItHasTheSameCountAndError) {
  for (double angle : {0.3, 1.9})
    expect_same_error(rotated(shape(), angle, {1, -2, 0.5}), 1.0, tolerance);
}

TEST_P(Similarity, RenumberedItKeepsItsProperties) {
  for (unsigned seed : {1u, 2u, 3u}) {
    const Shape other = renumbered(shape(), seed);
    const Shape after = decimated(other, params()).shape;
    EXPECT_PRED2(keeps_topology, topology(shape()), topology(after));
    EXPECT_EQ(flipped_faces(shape(), after), 0);
    expect_same_error(other, 1.0, 0.25);  // the order may decide which of many good ways is taken
  }
}

TEST_P(Similarity, SinglePrecisionGivesTheSameError) {
  const Shape after = decimated_float(shape(), params()).shape;
  EXPECT_EQ(after.face_count(), decimated(shape(), params()).shape.face_count());
  EXPECT_NEAR(two_sided_rms(shape(), after), rms(shape()), nothing() + 0.05 * rms(shape()));
}

TEST_P(Similarity, OtherCallsInBetweenDoNotMatter) {
  const Shape expected = decimated(shape(), params()).shape;
  for (const Variant& variant : all_variants()) decimated(icosphere(1), variant.with_target(20));
  EXPECT_EQ(decimated(shape(), params()).shape, expected);
}

INSTANTIATE_TEST_SUITE_P(Drawn, Similarity, testing::ValuesIn(samples()), name_of);

TEST(LargeMesh, TurnedOrMovedAwayHasTheSameError) {
  const Shape sphere = noisy_sphere(5, 0.01);
  const EdgeCollapseParams params = to_faces(sphere.face_count() / 4);
  const double rms = two_sided_rms(sphere, decimated(sphere, params).shape);
  for (const Shape& moved : {rotated(sphere, 0.3, {1, -2, 0.5}), rotated(sphere, 1.9, {1, -2, 0.5}),
                             translated(sphere, {1e7, -1e7, 1e7})}) {
    const Shape after = decimated(moved, params).shape;
    EXPECT_EQ(after.face_count(), params.target_faces);
    EXPECT_NEAR(two_sided_rms(moved, after), rms, 0.03 * rms);
  }
}

TEST(Threads, DoNotShowInTheResult) {
  const Shape sphere = noisy_sphere(5, 0.01);  // large enough to be divided
  for (Metric metric : {Metric::Quadric, Metric::CurvatureWeighted, Metric::CurvatureAdditive})
    for (Preset preset : {Preset::Fast, Preset::Balanced, Preset::Best}) {
      EdgeCollapseParams params = to_faces(4000);
      params.metric = metric, params.preset = preset;
      params.threads = 1;
      const Shape expected = decimated(sphere, params).shape;
      for (int threads : {0, 2, 4}) {
        params.threads = threads;
        EXPECT_EQ(decimated(sphere, params).shape, expected) << threads << " threads";
      }
    }
}

TEST(Threads, DoNotShowInTheResultOfSpheres) {
  const Shape sphere = noisy_sphere(5, 0.01);
  for (const Variant& variant : sphere_variants()) {
    SCOPED_TRACE(variant.name);
    AnyParams params = variant.with_target(4000);
    shared(params).threads = 1;
    const Shape expected = decimated(sphere, params).shape;
    for (int threads : {0, 2, 4}) {
      shared(params).threads = threads;
      EXPECT_EQ(decimated(sphere, params).shape, expected) << threads << " threads";
    }
  }
}

TEST(TwoSteps, KeepTheTopologyLikeOne) {
  const Shape half = decimated(torus(32, 16), to_faces(512)).shape;
  EXPECT_PRED2(keeps_topology, topology(torus(32, 16)),
               topology(decimated(half, to_faces(128)).shape));
}

}  // namespace
}  // namespace curvdecim::test
