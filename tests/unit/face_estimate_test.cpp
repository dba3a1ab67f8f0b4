// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/geometry/face_estimate.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace curvdecim::test {

using namespace detail;

namespace {

const Triangle corner = {Vector3(0, 0, 0), Vector3(2, 0, 0), Vector3(0, 1, 0)};

/// u = x + 3 and v = 2 y on the plane of the corner.
const AtCorners<Vector2> affine = {Vector2(3, 0), Vector2(5, 0), Vector2(3, 2)};

FaceEstimate<Vector2> estimate_at(const Vector3& x) {
  return face_estimate(plane_point(corner, x), affine);
}

TEST(FaceEstimate, ContinuesAFaceOverItsPlane) {
  for (const Vector3& x : {Vector3(0.5, 0.2, 0), Vector3(3, 2, 0), Vector3(-1, -1, 7)}) {
    const FaceEstimate<Vector2> estimate = estimate_at(x);
    EXPECT_LT((estimate.there - Vector2(x.x() + 3, 2 * x.y())).norm(), 1e-12);
    EXPECT_DOUBLE_EQ(estimate.area, 1.0);
  }
}

TEST(FaceEstimate, GoesNoFurtherThanThreeEdges) {
  const FaceEstimate<Vector2> estimate = estimate_at({1000, 0, 0});
  EXPECT_LT((estimate.there - Vector2(3 + 3 * 2, 0)).norm(), 1e-12);
}

TEST(FaceEstimate, SaysNothingWhereAFaceHasNoAreaOrNoCoordinate) {
  const Triangle flat = {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(2, 0, 0)};
  AtCorners<Vector2> unknown = affine;
  unknown[1].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(face_estimate(plane_point(flat, {0, 0, 0}), affine).area, 0.0);
  EXPECT_EQ(face_estimate(plane_point(corner, {1, 0, 0}), unknown).area, 0.0);
}

TEST(FaceEstimate, DeviatesByAreaAndSquaredDistanceButNotByRounding) {
  const FaceEstimate<Vector2> estimate{Vector2(3, 4), 2.0};
  EXPECT_DOUBLE_EQ(estimate.deviation(Vector2(3, 7)), 18.0);
  EXPECT_EQ(estimate.deviation(Vector2(3, 4 + 1e-7)), 0.0);
}

TEST(FaceEstimate, DoesNotCountAStepOfAColour) {
  const FaceEstimate<Vector3> estimate{Vector3(0.5, 0.5, 0.5), 2.0};
  EXPECT_EQ(estimate.deviation(Vector3(0.5, 0.5 + 1.0 / 255.0, 0.5)), 0.0);
  EXPECT_DOUBLE_EQ(estimate.deviation(Vector3(0.5, 1.0, 0.5)), 0.5);
}

TEST(EstimateFit, IsTheMeanByAreaWhichDeviatesLeast) {
  const std::vector<FaceEstimate<Vector2>> estimates = {
      {{0, 0}, 1.0}, {{4, 0}, 3.0}, {{0, 8}, 4.0}};
  EstimateFit<Vector2> fit;
  for (const FaceEstimate<Vector2>& each : estimates)
    fit.add(each, {Vector2(0, 0), Vector2(9, 0), Vector2(0, 9)});
  const Vector2 value = fit.value({9, 9});
  EXPECT_LT((value - Vector2(1.5, 4)).norm(), 1e-12);
  const auto deviation = [&](const Vector2& is) {
    double sum = 0.0;
    for (const FaceEstimate<Vector2>& each : estimates) sum += each.deviation(is);
    return sum;
  };
  for (const Vector2& step : {Vector2(0.1, 0), Vector2(-0.1, 0), Vector2(0, 0.1), Vector2(0, -0.1)})
    EXPECT_GT(deviation(value + step), deviation(value));
}

TEST(EstimateFit, StaysInTheRangeOfWhatTheFacesCarry) {
  EstimateFit<Vector2> fit;
  fit.add({{0.5, -0.1}, 1.0}, {Vector2(0, 0), Vector2(1, 0), Vector2(0, 1)});
  fit.add({{1.5, -0.3}, 1.0}, {Vector2(0, 0), Vector2(0, 1), Vector2(-1, 0)});
  EXPECT_EQ(fit.value({9, 9}), Vector2(1.0, 0.0));
}

TEST(EstimateFit, IsWhatItWasWhereNoFaceSaysAnything) {
  EstimateFit<Vector2> fit;
  fit.add({}, affine);
  EXPECT_EQ(fit.value({9, 9}), Vector2(9, 9));
}

TEST(SquaredGradient, IsThatOfThePlaneTimesItsArea) {
  EXPECT_NEAR(squared_gradient(corner, affine), 1.0 * (1.0 + 4.0), 1e-12);  // du/dx and dv/dy
  const Triangle flat = {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(2, 0, 0)};
  EXPECT_EQ(squared_gradient(flat, affine), 0.0);
}

}  // namespace
}  // namespace curvdecim::test
