// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim {

/// True if the unit normal turns too far towards the new area vector: `least` is the cosine of the
/// largest angle times the new area. A face that had no area had no normal (zero) to turn.
inline bool turns_too_far(const Vector3& before, const Vector3& area_vector_after, double least) {
  return before.dot(area_vector_after) < least && before.squaredNorm() > 0.0;
}

}  // namespace curvdecim
