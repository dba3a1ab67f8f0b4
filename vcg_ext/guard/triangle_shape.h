// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim {

/// True if the collapse makes a needle or a cap out of a face that was better. `least` is a
/// shape_quality.
inline bool spoils_shape(double quality_before, double quality_after, double least) {
  return quality_after < least && quality_after < quality_before;
}

}  // namespace curvdecim
