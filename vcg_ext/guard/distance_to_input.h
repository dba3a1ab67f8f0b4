// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "vcg_ext/guard/cover.h"
#include "vcg_ext/guard/near_faces.h"
#include "vcg_ext/guard/reference_surface.h"
#include "vcg_ext/guard/sheet_over_face.h"

namespace curvdecim::detail {

/// How far the points of a triangle are from the input at most: the height of the sheet of the
/// input over it (sheet_over_face.h), and the distance of what that does not tell (cover.h). One
/// triangle at a time.
class DistanceToInput {
 public:
  using Tree = TriangleTree<ReferenceSurface>;

  DistanceToInput(const ReferenceSurface& input, const Tree& tree, double limit)
      : tree_(tree), limit_(limit), sheet_(input) {}

  /// The face of the input nearest to the middle; none where that is further away than the limit.
  int near_middle(const Triangle& t, int hint) const {
    return tree_.nearest_within(center_of(t), limit_ * limit_, hint).face;
  }

  /// Infinite where it is above the limit, or cannot be told after so many parts. start: near the
  /// middle. Calls lies_over(r, height) with faces of the input that are near the triangle,
  /// whatever the answer is; not with all.
  template <class LiesOver>
  double of(const Triangle& t, int start, int most_parts, LiesOver lies_over) {
    const auto sheet = sheet_.find(t, start, limit_, lies_over);
    if (!sheet) cover_.add(ConvexPolygon(t));
    for (int i = 0; sheet && i < 3; ++i)
      if (sheet->untold[i] > 0.0) cover_.add(strip(t, i, sheet->untold[i]));
    used_.clear();
    const auto beside = cover_.distance(limit_, most_parts,
                                        NearInTree<ReferenceSurface>(tree_, limit_, start, used_));
    if (!beside) return HUGE_VAL;
    return std::max(*beside, sheet ? sheet->height : 0.0);
  }

 private:
  /// Where the barycentric coordinate of a corner is no more than `share`.
  static ConvexPolygon strip(const Triangle& t, int corner, double share) {
    HalfSpace inside = inside_of_edge(t, (corner + 1) % 3);
    inside.offset += share * inside.depth(t[corner]);
    return ConvexPolygon(t).inside(inside.opposite());
  }

  const Tree& tree_;
  double limit_;
  SheetOverFace sheet_;
  Cover cover_;
  std::vector<int> used_;
};

}  // namespace curvdecim::detail
