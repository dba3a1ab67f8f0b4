// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim {

/// Cosine of the largest angle in degrees, with a margin: two faces on the very limit could lie
/// back to back.
inline double least_cosine(double degrees) {
  constexpr double margin = 0.05;
  return std::cos(degrees * (M_PI / 180.0)) + margin;
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

}  // namespace curvdecim
