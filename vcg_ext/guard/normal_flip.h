// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim {

/// True if the unit normal turns by more than the angle whose cosine is given. A face that had no
/// area had no normal (zero) to turn.
inline bool turns_too_far(const Vector3& before, const FacePlane& after, double cos_limit) {
  return before.squaredNorm() > 0.0 && before.dot(after.normal) < cos_limit;
}

}  // namespace curvdecim
