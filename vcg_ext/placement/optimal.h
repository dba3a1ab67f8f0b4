// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/quadric.h"

namespace curvdecim {

/// Minimum of the quadric, drawn towards the origin (the edge's midpoint) just strongly enough that
/// directions in which it is flat do not throw the vertex far away.
inline Vector3 optimal_offset(const Quadric& q) {
  constexpr double pull = 1e-3;  // relative to the trace, that is to the strongest direction
  const double trace = q.a.trace();
  if (!(trace > 0.0)) return Vector3::Zero();
  return q.a.plus_diagonal(pull * trace).solve(-q.b);
}

}  // namespace curvdecim
