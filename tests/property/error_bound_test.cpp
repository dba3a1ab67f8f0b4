// SPDX-License-Identifier: GPL-3.0-or-later
// MaxError is a promise: no point of either surface is further from the other.
#include <gtest/gtest.h>

#include "support/decimation.h"
#include "support/mesh_group.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

class ErrorBoundOn : public testing::TestWithParam<NamedShape> {};

TEST_P(ErrorBoundOn, IsKeptByEveryVariant) {
  const Shape& before = GetParam().shape;
  for (double fraction : {1e-3, 1e-2})
    for (const Variant& variant : all_variants()) {
      SCOPED_TRACE(variant.name + " within " + std::to_string(fraction));
      EdgeCollapseParams params = variant.params;
      params.max_error = fraction * diagonal(before);
      const auto [after, report] = decimated(before, params);
      EXPECT_LE(two_sided_distance(before, after), params.max_error);
      EXPECT_LE(report.max_error, params.max_error);
      EXPECT_NE(report.stopped_by, StopReason::Target);
    }
}

TEST_P(ErrorBoundOn, LeavesFewerFacesWhenItIsWider) {
  const Shape& before = GetParam().shape;
  const auto faces_within = [&](double fraction) {
    EdgeCollapseParams params;
    params.max_error = fraction * diagonal(before);
    return decimated(before, params).shape.face_count();
  };
  EXPECT_LT(faces_within(0.02), faces_within(0.001));
}

INSTANTIATE_TEST_SUITE_P(Drawn, ErrorBoundOn,
                         testing::Values(NamedShape{"icosphere", icosphere(2)},
                                         NamedShape{"noisy_sphere", noisy_sphere(2, 0.02)},
                                         NamedShape{"torus", torus(24, 12)},
                                         NamedShape{"saddle", saddle(12)}),
                         name_of);

TEST(ErrorBound, AndATargetStopAtWhicheverComesFirst) {
  EdgeCollapseParams params = to_faces(300);
  params.max_error = 1.0;  // never reached
  EXPECT_EQ(decimated(icosphere(2), params).report.stopped_by, StopReason::Target);
  params.target_faces = 4;
  params.max_error = 0.01;
  const auto [after, report] = decimated(icosphere(2), params);
  EXPECT_GT(after.face_count(), 4);
  EXPECT_NE(report.stopped_by, StopReason::Target);
}

}  // namespace
}  // namespace curvdecim::test
