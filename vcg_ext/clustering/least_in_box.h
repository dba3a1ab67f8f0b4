// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "vcg_ext/geometry/symmetric3.h"

namespace curvdecim::detail {

/// How far a point may be outside a box and still count as inside, so that rounding does not stop a
/// way along a side.
inline double slack_of(const Vector3& low, const Vector3& high) {
  constexpr double of_longest_side = 1e-9;
  return of_longest_side * (high - low).maxCoeff();
}

/// The part of the way from a point in a box to another that lies in the box.
inline double part_inside(const Vector3& from, const Vector3& to, const Vector3& low,
                          const Vector3& high) {
  const double slack = slack_of(low, high);
  double part = 1.0;
  for (int k = 0; k < 3; ++k) {
    if (to[k] > high[k] + slack) part = std::min(part, (high[k] - from[k]) / (to[k] - from[k]));
    if (to[k] < low[k] - slack) part = std::min(part, (low[k] - from[k]) / (to[k] - from[k]));
  }
  return std::max(part, 0.0);
}

/// The point of a box where x^T A x + 2 b.x is least, A positive definite: goes from a point in the
/// box to the minimum over the axes that are not held, holds the axis whose side it meets, and lets
/// an axis go where that leads further down.
class LeastInBox {
 public:
  LeastInBox(const Symmetric3& a, const Vector3& b, const Vector3& low, const Vector3& high)
      : a_{{{a.xx, a.xy, a.xz}, {a.xy, a.yy, a.yz}, {a.xz, a.yz, a.zz}}},
        b_(b),
        low_(low),
        high_(high) {}

  Vector3 from(Vector3 x) {
    constexpr int most_steps = 16;  // in exact numbers no set of axes is held twice
    for (int step = 0; step < most_steps; ++step) {
      const Vector3 least = minimum_over_open_axes(x);
      const double part = part_inside(x, least, low_, high_);
      const int met = part < 1.0 ? axis_met(x, least, part) : none;
      x = (x + part * (least - x)).cwiseMax(low_).cwiseMin(high_);
      if (met != none)
        held_[met] = true;
      else if (!let_go(x))
        break;
    }
    return x;
  }

 private:
  static constexpr int none = -1;

  int axis_met(const Vector3& x, const Vector3& to, double part) const {
    const double slack = slack_of(low_, high_);
    for (int k = 0; k < 3; ++k) {
      const double side = to[k] > high_[k] ? high_[k] : low_[k];
      const bool out = to[k] > high_[k] + slack || to[k] < low_[k] - slack;
      if (out && !held_[k] && (side - x[k]) / (to[k] - x[k]) <= part) return k;
    }
    return none;
  }

  /// The axis along which the way down leads into the box most steeply; false: along none.
  bool let_go(const Vector3& x) {
    int steepest = none;
    double slope = 0.0;
    for (int k = 0; k < 3; ++k) {
      if (!held_[k]) continue;
      const double inwards = x[k] >= high_[k] ? gradient(x, k) : -gradient(x, k);
      if (inwards > slope) slope = inwards, steepest = k;
    }
    if (steepest != none) held_[steepest] = false;
    return steepest != none;
  }

  double gradient(const Vector3& x, int k) const {
    return a_[k][0] * x[0] + a_[k][1] * x[1] + a_[k][2] * x[2] + b_[k];
  }

  Vector3 minimum_over_open_axes(Vector3 x) const {
    std::array<int, 3> open{};
    int count = 0;
    for (int k = 0; k < 3; ++k)
      if (!held_[k]) open[count++] = k;
    if (count == 3)
      return -Factorization3({a_[0][0], a_[0][1], a_[0][2], a_[1][1], a_[1][2], a_[2][2]})
                  .solve(b_);
    const auto [i, j] = std::array{open[0], open[1]};
    if (count == 1) x[i] = right_side(x, i) / a_[i][i];
    if (count != 2) return x;
    const double at_i = right_side(x, i), at_j = right_side(x, j);
    const double determinant = a_[i][i] * a_[j][j] - a_[i][j] * a_[i][j];
    x[i] = (a_[j][j] * at_i - a_[i][j] * at_j) / determinant;
    x[j] = (a_[i][i] * at_j - a_[i][j] * at_i) / determinant;
    return x;
  }

  /// The right side of row k of A x = -b, with the axes that are held.
  double right_side(const Vector3& x, int k) const {
    double sum = -b_[k];
    for (int l = 0; l < 3; ++l)
      if (held_[l]) sum -= a_[k][l] * x[l];
    return sum;
  }

  std::array<std::array<double, 3>, 3> a_;
  Vector3 b_, low_, high_;
  std::array<bool, 3> held_{};
};

}  // namespace curvdecim::detail
