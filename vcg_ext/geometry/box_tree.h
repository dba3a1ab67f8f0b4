// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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
  void add(const Box& o) { low = low.cwiseMin(o.low), high = high.cwiseMax(o.high); }

  bool is_empty() const { return !(low[0] <= high[0]); }

  /// True if the boxes have a point in common.
  bool meets(const Box& o) const {
    return (low.array() <= o.high.array()).all() && (o.low.array() <= high.array()).all();
  }
};

/// The box around a triangle.
inline Box box_around(const std::array<Vector3, 3>& triangle) {
  Box box;
  for (const Vector3& p : triangle) box.add(p);
  return box;
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

    explicit Place(const Vector3& p) : Place(Box{p, p}) {}
    /// The numbers around a box that is not empty.
    explicit Place(const Box& box)
        : low{below(box.low[0]), below(box.low[1]), below(box.low[2])},
          high{above(box.high[0]), above(box.high[1]), above(box.high[2])} {}
    Place(const FourBoxes& boxes, int i)
        : low{boxes.low_[0][i], boxes.low_[1][i], boxes.low_[2][i]},
          high{boxes.high_[0][i], boxes.high_[1][i], boxes.high_[2][i]} {}

    bool operator==(const Place& o) const { return low == o.low && high == o.high; }
  };

  FourBoxes() {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    low_.fill(Four{} + infinity), high_.fill(Four{} - infinity);
  }

  void set(int i, const Box& box) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (int k = 0; k < 3; ++k) {
      low_[k][i] = box.is_empty() ? infinity : below(box.low[k]);
      high_[k][i] = box.is_empty() ? -infinity : above(box.high[k]);
    }
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

  /// Of each of the four, other than 0 if it may have a point of the box in it.
  auto meets(const Place& box) const {
    auto meets = (low_[0] <= box.high[0]) & (high_[0] >= box.low[0]);
    for (int k = 1; k < 3; ++k) meets &= (low_[k] <= box.high[k]) & (high_[k] >= box.low[k]);
    return meets;
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

/// A complete tree of boxes with four children a node, to find what is nearest, or what meets a
/// box: its leaves are numbered in a row, and what is in them is its owner's.
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

  /// Sets the boxes of a leaf and of what it is in. box_of(leaf) gives a Box.
  template <class BoxOf>
  void refit(int leaf, BoxOf box_of) {
    for (int node = first_leaf_ + leaf; node > 0; node = parent(node)) {
      const FourBoxes::Place before = place_of_node(node);
      fit_box(node, box_of);
      if (place_of_node(node) == before) return;  // what it is in has not changed either
    }
  }

  /// Asks found(leaf) of the leaves that may have a point of the box in them, until it is true for
  /// one; returns whether it was.
  template <class Found>
  bool any_meeting(const Box& box, Found found) const {
    const FourBoxes::Place place(box);
    std::array<int, most_waiting> stack;
    int waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
      const int node = stack[--waiting];
      if (node >= first_leaf_) {
        if (found(node - first_leaf_)) return true;
        continue;
      }
      const auto meets = boxes_[node].meets(place);
      for (int i = 0; i < width; ++i)
        if (meets[i] != 0) stack[waiting++] = child(node, i);
    }
    return false;
  }

  /// The box of a leaf.
  FourBoxes::Place place_of(int leaf) const { return place_of_node(first_leaf_ + leaf); }

  /// Two nodes whose boxes may have a point in common, the lower number first, or one with itself.
  struct NodePair {
    int a, b;
  };

  /// Pairs of nodes that hold all pairs of leaves that may meet: about `many`, if there are as
  /// many.
  std::vector<NodePair> meeting_pairs(std::size_t many) const {
    std::vector<NodePair> pairs{{0, 0}};
    const auto is_inner = [this](NodePair pair) { return pair.a < first_leaf_; };
    while (pairs.size() < many && std::any_of(pairs.begin(), pairs.end(), is_inner)) {
      std::vector<NodePair> opened;
      const auto add = [&](NodePair pair) { opened.push_back(pair); };
      for (NodePair pair : pairs) is_inner(pair) ? open(pair, add) : add(pair);
      pairs.swap(opened);
    }
    return pairs;
  }

  /// Calls use(leaf, leaf) for every two leaves in these nodes that may meet.
  template <class Use>
  void for_each_meeting(NodePair nodes, Use use) const {
    constexpr int most = 256;  // fifteen of each level, and one
    std::array<NodePair, most> stack;
    int waiting = 0;
    stack[waiting++] = nodes;
    while (waiting > 0) {
      const NodePair pair = stack[--waiting];
      if (pair.a < first_leaf_)
        open(pair, [&](NodePair inside) { stack[waiting++] = inside; });
      else if (pair.a != pair.b)
        use(pair.a - first_leaf_, pair.b - first_leaf_);
    }
  }

  /// Calls visit(leaf) for every leaf that may have something nearer to p than the root of limit2,
  /// the nearer ones first; visit lowers limit2.
  template <class Visit>
  void visit_near(const Vector3& p, const double& limit2, Visit visit) const {
    const FourBoxes::Place place(p);
    std::array<Waiting, most_waiting> stack;
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
  static constexpr int most_waiting = 64;  // three of each level, of which there are at most 16

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

  FourBoxes::Place place_of_node(int node) const {
    return {boxes_[parent(node)], node - child(parent(node), 0)};
  }

  /// Calls add(pair) for the pairs of children that may meet. A leaf has itself for its only one;
  /// a is none.
  template <class Add>
  void open(NodePair pair, Add add) const {
    if (pair.b >= first_leaf_) return open_against(pair.a, 0, place_of_node(pair.b), pair.b, add);
    for (int i = 0; i < width; ++i)
      open_against(pair.b, pair.a == pair.b ? i : 0, {boxes_[pair.a], i}, child(pair.a, i), add);
  }

  /// The children of a node, from the `first` on, that may meet another one in this place.
  template <class Add>
  void open_against(int node, int first, const FourBoxes::Place& place, int other, Add add) const {
    const auto meets = boxes_[node].meets(place);
    for (int i = first; i < width; ++i)
      if (meets[i] != 0)
        add(NodePair{std::min(child(node, i), other), std::max(child(node, i), other)});
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
