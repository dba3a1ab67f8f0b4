// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/vector3.h"

namespace curvdecim::detail {

/// The least box around some points; empty as it is made.
struct Box {
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 high = -low;

  void add(const Vector3& p) { low = low.cwiseMin(p), high = high.cwiseMax(p); }
};

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

  void set(int i, const Box& box) {
    for (int k = 0; k < 3; ++k) low_[k][i] = below(box.low[k]), high_[k][i] = above(box.high[k]);
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

/// A complete tree of boxes with four children a node, to find what is nearest: its leaves are
/// numbered in a row, and what is in them is its owner's.
class BoxTree {
 public:
  /// leaves: at least one.
  explicit BoxTree(int leaves)
      : leaves_(leaves), first_leaf_(std::max(1, (leaves + 1) / 3)), boxes_(first_leaf_) {}

  /// Sets all boxes, level by level, from the leaves to the root. box_of(leaf) gives a Box;
  /// for_each(count, work) calls work(i) for every i below count.
  template <class ForEach, class BoxOf>
  void fit(ForEach for_each, BoxOf box_of) {
    int end = first_leaf_ + leaves_;
    for (int first = first_of_level(end - 1); first > 0; first = parent(first)) {
      for_each(end - first, [&](int i) { fit_box(first + i, box_of); });
      end = first;
    }
  }

  /// Calls visit(leaf) for every leaf that may have something nearer to p than the root of limit2,
  /// the nearer ones first; visit lowers limit2.
  template <class Visit>
  void visit_near(const Vector3& p, const double& limit2, Visit visit) const {
    constexpr int most = 64;  // three of each level, of which there are no more than 16
    const FourBoxes::Place place(p);
    std::array<Waiting, most> stack;
    int waiting = 0;
    stack[waiting++] = {0, 0.0f};
    while (waiting > 0) {
      const auto [node, distance2] = stack[--waiting];
      if (distance2 >= limit2) continue;
      if (node < first_leaf_)
        waiting = push_children(node, place, limit2, stack.data(), waiting);
      else
        visit(node - first_leaf_);
    }
  }

 private:
  static constexpr int width = FourBoxes::count;

  struct Waiting {
    int node;
    float distance2;
  };

  static int parent(int node) { return (node - 1) / width; }
  static int child(int node, int i) { return width * node + 1 + i; }
  static int first_of_level(int node) {
    int first = 0;
    while (child(first, 0) <= node) first = child(first, 0);
    return first;
  }

  template <class BoxOf>
  void fit_box(int node, BoxOf& box_of) {
    FourBoxes& boxes = boxes_[parent(node)];
    const int place = node - child(parent(node), 0);
    node < first_leaf_ ? boxes.set(place, boxes_[node])
                       : boxes.set(place, box_of(node - first_leaf_));
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

  int leaves_;
  int first_leaf_;                // nodes before it have children, from child(node, 0)
  std::vector<FourBoxes> boxes_;  // of the children of a node
};

}  // namespace curvdecim::detail
