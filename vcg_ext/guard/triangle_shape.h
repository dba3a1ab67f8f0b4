// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim {

/// True if the collapse makes a needle or a cap out of a face that was better. `least` is a
/// shape_quality.
inline bool spoils_shape(const Triangle& before, double area_before, const Triangle& after,
                         double area_after, double least) {
  if (!is_worse_shaped(after, area_after, least)) return false;
  return is_worse_shaped(after, area_after, shape_quality(before, area_before));
}

}  // namespace curvdecim
