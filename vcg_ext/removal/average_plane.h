// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim::detail {

/// The average plane of some triangles by their areas A, centres c and unit normals n:
/// B = sum A c / sum A and n = sum A n / sum A @cite schroeder1992.
class AveragePlane {
 public:
  void add(const Triangle& t, const Vector3& area_vector, double area) {
    center_ += area * (t[0] + t[1] + t[2]);
    area_vector_ += area_vector;
    area_ += area;
  }

  double area() const { return area_; }

  /// 0 where the triangles face nowhere together.
  double distance(const Vector3& p) const {
    const double length = area_vector_.norm();
    return length > 0.0 ? std::abs(area_vector_.dot(p - center_ / (3.0 * area_))) / length : 0.0;
  }

 private:
  Vector3 center_ = Vector3::Zero();  // three times
  Vector3 area_vector_ = Vector3::Zero();
  double area_ = 0.0;
};

}  // namespace curvdecim::detail
