// SPDX-License-Identifier: GPL-3.0-or-later
// On which side of a plane or a line a point is: signs that are right, or 0 where rounding could
// have turned them over. They depend on the shape alone, not on its size.
#pragma once

#include <cmath>
#include <limits>

#include "vcg_ext/geometry/vector3.h"

namespace curvdecim::detail {

/// -1, 0 or 1; 0 also where |value| is no more than `bound`.
inline int sign_beyond(double value, double bound) { return (value > bound) - (value < -bound); }

/// Half the distance from 1 to the next number: what one rounding takes at most.
inline constexpr double half_ulp = 0.5 * std::numeric_limits<double>::epsilon();

/// 1 where a, b, c run counterclockwise @cite shewchuk1997.
inline int orientation(const Vector2& a, const Vector2& b, const Vector2& c) {
  constexpr double rounding = (3.0 + 16.0 * half_ulp) * half_ulp;
  const double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]);
  return sign_beyond(left - right, rounding * (std::abs(left) + std::abs(right)));
}

/// The plane through three points, to ask on which side of it others are @cite shewchuk1997.
class OrientedPlane {
 public:
  OrientedPlane(const Vector3& a, const Vector3& b, const Vector3& c) : origin_(a) {
    const Vector3 u = b - a, v = c - a;
    for (int i = 0; i < 3; ++i) {
      const int k = (i + 1) % 3, m = (i + 2) % 3;
      const double first = u[k] * v[m], second = u[m] * v[k];
      normal_[i] = first - second, size_[i] = std::abs(first) + std::abs(second);
    }
  }

  /// 1 where p lies in front of it, where a, b, c run counterclockwise. volume: up to which that of
  /// the box of a, b, c and p counts as none.
  int side(const Vector3& p, double volume = 0.0) const {
    constexpr double rounding = (7.0 + 56.0 * half_ulp) * half_ulp;
    const Vector3 to = p - origin_;
    return sign_beyond(normal_.dot(to), rounding * size_.dot(to.cwiseAbs()) + volume);
  }

  /// Twice the area of the three points.
  double normal_length() const { return normal_.norm(); }

 private:
  Vector3 origin_, normal_, size_;
};

}  // namespace curvdecim::detail
