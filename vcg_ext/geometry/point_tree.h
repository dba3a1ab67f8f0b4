// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/box_tree.h"

namespace curvdecim::detail {

/// Points in boxes, to find the nearest: as many as fit in a leaf, in the order that they are given
/// in. The nearer those in a row are to each other the faster it is.
class PointTree {
 public:
  static constexpr int none = -1;

  explicit PointTree(std::vector<Vector3> points)
      : points_(std::move(points)), boxes_(std::max(1, (size() + leaf_size - 1) / leaf_size)) {
    const auto for_each = [](int count, auto work) {
      for (int i = 0; i < count; ++i) work(i);
    };
    boxes_.fit(for_each, [&](int leaf) {
      Box box;
      for (int i = begin_of(leaf); i < begin_of(leaf + 1); ++i) box.add(points_[i]);
      return box;
    });
  }

  /// The nearest point for which accept(i) holds, or none. Of several it is always the same.
  template <class Accept>
  int nearest(const Vector3& p, Accept accept) const {
    double least2 = std::numeric_limits<double>::infinity();
    int best = none;
    boxes_.visit_near(p, least2, [&](int leaf) {
      for (int i = begin_of(leaf); i < begin_of(leaf + 1); ++i) {
        const double distance2 = (points_[i] - p).squaredNorm();
        if (distance2 < least2 && accept(i)) least2 = distance2, best = i;
      }
    });
    return best;
  }

  int size() const { return static_cast<int>(points_.size()); }

 private:
  static constexpr int leaf_size = 8;

  int begin_of(int leaf) const { return std::min(size(), leaf * leaf_size); }

  std::vector<Vector3> points_;
  BoxTree boxes_;
};

}  // namespace curvdecim::detail
