// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/geometry/morton.h"
#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// A point of a surface, and how far it is from where one asked.
struct SurfacePoint {
  static constexpr int none = -1;

  int face = none;
  Barycentric weight{};
  double distance2 = std::numeric_limits<double>::infinity();

  bool found() const { return face != none; }
};

/// For searches: takes every face.
inline bool any_face(const Vector3&) { return true; }

/// The point of face f nearest to p, if `accept` takes the face's normal (of any length) and it is
/// nearer than `best`.
template <class Surface, class Accept>
void look_at(const Surface& surface, int f, const Vector3& p, Accept accept, SurfacePoint& best) {
  const Triangle t = surface.triangle(f);
  const Vector3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  if (!accept(normal)) return;
  const double height = normal.dot(p - t[0]);
  if (height * height > best.distance2 * normal.squaredNorm()) return;  // so is its plane already
  const Barycentric weight = closest_point(t, normal, p);
  const double distance2 = (at(t, weight) - p).squaredNorm();
  if (distance2 < best.distance2) best = {f, weight, distance2};
}

/// Four boxes in single precision, rounded outwards, on which the processor works at once; as they
/// are made, there is nothing in them.
class FourBoxes {
 public:
  static constexpr int count = 4;
  using Four = float __attribute__((vector_size(count * sizeof(float))));

  /// A point, and around it the numbers that single precision has.
  struct Place {
    std::array<float, 3> low, high;

    explicit Place(const Vector3& p)
        : low{below(p[0]), below(p[1]), below(p[2])}, high{above(p[0]), above(p[1]), above(p[2])} {}
  };

  FourBoxes() {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    low_.fill(Four{} + infinity), high_.fill(Four{} - infinity);
  }

  void set(int i, const Vector3& low, const Vector3& high) {
    for (int k = 0; k < 3; ++k) low_[k][i] = below(low[k]), high_[k][i] = above(high[k]);
  }

  /// Box i around all of the others.
  void set(int i, const FourBoxes& others) {
    for (int k = 0; k < 3; ++k) {
      const Four& low = others.low_[k];
      const Four& high = others.high_[k];
      low_[k][i] = std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
      high_[k][i] = std::max(std::max(high[0], high[1]), std::max(high[2], high[3]));
    }
  }

  /// To each of the four, or a little less.
  Four distance2(const Place& p) const {
    constexpr float surely = 1.0f - 8.0f * unit;  // the sum's own rounding
    Four sum{};
    for (int k = 0; k < 3; ++k) {
      const Four under = low_[k] - p.high[k], over = p.low[k] - high_[k];
      const Four outside = under > over ? under : over;
      const Four distance = outside > Four{} ? outside : Four{};
      sum += distance * distance;
    }
    return surely * sum;
  }

 private:
  static constexpr float unit = std::numeric_limits<float>::epsilon();

  static float below(double x) {
    const float nearest = static_cast<float>(x);
    return nearest - (unit * std::abs(nearest) + std::numeric_limits<float>::min());
  }
  static float above(double x) { return -below(-x); }

  std::array<Four, 3> low_, high_;  // by axis
};

/// Boxes around the faces of a surface in a box of diagonal 1, to find nearest points: leaves of
/// some faces each in the order of a space-filling curve, and a complete tree over them with four
/// children a node.
///
/// Surface: triangle(f). Its vertices may move, if refit is called afterwards.
template <class Surface>
class TriangleTree {
 public:
  TriangleTree(const Surface& surface, int faces, const Parallel& parallel)
      : surface_(surface),
        order_(faces),
        first_leaf_(std::max(1, (leaf_count() + 1) / 3)),
        boxes_(first_leaf_) {
    assert(faces > 0);
    sort_faces(parallel);
    refit(parallel);
  }

  /// Level by level, from the leaves to the root.
  void refit(const Parallel& parallel) {
    int end = first_leaf_ + leaf_count();
    for (int first = first_of_level(end - 1); first > 0; first = parent(first)) {
      parallel.for_each(end - first, [&](int i) { fit_box(first + i); });
      end = first;
    }
  }

