// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cassert>

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim::detail {

/// A half-space: the points with normal . p >= offset.
struct HalfSpace {
  Vector3 normal;
  double offset;

  double depth(const Vector3& p) const { return normal.dot(p) - offset; }
  HalfSpace opposite() const { return {-normal, -offset}; }
};

/// The points that lie, seen along the triangle's normal, on the inner side of its edge i, i+1.
inline HalfSpace inside_of_edge(const Triangle& t, int i) {
  const Vector3 normal = area_vector(t).cross(t[(i + 1) % 3] - t[i]);
  return {normal, normal.dot(t[i])};
}

/// Calls add(p) with the corners of what a plane leaves of a convex polygon. depth(p): linear, not
/// below 0 on the side that is kept.
template <class Depth, class Add>
void clip(const Vector3* corner, int size, Depth depth, Add add) {
  for (int i = 0; i < size; ++i) {
    const Vector3 &p = corner[i], &q = corner[i + 1 < size ? i + 1 : 0];
    const double at_p = depth(p), at_q = depth(q);
    if (at_p >= 0.0) add(p);
    if ((at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0))
      add(p + (at_p / (at_p - at_q)) * (q - p));
  }
}

/// A part of a triangle that cuts along planes have left; it is convex.
class ConvexPolygon {
 public:
  static constexpr int most_corners = 16;

  ConvexPolygon() = default;
  explicit ConvexPolygon(const Triangle& t) {
    for (const Vector3& p : t) add(p);
  }

  int size() const { return size_; }
  const Vector3* begin() const { return corner_.data(); }
  const Vector3* end() const { return corner_.data() + size_; }

  /// One more cut has room on both sides.
  bool may_be_cut() const { return size_ < most_corners; }

  Vector3 middle() const {
    Vector3 sum = Vector3::Zero();
    for (const Vector3& p : *this) sum += p;
    return sum / size_;
  }

  double area() const {
    Vector3 sum = Vector3::Zero();
    for (int i = 2; i < size_; ++i) sum += area_vector(corner_[0], corner_[i - 1], corner_[i]);
    return sum.norm();
  }

  /// What lies in the half-space; of fewer than three corners where nothing does.
  ConvexPolygon inside(const HalfSpace& space) const {
    assert(may_be_cut());
    ConvexPolygon part;
    clip(
        corner_.data(), size_, [&](const Vector3& p) { return space.depth(p); },
        [&](const Vector3& p) { part.add(p); });
    return part;
  }

 private:
  void add(const Vector3& p) { corner_[size_++] = p; }

  std::array<Vector3, most_corners> corner_{};
  int size_ = 0;
};

}  // namespace curvdecim::detail
