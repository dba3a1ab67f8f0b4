// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim {

/// Cosine of the largest angle in degrees, with a margin: two faces on the very limit could lie
/// back to back.
inline double least_cosine(double degrees) {
  constexpr double margin = 0.05;
  return std::cos(degrees * (M_PI / 180.0)) + margin;
}

/// True if the unit normal turns too far: `least` is the cosine of the largest angle. A face
/// without area has no normal (zero) to turn.
inline bool turns_too_far(const Vector3& before, const FacePlane& after, double least) {
  return before.dot(after.normal) < least && before.squaredNorm() > 0.0 && after.area > 0.0;
}

}  // namespace curvdecim