  /// hint: a face near by, to look at first, or SurfacePoint::none.
  SurfacePoint nearest(const Vector3& p, int hint) const {
    return search(p, hint, std::numeric_limits<double>::infinity(), any_face);
  }

  /// The nearest point on faces that do not face away from `normal`, within the root of limit2; not
  /// found where there is none.
  SurfacePoint nearest_facing(const Vector3& p, const Vector3& normal, double limit2,
                              int hint) const {
    return search(p, hint, limit2, [&](const Vector3& n) { return n.dot(normal) >= 0.0; });
  }

  const Surface& surface() const { return surface_; }

 private:
  static constexpr int leaf_size = 2;
  static constexpr int width = FourBoxes::count;

  static int parent(int node) { return (node - 1) / width; }
  static int child(int node, int i) { return width * node + 1 + i; }
  static int first_of_level(int node) {
    int first = 0;
    while (child(first, 0) <= node) first = child(first, 0);
    return first;
  }

  int face_count() const { return static_cast<int>(order_.size()); }
  int leaf_count() const { return (face_count() + leaf_size - 1) / leaf_size; }

  void sort_faces(const Parallel& parallel) {
    std::vector<std::pair<std::uint64_t, int>> keys(order_.size());
    parallel.for_each(face_count(), [&](int f) {
      const Vector3 center = center_of(surface_.triangle(f));
      keys[f] = {morton_code(center.cwiseMax(-0.5).cwiseMin(0.5)), f};
    });
    parallel.sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < keys.size(); ++i) order_[i] = keys[i].second;
  }

  void fit_box(int node) {
    FourBoxes& boxes = boxes_[parent(node)];
    const int place = node - child(parent(node), 0);
    if (node < first_leaf_) return boxes.set(place, boxes_[node]);
    Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (int f : leaf(node))
      for (const Vector3& p : surface_.triangle(f)) low = low.cwiseMin(p), high = high.cwiseMax(p);
    boxes.set(place, low, high);
  }

  IndexRange leaf(int node) const {
    const int begin = (node - first_leaf_) * leaf_size;
    return {order_.data() + begin, order_.data() + std::min(face_count(), begin + leaf_size)};
  }

  struct Waiting {
    int node;
    float distance2;
  };

  template <class Accept>
  SurfacePoint search(const Vector3& p, int hint, double limit2, Accept accept) const {
    constexpr int most = 64;  // three of each level, of which there are no more than 16
    SurfacePoint best;
    best.distance2 = limit2;
    if (hint != SurfacePoint::none) look_at(surface_, hint, p, accept, best);
    const FourBoxes::Place place(p);
    std::array<Waiting, most> stack;
    int waiting = 0;
    stack[waiting++] = {0, 0.0f};
    while (waiting > 0) {
      const auto [node, distance2] = stack[--waiting];
      if (distance2 >= best.distance2) continue;
      if (node < first_leaf_)
        waiting = push_children(node, place, best.distance2, stack.data(), waiting);
      else
        for (int f : leaf(node)) look_at(surface_, f, p, accept, best);
    }
    return best;
  }

  /// Those near enough, the nearest on top.
  int push_children(int node, const FourBoxes::Place& p, double limit2, Waiting* stack,
                    int waiting) const {
    const FourBoxes::Four distance2 = boxes_[node].distance2(p);
    const int bottom = waiting;
    for (int i = 0; i < width; ++i) {
      if (distance2[i] >= limit2) continue;
      stack[waiting] = {child(node, i), distance2[i]};
      if (waiting > bottom && stack[waiting - 1].distance2 < distance2[i])
        std::swap(stack[waiting - 1], stack[waiting]);
      ++waiting;
    }
    return waiting;
  }

  const Surface& surface_;
  std::vector<int> order_;        // faces along the curve
  int first_leaf_;                // nodes before it have children, from child(node, 0)
  std::vector<FourBoxes> boxes_;  // of the children of a node
};

}  // namespace curvdecim::detail
