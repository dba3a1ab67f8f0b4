// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/mesh/triangle_tree.h"

namespace curvdecim::detail {

/// All faces of a surface that are within a limit, for Cover; collects those that parts were near.
template <class Surface>
class NearInTree {
 public:
  /// hint: a face near by, or SurfacePoint::none.
  NearInTree(const TriangleTree<Surface>& tree, double limit, int hint, std::vector<int>& used)
      : tree_(tree), limit2_(limit * limit), hint_(hint), used_(used) {}

  int nearest(const Vector3& p) const { return tree_.nearest_within(p, limit2_, hint_).face; }
  Triangle triangle(int f) const { return tree_.surface().triangle(f); }
  void use(int f) { hint_ = f, used_.push_back(f); }

 private:
  const TriangleTree<Surface>& tree_;
  double limit2_;
  int hint_;
  std::vector<int>& used_;
};

struct NumberedFace {
  int number;
  Triangle triangle;
};

/// The same of some faces; collects their numbers.
class NearInList {
 public:
  NearInList(const std::vector<NumberedFace>& faces, double limit, std::vector<int>& used)
      : faces_(faces), limit2_(limit * limit), used_(used) {}

  int nearest(const Vector3& p) const {
    SurfacePoint best;
    best.distance2 = limit2_;
    for (std::size_t i = 0; i < faces_.size(); ++i)
      look_at(*this, static_cast<int>(i), p, any_face, best);
    return best.face;
  }
  const Triangle& triangle(int i) const { return faces_[i].triangle; }
  void use(int i) { used_.push_back(faces_[i].number); }

 private:
  const std::vector<NumberedFace>& faces_;
  double limit2_;
  std::vector<int>& used_;
};

}  // namespace curvdecim::detail
