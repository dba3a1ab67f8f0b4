// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim::detail {

/// What a face may become.
struct FaceLimits {
  bool keeps_normal = true;    ///< its normal may turn by normal_angle at most
  double normal_angle = 90.0;  ///< degrees
};

/// What a collapse may do.
struct CollapseLimits {
  FaceLimits faces;
  bool keeps_topology = true;        ///< link condition, and kinds of vertices
  bool keeps_boundary = true;        ///< boundary vertices go along the boundary only
  bool topology_gives_way = false;   ///< by size: parts, holes and handles may go at a price
  double max_error = 0.0;            ///< distance to the input, in the box; 0: no bound
  bool max_error_one_sided = false;  ///< from the result to the input only
  bool prevents_crossings = false;   ///< no face crosses another that it did not cross before
  double attribute_weight = 0.0;     ///< of what is carried, where it drifts, against the surface
};

/// Cosine of the largest turn, which is a part of the limits' angle, with a margin: two faces on
/// the very limit could lie back to back.
inline double least_cosine(const FaceLimits& limits, double part) {
  constexpr double margin = 0.05;
  if (!limits.keeps_normal) return -1.0;
  return std::cos(part * limits.normal_angle * (M_PI / 180.0)) + margin;
}

/// A unit normal, or zero, in three bytes: its cosine with another is right within a seventh of the
/// margin.
class RoughNormal {
 public:
  RoughNormal() = default;
  explicit RoughNormal(const Vector3& normal) {
    for (int k = 0; k < 3; ++k) part_[k] = static_cast<std::int8_t>(std::lround(one * normal[k]));
  }

  Vector3 unpacked() const { return Vector3(part_[0], part_[1], part_[2]) / one; }

 private:
  static constexpr double one = 127.0;

  std::array<std::int8_t, 3> part_{};
};

/// True if the unit normal turns too far: `least` is the cosine of the largest angle. A face
/// without area has no normal (zero) to turn.
inline bool turns_too_far(const Vector3& before, const FacePlane& after, double least) {
  return before.dot(after.normal) < least && before.squaredNorm() > 0.0 && after.area > 0.0;
}

/// True if a change makes a needle or a cap out of a face that was better. quality_before(): its
/// shape_quality, asked for only where the face is below `least` now, which is rare.
template <class Quality>
bool spoils_shape(const Triangle& after, double area_after, double least, Quality quality_before) {
  return is_worse_shaped(after, area_after, least) &&
         is_worse_shaped(after, area_after, quality_before());
}

}  // namespace curvdecim::detail
