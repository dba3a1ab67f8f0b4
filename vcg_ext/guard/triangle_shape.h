// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim {

/// True if a change makes a needle or a cap out of a face that was better. quality_before(): its
/// shape_quality, asked for only where the face is below `least` now, which is rare.
template <class Quality>
bool spoils_shape(const Triangle& after, double area_after, double least, Quality quality_before) {
  return is_worse_shaped(after, area_after, least) &&
         is_worse_shaped(after, area_after, quality_before());
}

}  // namespace curvdecim
