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

/// Minimum of the quadric, drawn towards the origin (the edge's midpoint) just strongly enough that
/// directions in which it is flat do not throw the vertex far away; then moved, where that takes no
/// more than the edge's length, to the minimum among the points that keep the volume. The edge goes
/// from -half to +half.
inline Vector3 optimal_offset(const Quadric& q, const std::optional<VolumePlane>& volume,
                              const Vector3& half) {
  constexpr double pull = 1e-4;  // relative to the trace, that is to the strongest direction
  const double trace = q.a.trace();
  if (!(trace > 0.0)) return Vector3::Zero();
  const Factorization3 a(q.a.plus_diagonal(pull * trace));
  const Vector3 offset = a.solve(-q.b);
  const double least = q.value(offset), even = half.dot(q.a * half) + q.c,
               odd = 2.0 * q.b.dot(half);
  if (even - odd < least) return -half;  // a corner: only the pull moved the minimum off it
  if (even + odd < least) return half;
  if (!volume) return offset;
  const Vector3 direction = a.solve(volume->gradient);
  const double slope = volume->gradient.dot(direction);
  const Vector3 step = ((volume->offset - volume->gradient.dot(offset)) / slope) * direction;
  return slope > 0.0 && step.squaredNorm() <= 4.0 * half.squaredNorm() ? offset + step : offset;
}

}  // namespace curvdecim
