// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/symmetric3.h"

namespace curvdecim::detail {

/// Weighted sum of squared distances to planes @cite garland1997, as a function of the offset from
/// an origin of its own: value(d) = d^T A d + 2 b.d + c. The origin is the vertex that carries the
/// quadric, so that small errors are not lost in the rounding of large coordinates.
struct Quadric {
  Symmetric3 a;
  Vector3 b = Vector3::Zero();
  double c = 0.0;

  /// The plane with unit normal n at the signed distance `offset` from the origin along n.
  static Quadric plane(const Vector3& n, double offset, double weight) {
    return {Symmetric3::outer(n, weight), (-weight * offset) * n, weight * offset * offset};
  }

  Quadric& operator+=(const Quadric& o) {
    a += o.a, b += o.b, c += o.c;
    return *this;
  }

  double value(const Vector3& d) const { return d.dot(a * d) + 2.0 * b.dot(d) + c; }

  /// The same function of the offset from an origin that lies `step` away.
  Quadric with_origin_moved(const Vector3& step) const {
    const Vector3 a_step = a * step;
    return {a, b + a_step, step.dot(a_step) + 2.0 * b.dot(step) + c};
  }
};

/// The sum of p, about the point -half, and q, about +half, as a quadric about the point between;
/// along: half^T A half.
struct QuadricOfEdge {
  Quadric sum;
  double along;
};

inline QuadricOfEdge sum_about_midpoint(const Quadric& p, const Quadric& q, const Vector3& half) {
  const Vector3 p_half = p.a * half, q_half = q.a * half;
  const double along = half.dot(p_half + q_half);
  return {
      {p.a + q.a, p.b + q.b + (p_half - q_half), p.c + q.c + along + 2.0 * (p.b - q.b).dot(half)},
      along};
}

inline Quadric operator+(Quadric p, const Quadric& q) { return p += q; }

}  // namespace curvdecim::detail
