// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "vcg_ext/geometry/vector3.h"

namespace curvdecim::detail {

/// Algebraic sphere S(x) = c + l.x + q x.x @cite guennebaud2007, as a function of the offset from
/// an origin of its own. It is positive on the side that the gradient points to; a plane has q = 0.
struct AlgebraicSphere {
  double c = 0.0;
  Vector3 l = Vector3::Zero();
  double q = 0.0;

  double value(const Vector3& x) const { return c + x.dot(l + q * x); }
  Vector3 gradient(const Vector3& x) const { return l + 2.0 * q * x; }

  /// |gradient|^2 on the surface; below zero where the sphere has no real points.
  double pratt_norm2() const { return l.squaredNorm() - 4.0 * c * q; }

  /// With a gradient of length 1 on the surface, so that the value there is a distance. Without
  /// real points, a length of 1 at the origin; constant: zero.
  AlgebraicSphere normalised() const {
    const double real = pratt_norm2(), at_origin = l.squaredNorm();
    const double norm2 = real > least_norm2 * at_origin ? real : at_origin;
    return norm2 > 0.0 ? *this * (1.0 / std::sqrt(norm2)) : AlgebraicSphere{};
  }

  /// The same function of the offset from an origin that lies `step` away.
  AlgebraicSphere with_origin_moved(const Vector3& step) const {
    return {value(step), gradient(step), q};
  }

  /// The nearest point of a normalised sphere along the gradient at x; x itself at the centre.
  Vector3 project(const Vector3& x) const {
    const Vector3 g = gradient(x);
    const double length = g.norm(), s = value(x);
    const double on_surface = std::sqrt(std::max(0.0, length * length - 4.0 * q * s));
    const double divisor = length * (length + on_surface);
    return divisor > 0.0 ? Vector3(x - (2.0 * s / divisor) * g) : x;
  }

  AlgebraicSphere operator*(double s) const { return {s * c, s * l, s * q}; }

  AlgebraicSphere& operator+=(const AlgebraicSphere& o) {
    c += o.c, l += o.l, q += o.q;
    return *this;
  }

 private:
  static constexpr double least_norm2 = 1e-12;  // of that at the origin: the rest is rounding
};

inline AlgebraicSphere operator+(AlgebraicSphere a, const AlgebraicSphere& b) { return a += b; }

/// a + t (b - a), of two spheres about one origin.
inline AlgebraicSphere interpolated(const AlgebraicSphere& a, const AlgebraicSphere& b, double t) {
  return a * (1.0 - t) + b * t;
}

}  // namespace curvdecim::detail
