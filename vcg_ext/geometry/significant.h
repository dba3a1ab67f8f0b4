// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace curvdecim {

/// The distance, or 0 where it is below what float coordinates can tell at this squared length.
inline double significant(double distance, double length2) {
  constexpr double rounding = 1e-7;  // of the length
  return distance * distance <= rounding * rounding * length2 ? 0.0 : distance;
}

}  // namespace curvdecim
