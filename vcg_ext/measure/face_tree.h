// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

#include "vcg_ext/geometry/box_tree.h"
#include "vcg_ext/mesh/triangle_tree.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// Puts things in the order of a complete tree of four children a node, all leaves on one level: a
/// node's are halved by the median along their longest side, and each half once more. Boxes around
/// them overlap less than in the order of a curve, which is sorted faster.
class MedianOrder {
 public:
  /// center_of(i): of thing i.
  template <class CenterOf>
  MedianOrder(int count, CenterOf center_of, const Parallel& parallel)
      : things_(count), leaves_(leaves_for(count)) {
    parallel.for_each(count, [&](int i) { things_[i] = {center_of(i), i}; });
    const int blocks = std::min(leaves_, most_blocks);
    for (int parts = 1; parts < blocks; parts *= 2)
      parallel.for_each(
          parts, [&](int i) { halve(i, parts); }, Grain{1, parts});
    parallel.for_each(
        blocks, [&](int i) { halve_down_to_leaves(i, blocks); }, Grain{1, blocks});
  }

  int leaves() const { return leaves_; }
  int operator[](int place) const { return things_[place].number; }

  /// The first place of a leaf, or of one of `parts` equal shares of all leaves.
  int begin_of(int leaf) const { return begin_of(leaf, leaves_); }

 private:
  static constexpr int most_blocks = 64;  // that threads take as a whole

  struct Thing {
    Vector3 center;
    int number;
  };

  /// As many leaves as a level can have, none of which is empty: one to three things each.
  static int leaves_for(int count) {
    int leaves = 1;
    while (leaves <= count / 4) leaves *= 4;
    return leaves;
  }

  int begin_of(int part, int parts) const {
    return static_cast<int>(static_cast<std::int64_t>(things_.size()) * part / parts);
  }

  void halve(int part, int parts) {
    const auto begin = things_.begin() + begin_of(part, parts);
    const auto middle = things_.begin() + begin_of(2 * part + 1, 2 * parts);
    const auto end = things_.begin() + begin_of(part + 1, parts);
    Box box;
    for (auto each = begin; each != end; ++each) box.add(each->center);
    int side = 0;
    (box.high - box.low).maxCoeff(&side);
    std::nth_element(begin, middle, end, [side](const Thing& a, const Thing& b) {
      return std::tie(a.center[side], a.number) < std::tie(b.center[side], b.number);
    });
  }

  void halve_down_to_leaves(int part, int parts) {
    if (parts == leaves_) return sort_leaf(part);
    halve(part, parts);
    halve_down_to_leaves(2 * part, 2 * parts);
    halve_down_to_leaves(2 * part + 1, 2 * parts);
  }

  /// So that the order is the same with every standard library.
  void sort_leaf(int leaf) {
    std::sort(things_.begin() + begin_of(leaf), things_.begin() + begin_of(leaf + 1),
              [](const Thing& a, const Thing& b) { return a.number < b.number; });
  }

  std::vector<Thing> things_;
  int leaves_;
};

/// Faces, to find the nearest ones of very many points: beside them their normals, and in the
/// order of a tree with boxes that overlap little.
class FaceTree {
 public:
  /// faces: at least one. triangle_of(i): face i, within a few diagonals of a box of diagonal 1.
  template <class TriangleOf>
  FaceTree(int faces, TriangleOf triangle_of, const Parallel& parallel)
      : order_(
            faces, [&](int i) { return center_of(triangle_of(i)); }, parallel),
        faces_(faces),
        place_(faces),
        boxes_(order_.leaves()) {
    parallel.for_each(faces, [&](int place) {
      const Triangle t = triangle_of(order_[place]);
      faces_[place] = {t, (t[1] - t[0]).cross(t[2] - t[0])};
      place_[order_[place]] = place;
    });
    boxes_.fit([&](int count, auto work) { parallel.for_each(count, work); },
               [&](int leaf) { return box_of(leaf); });
  }

  /// hint: a face near by, to look at first, or SurfacePoint::none.
  SurfacePoint nearest(const Vector3& p, int hint) const {
    SurfacePoint best;
    if (hint != SurfacePoint::none) look_at(place_[hint], p, best);
    boxes_.visit_near(p, best.distance2, [&](int leaf) {
      for (int i = order_.begin_of(leaf); i < order_.begin_of(leaf + 1); ++i) look_at(i, p, best);
    });
    if (best.found()) best.face = order_[best.face];
    return best;
  }

  /// use(face) for every face that may be nearer to p than the root of limit2, and some others.
  template <class Use>
  void visit_near(const Vector3& p, double limit2, Use use) const {
    boxes_.visit_near(p, limit2, [&](int leaf) {
      for (int i = order_.begin_of(leaf); i < order_.begin_of(leaf + 1); ++i) use(order_[i]);
    });
  }

 private:
  struct Face {
    Triangle triangle;
    Vector3 normal;  // of any length
  };

  Box box_of(int leaf) const {
    Box box;
    for (int i = order_.begin_of(leaf); i < order_.begin_of(leaf + 1); ++i)
      for (const Vector3& p : faces_[i].triangle) box.add(p);
    return box;
  }

  /// best.face: a place.
  void look_at(int place, const Vector3& p, SurfacePoint& best) const {
    detail::look_at(faces_[place].triangle, faces_[place].normal, place, p, best);
  }

  MedianOrder order_;
  Array<Face> faces_;       // by place
  std::vector<int> place_;  // by face
  BoxTree boxes_;
};

}  // namespace curvdecim::detail
