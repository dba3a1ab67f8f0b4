// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/validation.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace curvdecim::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The message of the refusal; empty where it was accepted.
std::string refusal(const std::function<void()>& check) {
  try {
    check();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(RequireRange, TakesBothEndsAndWhatLiesBetween) {
  for (double value : {0.0, 0.5, 1.0}) EXPECT_NO_THROW(require_range("X", value, 0.0, 1.0));
}

TEST(RequireRange, RefusesWhatLiesOutsideAndWhatIsNoNumber) {
  for (double value : {-1e-300, 1.0 + 1e-15, nan, infinity, -infinity})
    EXPECT_THROW(require_range("X", value, 0.0, 1.0), InputError) << value;
}

TEST(RequireRange, NamesTheParameterTheValueAndTheRange) {
  EXPECT_EQ(refusal([] { require_range("TargetPerc", 1.5, 0.0, 1.0); }),
            "TargetPerc is 1.5, but must lie between 0 and 1.");
}

TEST(RequireAtLeast, TakesTheEndAndAllFiniteNumbersAbove) {
  for (double value : {0.0, 1e-300, 1e308}) EXPECT_NO_THROW(require_at_least("X", value, 0.0));
}

TEST(RequireAtLeast, RefusesLessAndWhatIsNotFinite) {
  for (double value : {-1.0, nan, infinity, -infinity})
    EXPECT_THROW(require_at_least("X", value, 0.0), InputError) << value;
}

TEST(RequireAtLeast, NamesTheParameterTheValueAndTheBound) {
  EXPECT_EQ(refusal([] { require_at_least("MaxError", -2.0, 0.0); }),
            "MaxError is -2, but must be a finite number of at least 0.");
}

TEST(Validate, TakesTheDefaults) {
  EXPECT_NO_THROW(validate(EdgeCollapseParams()));
  EXPECT_NO_THROW(validate(ImportanceParams()));
}

TEST(Validate, OfAlphaRefusesOnlyWhatIsNoNumber) {
  CurvatureParams params;
  for (double alpha : {-infinity, -1.0, 0.0, infinity}) {
    params.alpha = alpha;
    EXPECT_NO_THROW(validate(params)) << alpha;
  }
  params.alpha = nan;
  EXPECT_NE(refusal([&] { validate(params); }).find("Alpha"), std::string::npos);
}

TEST(Validate, LooksAtTheParametersOfEveryBase) {
  EdgeCollapseParams shared, curvature, own;
  shared.max_error = -1.0, curvature.curvature_floor = 2.0, own.lambda = -1.0;
  EXPECT_NE(refusal([&] { validate(shared); }).find("MaxError"), std::string::npos);
  EXPECT_NE(refusal([&] { validate(curvature); }).find("CurvatureFloor"), std::string::npos);
  EXPECT_NE(refusal([&] { validate(own); }).find("Lambda"), std::string::npos);
}

TEST(Validate, RefusesPairsWithABoundAndTakesEitherAlone) {
  EdgeCollapseParams params;
  params.pair_distance = 0.1;
  EXPECT_NO_THROW(validate(params));
  params.max_error = 0.1;
  EXPECT_NE(refusal([&] { validate(params); }).find("PairDistance and MaxError"),
            std::string::npos);
  params.pair_distance = 0.0;
  EXPECT_NO_THROW(validate(params));
}

}  // namespace
}  // namespace curvdecim::test
