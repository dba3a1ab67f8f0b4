// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "vcg_ext/curvature/curvature_field.h"
#include "vcg_ext/params.h"

namespace curvdecim::detail {

/// The factor floor + (1 - floor) saturation on the cost. As printed @cite pellizzoni2020 the floor
/// is 0, which makes flat and cylindrical places free and their order arbitrary, and the saturation
/// 1 - exp(-alpha k). ScaleFree keeps a floor and has 1 - exp(-alpha k^2), nearly a step at the
/// unit of k (docs/decisions/scale-free-alpha.md).
class CurvatureWeight {
 public:
  CurvatureWeight() = default;

  /// alpha <= 0: 1 everywhere. unit: the measure of curvature that counts as 1.
  CurvatureWeight(AlphaUnits form, double alpha, double floor, double unit)
      : is_step_(form == AlphaUnits::ScaleFree), alpha_(alpha), floor_(floor), unit_(unit) {}

  /// How curved a place of this curvature counts; 0..1.
  double saturation(double curvature) const {
    if (!(alpha_ > 0.0) || !(unit_ > 0.0)) return 1.0;
    const double k = curvature / unit_;
    return -std::expm1(-alpha_ * (is_step_ ? k * k : k));
  }

  double factor(double saturation) const { return floor_ + (1.0 - floor_) * saturation; }

  /// As printed, of the sum of both curvatures: their exponentials multiply. Of a step, the mean:
  /// the part of the place that lies above it.
  double of_edge(double saturation_a, double saturation_b) const {
    const double sum = saturation_a + saturation_b;
    return factor(is_step_ ? 0.5 * sum : sum - saturation_a * saturation_b);
  }

 private:
  bool is_step_ = false;
  double alpha_ = 0.0, floor_ = 1.0, unit_ = 1.0;
};

/// field: over the input in its box of diagonal 1; diagonal: of the input in its own unit.
inline CurvatureWeight curvature_weight(const CurvatureParams& params, const CurvatureField& field,
                                        double diagonal) {
  constexpr double most_curved = 0.2;  // of the area: what is to be protected
  constexpr double flat = 0.01;  // of the mean: less is rounding, on meshes of mostly flat places
  if (params.alpha_units == AlphaUnits::ScaleFree)
    return {params.alpha_units, params.alpha, params.curvature_floor,
            std::max(field.least_of_most_curved(most_curved), flat * field.mean())};
  return {params.alpha_units, params.alpha, 0.0,
          params.curvature_kind == CurvatureKind::Gaussian ? diagonal * diagonal : diagonal};
}

}  // namespace curvdecim::detail
