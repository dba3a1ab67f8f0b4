// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "vcg_ext/geometry/quadric.h"

namespace curvdecim {

/// Where, from 0 (-half) to 1 (+half), the quadric is least on the edge; 0.5 where it is flat.
inline double parameter_of_minimum(const Quadric& q, const Vector3& half) {
  const double curvature = half.dot(q.a * half);
  if (!(curvature > 0.0)) return 0.5;
  return std::clamp(0.5 - 0.5 * q.b.dot(half) / curvature, 0.0, 1.0);
}

/// The parameter of the point of the edge nearest to `offset`.
inline double parameter_along(const Vector3& half, const Vector3& offset) {
  const double length2 = half.squaredNorm();
  return length2 > 0.0 ? std::clamp(0.5 + 0.5 * half.dot(offset) / length2, 0.0, 1.0) : 0.5;
}

}  // namespace curvdecim
