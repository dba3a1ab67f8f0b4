// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "vcg_ext/geometry/vector3.h"

namespace curvdecim::detail {

/// A cell's place in the grid: 21 bits an axis.
using CellKey = std::uint64_t;

struct CellBox {
  Vector3 low, high;

  Vector3 center() const { return 0.5 * (low + high); }
  Vector3 clamped(const Vector3& p) const { return p.cwiseMax(low).cwiseMin(high); }
};

/// Cubes of one size, placed from the middle of the mesh's bounding box, so that a move of the mesh
/// moves the grid. The middle is a border between cells, which keeps left and right apart; an axis
/// shorter than a cell has one. Cells end at the bounding box.
class CellGrid {
 public:
  static constexpr int bits = 21;  // an axis

  /// half_size: of the bounding box; diameter: of a cell, at least least_diameter(half_size).
  CellGrid(const Vector3& half_size, double diameter)
      : half_size_(half_size),
        side_(diameter / (root_three * (1.0 + aside))),
        per_side_(1.0 / side_) {
    for (int k = 0; k < 3; ++k) {
      const double half = half_size[k] * per_side_;
      const bool one_cell = 2.0 * half <= 1.0;
      before_[k] = one_cell ? 0.5 : std::ceil(half) + aside;
      last_[k] = one_cell ? 0 : 2 * static_cast<std::uint32_t>(std::ceil(half)) - 1;
    }
  }

  /// At which the longest axis has as many cells as a key can hold, but for rounding.
  static double least_diameter(const Vector3& half_size) {
    constexpr double most_on_a_side = (1 << (bits - 1)) - 2;
    return root_three * (1.0 + aside) * half_size.maxCoeff() / most_on_a_side;
  }

  /// At which all is one cell.
  static double largest_diameter(const Vector3& half_size) {
    return root_three * (1.0 + aside) * 2.0 * half_size.maxCoeff();
  }

  CellKey key(const Vector3& p) const {
    return place(p, 0) | place(p, 1) << bits | place(p, 2) << (2 * bits);
  }

  CellBox box(CellKey key) const {
    CellBox box;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t place = key >> (k * bits) & mask;
      const double low = side_ * (place - before_[k]);
      box.low[k] = std::max(low, -half_size_[k]);
      box.high[k] = place == last_[k] ? half_size_[k] : low + side_;
    }
    return box;
  }

  double side() const { return side_; }

 private:
  /// Part of a side between the middle and the border: rounding must not scatter a plane of
  /// symmetry over both sides of a border. The last cell of an axis is larger by as much.
  static constexpr double aside = 1.0 / 1024.0;
  static constexpr double root_three = 1.7320508075688774;
  static constexpr CellKey mask = (CellKey(1) << bits) - 1;

  CellKey place(const Vector3& p, int k) const {
    return std::min(static_cast<std::uint32_t>(p[k] * per_side_ + before_[k]), last_[k]);
  }

  Vector3 half_size_;
  double side_, per_side_;
  std::array<double, 3> before_;  // cells before the middle, by axis
  std::array<std::uint32_t, 3> last_;
};

}  // namespace curvdecim::detail
