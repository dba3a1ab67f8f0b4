// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "vcg_ext/params.h"

namespace curvdecim {

/// The factor floor + (1 - floor) (1 - exp(-alpha k)) on the cost @cite pellizzoni2020. The paper
/// has floor 0, which makes flat and cylindrical places free and their order arbitrary; the
/// scale-free form keeps a floor.
class CurvatureWeight {
 public:
  CurvatureWeight() = default;

  /// alpha <= 0: 1 everywhere. unit: the curvature that counts as 1.
  CurvatureWeight(double alpha, double floor, double unit)
      : alpha_(alpha), floor_(floor), unit_(unit) {}

  double operator()(double curvature) const { return factor(saturation(curvature)); }

  /// 1 - exp(-alpha k), 0..1.
  double saturation(double curvature) const {
    if (!(alpha_ > 0.0) || !(unit_ > 0.0)) return 1.0;
    return -std::expm1(-alpha_ * (curvature / unit_));
  }

  /// The factor for the sum of two curvatures, whose exponentials multiply.
  double of_edge(double saturation_a, double saturation_b) const {
    return factor(saturation_a + saturation_b - saturation_a * saturation_b);
  }

 private:
  double factor(double saturation) const { return floor_ + (1.0 - floor_) * saturation; }

  double alpha_ = 0.0, floor_ = 1.0, unit_ = 1.0;
};

/// mean: of the curvature over the input in its box of diagonal 1; diagonal: of the input in its
/// own unit.
inline CurvatureWeight curvature_weight(const CurvatureParams& params, double mean,
                                        double diagonal) {
  if (params.alpha_units == AlphaUnits::ScaleFree)
    return {params.alpha, params.curvature_floor, mean};
  return {params.alpha, 0.0,
          params.curvature_kind == CurvatureKind::Gaussian ? diagonal * diagonal : diagonal};
}

}  // namespace curvdecim
