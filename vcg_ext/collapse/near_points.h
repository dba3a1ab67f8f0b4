// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/geometry/vector3.h"
#include "vcg_ext/parallel/radix_sort.h"

namespace curvdecim::detail {

/// Points in a grid of cells as wide as a distance, sorted by cell, so that those within the
/// distance of a point lie in the 27 cells around. Coordinates from -0.5 to 0.5.
class NearPoints {
 public:
  /// which: the points that count, ascending; distance > 0.
  NearPoints(const std::vector<Vector3>& points, const std::vector<int>& which, double distance,
             const Parallel& parallel)
      : points_(points),
        distance_(distance),
        order_(sorted_by_key(static_cast<int>(which.size()), 3 * bits, parallel, [&](int i) {
          return Keyed{key(points[which[i]]), which[i]};
        })) {}

  /// use(p, q) for every two points that are closer than the distance, once. Time: O(n + pairs).
  template <class Use>
  void for_each_pair(Use use) const {
    // What lies ahead of a cell: the rows of three cells that follow its own. Where each begins
    // only moves on.
    constexpr std::array<std::uint64_t, 4> rows = {next_row, next_layer - next_row, next_layer,
                                                   next_layer + next_row};
    std::array<std::size_t, rows.size()> begin{};
    for (std::size_t i = 0; i < order_.size(); ++i) {
      meet(i, i + 1, order_[i].key + 1, use);
      for (std::size_t r = 0; r < rows.size(); ++r) {
        const std::uint64_t middle = order_[i].key + rows[r];
        while (begin[r] < order_.size() && order_[begin[r]].key < middle - 1) ++begin[r];
        meet(i, begin[r], middle + 1, use);
      }
    }
  }

 private:
  static constexpr int bits = 21;  // of a key, an axis
  static constexpr std::uint64_t next_row = std::uint64_t{1} << bits;
  static constexpr std::uint64_t next_layer = next_row << bits;

  /// The first cell of an axis has place 1, so that each has neighbours in the key.
  std::uint64_t key(const Vector3& p) const {
    constexpr double most_cells = 1 << (bits - 1);
    constexpr double ample = 1.0 + 1.0 / 1024.0;  // of the distance: rounding skips no cell
    const double side = std::max(ample * distance_, 1.0 / most_cells);
    const auto place = [side](double x) {
      return static_cast<std::uint64_t>((x + 0.5) / side) + 1;
    };
    return place(p.x()) + place(p.y()) * next_row + place(p.z()) * next_layer;
  }

  /// Point i of the order with those from j on, up to a key.
  template <class Use>
  void meet(std::size_t i, std::size_t j, std::uint64_t last_key, Use use) const {
    const Vector3& p = points_[order_[i].value];
    for (; j < order_.size() && order_[j].key <= last_key; ++j)
      if ((points_[order_[j].value] - p).squaredNorm() < distance_ * distance_)
        use(order_[i].value, order_[j].value);
  }

  const std::vector<Vector3>& points_;
  const double distance_;
  Array<Keyed> order_;  // points by their cells
};

}  // namespace curvdecim::detail
