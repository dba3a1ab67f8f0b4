// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "vcg_ext/collapse/collapse_plan.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// Brings prices, which are areas times squared distances, into the unit of the metric's costs, by
/// the mean area of a face.
class PriceUnit {
 public:
  PriceUnit(const WorkingMesh& mesh, CostUnit unit) : unit_(unit) {
    double area = 0.0;
    for (const FacePlane& plane : mesh.plane) area += plane.area;
    if (area > 0.0) mean_area_ = area / static_cast<double>(mesh.plane.size());
  }

  double operator()(double price) const {
    switch (unit_) {
      case CostUnit::SquaredLength: return price / mean_area_;
      case CostUnit::AreaTimesLength: return std::sqrt(price * mean_area_);
      case CostUnit::AreaTimesSquaredLength: break;
    }
    return price;
  }

 private:
  CostUnit unit_;
  double mean_area_ = 1.0;
};

}  // namespace curvdecim::detail
