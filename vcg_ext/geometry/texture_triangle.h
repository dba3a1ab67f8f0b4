// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim::detail {

inline double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The texture coordinates of a face's corners.
using TextureTriangle = std::array<Vector2, 3>;

/// Twice the area of a face in its texture, below 0 where it is seen from behind.
inline double texture_area(const TextureTriangle& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// Whether a face is turned over in its texture, or has no area there any more. One without area
/// may become anything.
inline bool is_turned_over(double area_before, double area_after) {
  return (area_before > 0.0 && area_after <= 0.0) || (area_before < 0.0 && area_after >= 0.0);
}

/// Area of a face times the squared distance in the texture between `is` and what the face,
/// continued over its plane, would have at x @cite hoppe1999.
inline double texture_deviation(const Triangle& face, const TextureTriangle& texture,
                                const Vector3& x, const Vector2& is) {
  constexpr double furthest = 3.0;   // edges that a face is continued: slivers know little
  constexpr double rounding = 1e-6;  // files have seven digits: what is affine costs nothing
  const Vector3 ab = face[1] - face[0], ac = face[2] - face[0], ax = x - face[0];
  const Vector3 normal = ab.cross(ac);
  const double scale = normal.squaredNorm();
  if (!(scale > 0.0)) return 0.0;
  const double b = std::clamp(ax.cross(ac).dot(normal) / scale, -furthest, furthest);
  const double c = std::clamp(ab.cross(ax).dot(normal) / scale, -furthest, furthest);
  const Vector2 there = texture[0] + b * (texture[1] - texture[0]) + c * (texture[2] - texture[0]);
  const double distance2 = (is - there).squaredNorm();
  if (distance2 <= rounding * rounding * is.squaredNorm()) return 0.0;
  return 0.5 * std::sqrt(scale) * distance2;
}

}  // namespace curvdecim::detail
