// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/vector3.h"

namespace curvdecim::detail {

/// Points in a k-d tree: each node's point parts those before it from those after it, along the
/// axis in which they spread furthest.
class PointTree {
 public:
  static constexpr int none = -1;

  explicit PointTree(std::vector<Vector3> points)
      : points_(std::move(points)), order_(points_.size()), axis_(points_.size(), 0) {
    std::iota(order_.begin(), order_.end(), 0);
    build(0, size());
  }

  /// The nearest point for which accept(i) holds, or none.
  template <class Accept>
  int nearest(const Vector3& p, Accept accept) const {
    Best best;
    search(0, size(), p, accept, best);
    return best.point;
  }

  int size() const { return static_cast<int>(points_.size()); }

 private:
  struct Best {
    double distance2 = std::numeric_limits<double>::infinity();
    int point = none;
  };

  void build(int begin, int end) {
    if (end - begin < 2) return;
    Vector3 low = points_[order_[begin]], high = low;
    for (int i = begin; i < end; ++i)
      low = low.cwiseMin(points_[order_[i]]), high = high.cwiseMax(points_[order_[i]]);
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const int middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](int a, int b) {
                       const double x = points_[a][axis], y = points_[b][axis];
                       return x == y ? a < b : x < y;
                     });
    axis_[middle] = static_cast<std::uint8_t>(axis);
    build(begin, middle), build(middle + 1, end);
  }

  template <class Accept>
  void search(int begin, int end, const Vector3& p, Accept accept, Best& best) const {
    if (begin >= end) return;
    const int middle = begin + (end - begin) / 2, point = order_[middle];
    const double distance2 = (points_[point] - p).squaredNorm();
    if (distance2 < best.distance2 && accept(point)) best = {distance2, point};
    const double ahead = p[axis_[middle]] - points_[point][axis_[middle]];
    const bool after = ahead > 0.0;
    after ? search(middle + 1, end, p, accept, best) : search(begin, middle, p, accept, best);
    if (ahead * ahead >= best.distance2) return;
    after ? search(begin, middle, p, accept, best) : search(middle + 1, end, p, accept, best);
  }

  std::vector<Vector3> points_;
  std::vector<int> order_;          // a tree over ranges: the middle is the node
  std::vector<std::uint8_t> axis_;  // by place in the order
};

}  // namespace curvdecim::detail
