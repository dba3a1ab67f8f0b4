// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/geometry/morton.h"
#include "vcg_ext/parallel.h"

namespace curvdecim {

/// A point of a surface, and how far it is from where one asked.
struct SurfacePoint {
  static constexpr int none = -1;

  int face = none;
  Barycentric weight{};
  double distance2 = std::numeric_limits<double>::infinity();

  bool found() const { return face != none; }
};

/// Boxes around the faces of a surface in a box of diagonal 1, to find nearest points: leaves of
/// some faces each in the order of a space-filling curve, and a complete binary tree over them.
///
/// Surface: triangle(f) and plane[f]. Its vertices may move, if refit is called afterwards.
template <class Surface>
class TriangleTree {
 public:
  TriangleTree(const Surface& surface, int faces, const Parallel& parallel)
      : surface_(surface), order_(faces) {
    sort_faces(parallel);
    while (first_leaf_ < leaf_count()) first_leaf_ *= 2;
    boxes_.resize(2 * first_leaf_);
    refit(parallel);
  }

  void refit(const Parallel& parallel) {
    parallel.for_each(leaf_count(), [&](int leaf) { boxes_[first_leaf_ + leaf] = box_of(leaf); });
    for (int level = first_leaf_ / 2; level > 0; level /= 2)
      parallel.for_each(level, [&](int i) {
        const int node = level + i;
        boxes_[node] = join(boxes_[2 * node], boxes_[2 * node + 1]);
      });
  }

  /// hint: a face near by, to look at first, or SurfacePoint::none.
  SurfacePoint nearest(const Vector3& p, int hint) const {
    return search(p, hint, std::numeric_limits<double>::infinity(), [](int) { return true; });
  }

  /// Of the faces that do not face away from `normal`, closer than the root of limit2; not found
  /// where there is none.
  SurfacePoint nearest_facing(const Vector3& p, const Vector3& normal, double limit2,
                              int hint) const {
    return search(p, hint, limit2,
                  [&](int f) { return surface_.plane[f].normal.dot(normal) >= 0.0; });
  }

 private:
  static constexpr int leaf_size = 4;

  struct Box {
    Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
    Vector3 high = -low;

    double distance2(const Vector3& p) const {
      return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
    }
  };

  static Box join(const Box& a, const Box& b) {
    return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
  }

  int face_count() const { return static_cast<int>(order_.size()); }
  int leaf_count() const { return (face_count() + leaf_size - 1) / leaf_size; }

  void sort_faces(const Parallel& parallel) {
    std::vector<std::pair<std::uint64_t, int>> keys(order_.size());
    parallel.for_each(face_count(), [&](int f) {
      const Triangle t = surface_.triangle(f);
      const Vector3 center = (t[0] + t[1] + t[2]) / 3.0;
      keys[f] = {morton_code(center.cwiseMax(-0.5).cwiseMin(0.5)), f};
    });
    parallel.sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < keys.size(); ++i) order_[i] = keys[i].second;
  }

  Box box_of(int leaf) const {
    Box box;
    for (int i = leaf * leaf_size; i < end_of(leaf); ++i)
      for (const Vector3& p : surface_.triangle(order_[i]))
        box.low = box.low.cwiseMin(p), box.high = box.high.cwiseMax(p);
    return box;
  }

  int end_of(int leaf) const { return std::min(face_count(), (leaf + 1) * leaf_size); }

  struct Waiting {
    int node;
    double distance2;
  };

  template <class Accept>
  SurfacePoint search(const Vector3& p, int hint, double limit2, Accept accept) const {
    constexpr int deepest = 64;  // a level of the tree each
    SurfacePoint best;
    best.distance2 = limit2;
    if (hint != SurfacePoint::none && accept(hint)) look_at(hint, p, best);
    std::array<Waiting, deepest> stack;
    int waiting = 0;
    stack[waiting++] = {1, boxes_[1].distance2(p)};
    while (waiting > 0) {
      const auto [node, distance2] = stack[--waiting];
      if (distance2 >= best.distance2) continue;
      const int leaf = descend(node, p, best.distance2, stack.data(), waiting) - first_leaf_;
      for (int i = leaf * leaf_size; leaf >= 0 && i < end_of(leaf); ++i)
        if (accept(order_[i])) look_at(order_[i], p, best);
    }
    return best;
  }

  /// To the leaf at the end of the nearer children; the farther ones have to wait. Above the
  /// leaves where nothing is near enough.
  int descend(int node, const Vector3& p, double limit2, Waiting* stack, int& waiting) const {
    while (node < first_leaf_) {
      Waiting near{2 * node, boxes_[2 * node].distance2(p)};
      Waiting far{2 * node + 1, boxes_[2 * node + 1].distance2(p)};
      if (far.distance2 < near.distance2) std::swap(near, far);
      if (near.distance2 >= limit2) break;
      if (far.distance2 < limit2) stack[waiting++] = far;
      node = near.node;
    }
    return node;
  }

  void look_at(int f, const Vector3& p, SurfacePoint& best) const {
    const Triangle t = surface_.triangle(f);
    const double height = surface_.plane[f].normal.dot(p - t[0]);
    if (height * height >= best.distance2) return;  // its plane is further away already
    const Barycentric weight = closest_point(t, p);
    const double distance2 = (at(t, weight) - p).squaredNorm();
    if (distance2 < best.distance2) best = {f, weight, distance2};
  }

  const Surface& surface_;
  std::vector<int> order_;  // faces along the curve
  int first_leaf_ = 1;      // a power of two; node i has the children 2 i and 2 i + 1
  std::vector<Box> boxes_;  // by node, from 1
};

}  // namespace curvdecim
