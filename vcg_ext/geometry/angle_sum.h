// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace curvdecim::detail {

/// A sum of angles from 0 to pi. They are turns of the plane, one after the other: one arc tangent
/// does for all.
class AngleSum {
 public:
  /// By the angle's cosine and sine, both times the same; sine >= 0. Both 0: no angle.
  void add(double cosine, double sine) {
    const double size = std::abs(cosine) + sine;
    if (!(size > 0.0)) return;
    const double c = cosine / size, s = sine / size, length = std::sqrt(c * c + s * s);
    const double x = (x_ * c - y_ * s) / length, y = (x_ * s + y_ * c) / length;
    half_turns_ += is_below(x, y) != is_below(x_, y_);
    x_ = x, y_ = y;
  }

  /// Radians.
  double value() const {
    const double side = is_below(x_, y_) ? -1.0 : 1.0;
    return half_turns_ * M_PI + std::atan2(side * y_, side * x_);
  }

 private:
  /// From half a turn up to a whole one.
  static bool is_below(double x, double y) { return y < 0.0 || (y == 0.0 && x < 0.0); }

  int half_turns_ = 0;
  double x_ = 1.0, y_ = 0.0;  // where the turns have brought the x axis
};

}  // namespace curvdecim::detail
