// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "vcg_ext/geometry/quadric.h"

namespace curvdecim {

/// The plane gradient.d = offset on which the collapse leaves the enclosed volume as it is
/// @cite lindstrom1998.
struct VolumePlane {
  Vector3 gradient;
  double offset;
};

/// A point and the value of the quadric there.
struct Minimum {
  Vector3 offset;
  double value;
};

/// How strongly a minimum is drawn to the midpoint: to the trace, that is to the strongest
/// direction.
inline constexpr double relative_pull = 1e-4;

/// Minimum of the quadric, drawn towards the origin (the edge's midpoint) just strongly enough that
/// directions in which it is flat do not throw the vertex far away; then moved, where that takes no
/// more than the edge's length, to the minimum among the points that keep the volume. The edge goes
/// from -half to +half. With p the pull, (A + p) x = -b gives the value without another product:
/// c + b.x - p x.x, and so do the steps from there.
inline Minimum optimal_minimum(const QuadricOfEdge& quadric,
                               const std::optional<VolumePlane>& volume, const Vector3& half) {
  const Quadric& q = quadric.sum;
  const double trace = q.a.trace(), pull = relative_pull * trace;
  if (!(trace > 0.0)) return {Vector3::Zero(), q.c};
  const Factorization3 a(q.a.plus_diagonal(pull));
  const Vector3 offset = -a.solve(q.b);
  const double least = q.c + q.b.dot(offset) - pull * offset.squaredNorm();
  const double even = quadric.along + q.c, odd = 2.0 * q.b.dot(half);
  if (even - odd < least) return {-half, even - odd};  // a corner: only the pull moved it off
  if (even + odd < least) return {half, even + odd};
  if (!volume) return {offset, least};
  const Vector3 direction = a.solve(volume->gradient);
  const double slope = volume->gradient.dot(direction), length2 = direction.squaredNorm();
  const double gap = volume->offset - volume->gradient.dot(offset);
  if (!(gap * gap * length2 <= 4.0 * half.squaredNorm() * (slope * slope)) || !(slope > 0.0))
    return {offset, least};
  const double step = gap / slope;
  const double rise = step * (slope - pull * length2) - 2.0 * pull * offset.dot(direction);
  return {offset + step * direction, least + step * rise};
}

}  // namespace curvdecim
