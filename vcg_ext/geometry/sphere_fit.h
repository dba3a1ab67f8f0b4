// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "vcg_ext/geometry/algebraic_sphere.h"

namespace curvdecim::detail {

/// What an algebraic sphere is fitted to @cite guennebaud2008: sums over weighted points and unit
/// normals, about an origin of their own. They add up, like quadrics.
struct SphereSums {
  double weight = 0.0;
  Vector3 point = Vector3::Zero(), normal = Vector3::Zero();
  double point2 = 0.0;        // p.p
  double normal_point = 0.0;  // n.p

  void add(const Vector3& p, const Vector3& n, double w) {
    weight += w;
    point += w * p, normal += w * n;
    point2 += w * p.squaredNorm(), normal_point += w * n.dot(p);
  }

  SphereSums& operator+=(const SphereSums& o) {
    weight += o.weight;
    point += o.point, normal += o.normal;
    point2 += o.point2, normal_point += o.normal_point;
    return *this;
  }

  /// The same about an origin that lies `step` away.
  SphereSums with_origin_moved(const Vector3& step) const {
    return {weight, point - weight * step, normal,
            point2 - 2.0 * step.dot(point) + weight * step.squaredNorm(),
            normal_point - step.dot(normal)};
  }

  /// The sphere whose gradients fit the normals best and whose mean value is 0, normalised. A plane
  /// where the points do not spread; zero without weight.
  AlgebraicSphere fit() const {
    if (!(weight > 0.0)) return {};
    const Moments m = moments();
    const double q = m.spread > 0.0 ? 0.5 * m.turn / m.spread : 0.0;
    const Vector3 l = normal / weight - 2.0 * q * m.centre;
    return AlgebraicSphere{-l.dot(m.centre) - q * point2 / weight, l, q}.normalised();
  }

  /// Squared distance that the sphere may be off at the points, length^2: what it leaves of the
  /// normals' variance, times a quarter of the points'. A direction that curves by dk more than the
  /// sphere turns the normal by dk r, and lifts the surface by dk r^2 / 2.
  double doubt() const {
    if (!(weight > 0.0)) return 0.0;
    const Moments m = moments();
    if (!(m.spread > 0.0)) return 0.0;
    const double variance = weight - normal.squaredNorm() / weight;
    return 0.25 * m.spread * std::max(0.0, variance - m.turn * m.turn / m.spread) /
           (weight * weight);
  }

 private:
  static constexpr double least_spread = 1e-12;  // of the squared distances: the rest is rounding

  struct Moments {
    Vector3 centre;  // of the points
    double spread;   // sum of their squared distances to it; 0 where that is rounding
    double turn;     // of the normals with the points, about it
  };

  Moments moments() const {
    const Vector3 centre = point / weight;
    const double spread = point2 - centre.dot(point);
    return {centre, spread > least_spread * point2 ? spread : 0.0,
            normal_point - centre.dot(normal)};
  }
};

inline SphereSums operator+(SphereSums a, const SphereSums& b) { return a += b; }

}  // namespace curvdecim::detail
