// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/face_estimate.h"

namespace curvdecim::detail {

inline double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The texture coordinates of a face's corners.
using TextureTriangle = AtCorners<Vector2>;

/// Twice the area of a face in its texture, below 0 where it is seen from behind.
inline double texture_area(const TextureTriangle& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// Whether a face is turned over in its texture, or has no area there any more. One without area
/// may become anything.
inline bool is_turned_over(double area_before, double area_after) {
  return (area_before > 0.0 && area_after <= 0.0) || (area_before < 0.0 && area_after >= 0.0);
}

}  // namespace curvdecim::detail
