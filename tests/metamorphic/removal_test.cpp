// SPDX-License-Identifier: GPL-3.0-or-later
// What must not matter for vertex removal: the unit of length, the place, the direction, the order,
// the threads.
#include <gtest/gtest.h>

#include <cmath>

#include "support/mesh_group.h"
#include "support/properties.h"
#include "support/removal.h"

namespace curvdecim::test {
namespace {

std::vector<NamedShape> samples() {
  return {{"noisy_sphere", noisy_sphere(4, 0.02)},
          {"bumpy_sphere", bumpy_sphere(4)},
          {"saddle", saddle(24)},
          {"capped_cylinder", capped_cylinder(32, 12)},
          {"two_components", large_and_small_sphere()}};
}

class RemovalSimilarity : public testing::TestWithParam<NamedShape> {
 protected:
  const Shape& shape() const { return GetParam().shape; }
  VertexRemovalParams params() const { return removal_to(shape().face_count() / 4); }

  /// `moved` is the shape under a similarity of this scale.
  void expect_same_error(const Shape& moved, double scale) const {
    const auto rms = [this](const Shape& of) {
      return two_sided_rms(of, thinned(of, params()).shape);
    };
    const double nothing = 2e-5 * diagonal(shape());
    EXPECT_NEAR(rms(moved) / scale, rms(shape()), nothing + 0.15 * rms(shape()));
    EXPECT_EQ(thinned(moved, params()).report.stopped_by, StopReason::Target);
  }
};

TEST_P(RemovalSimilarity, ScalingByAPowerOfTwoScalesTheBits) {
  for (const RemovalVariant& variant : removal_variants()) {
    const auto [expected, report] = thinned(shape(), variant.of(params()));
    const Shape single = thinned_float(shape(), variant.of(params())).shape;
    for (int exponent : {-60, -7, 1, 60}) {
      SCOPED_TRACE(variant.name + " 2^" + std::to_string(exponent));
      const double factor = std::ldexp(1.0, exponent);
      const Thinned large = thinned(scaled(shape(), factor), variant.of(params()));
      EXPECT_EQ(large.shape, scaled(expected, factor));
      EXPECT_EQ(large.report.max_error, factor * report.max_error);
      EXPECT_EQ(large.report.cost_last, report.cost_last);
      EXPECT_EQ(large.report.rejected, report.rejected);
      EXPECT_EQ(thinned_float(scaled(shape(), factor), variant.of(params())).shape,
                scaled(single, factor));
    }
  }
}

TEST_P(RemovalSimilarity, ABoundScalesWithTheMesh) {
  const double bound = 0.01 * diagonal(shape());
  const Shape expected = thinned(shape(), removal_within(bound)).shape;
  for (double factor : {std::ldexp(1.0, -30), std::ldexp(1.0, 30)})
    EXPECT_EQ(thinned(scaled(shape(), factor), removal_within(factor * bound)).shape,
              scaled(expected, factor));
}

TEST_P(RemovalSimilarity, ScalingByAnyFactorGivesTheSameError) {
  expect_same_error(scaled(shape(), 1000.0 / 3.0), 1000.0 / 3.0);
}

TEST_P(RemovalSimilarity, TurnedOrMovedItHasTheSameError) {
  expect_same_error(rotated(shape(), 0.3, {1, -2, 0.5}), 1.0);
  expect_same_error(rotated(shape(), 1.9, {1, -2, 0.5}), 1.0);
  expect_same_error(translated(shape(), {1e7, -1e7, 1e7}), 1.0);
}

TEST_P(RemovalSimilarity, RenumberedItKeepsItsProperties) {
  for (unsigned seed : {1u, 2u, 3u}) {
    const Shape other = renumbered(shape(), seed);
    const Shape after = thinned(other, params()).shape;
    EXPECT_PRED2(keeps_topology, topology(shape()), topology(after));
    EXPECT_EQ(flipped_faces(shape(), after), 0);
    expect_same_error(other, 1.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, RemovalSimilarity, testing::ValuesIn(samples()), name_of);

TEST(RemovalThreads, DoNotShowInTheResult) {
  const Shape sphere = noisy_sphere(5, 0.01);  // large enough to be divided
  for (const RemovalVariant& variant : removal_variants()) {
    VertexRemovalParams params = variant.of(removal_to(4000));
    params.threads = 1;
    const Shape expected = thinned(sphere, params).shape;
    for (int threads : {0, 2, 4}) {
      params.threads = threads;
      EXPECT_EQ(thinned(sphere, params).shape, expected) << variant.name << threads;
    }
  }
}

TEST(RemovalHistory, DoesNotMatter) {
  const Shape expected = thinned(bumpy_sphere(3), removal_to(300)).shape;
  for (const RemovalVariant& variant : removal_variants())
    thinned(icosphere(2), variant.of(removal_to(50)));
  EXPECT_EQ(thinned(bumpy_sphere(3), removal_to(300)).shape, expected);
}

}  // namespace
}  // namespace curvdecim::test
