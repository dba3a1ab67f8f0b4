// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/geometry/convex_polygon.h"

namespace curvdecim::detail {

/// Decides by branch and bound whether every point of some polygons is near one of some faces. The
/// distance to one face is a convex function, so that it is largest at a corner of a convex part:
///
///   while there are parts:
///     face <- the one nearest to the middle of a part
///     near it at every corner? this part is done
///     near no face at the middle, or at the farthest corner? not covered
///     cut the part along the face's edges, or in two
///
/// What is not decided after so many parts counts as not covered.
class Cover {
 public:
  static constexpr int none = -1;

  /// To be asked about.
  void add(const ConvexPolygon& part) {
    if (part.size() >= 3) parts_.push_back(part);
  }

  /// The largest distance of what was added; nullopt: not covered. Faces: nearest(p), the face
  /// nearest to p, or none where it is not within the limit; triangle(face); use(face), called with
  /// all that parts are near to.
  template <class Faces>
  std::optional<double> distance(double limit, int most_parts, Faces&& faces) {
    double largest2 = 0.0;
    for (int looked = 0; !parts_.empty(); ++looked) {
      const ConvexPolygon part = parts_.back();
      parts_.pop_back();
      const int face = looked < most_parts ? faces.nearest(part.middle()) : none;
      if (face == none) return give_up();
      const Triangle target = faces.triangle(face);
      const auto [distance2, corner] = farthest_corner(part, target);
      if (distance2 > limit * limit) {
        if (faces.nearest(corner) == none || !part.may_be_cut()) return give_up();
        divide(part, target, corner);
        continue;
      }
      largest2 = std::max(largest2, distance2);
      faces.use(face);
    }
    return std::sqrt(largest2);
  }

 private:
  std::optional<double> give_up() {
    parts_.clear();
    return std::nullopt;
  }

  struct Farthest {
    double distance2 = -1.0;
    Vector3 corner;
  };

  static Farthest farthest_corner(const ConvexPolygon& part, const Triangle& from) {
    Farthest farthest;
    for (const Vector3& p : part)
      if (const double distance2 = squared_distance(from, p); distance2 > farthest.distance2)
        farthest = {distance2, p};
    return farthest;
  }

  /// Along the edges of the face where that leaves more than chips, otherwise across the direction
  /// in which the corner is farthest from another one.
  void divide(const ConvexPolygon& part, const Triangle& face, const Vector3& corner) {
    constexpr int few_corners = 8;  // more cuts would have no room
    constexpr double chip = 0.03;   // area of a face, of the squared size of a part
    constexpr double line = 1e-8;  // area of a part of which cuts along it leave what rounding does
    const Vector3 opposite = farthest_from(corner, part), across = corner - opposite;
    const bool leaves_chips = area_vector(face).norm() < chip * across.squaredNorm();
    const bool is_line = part.area() < line * across.squaredNorm();
    if (part.size() < few_corners && !leaves_chips && !is_line && cut_along_edges(part, face))
      return;
    const HalfSpace half{across, across.dot(0.5 * (corner + opposite))};
    add(part.inside(half)), add(part.inside(half.opposite()));
  }

  static Vector3 farthest_from(const Vector3& corner, const ConvexPolygon& part) {
    return farthest_corner(part, {corner, corner, corner}).corner;
  }

  /// False if all of the part lies over the face, or nothing, but for what rounding leaves: that
  /// would be cut again and again.
  bool cut_along_edges(const ConvexPolygon& part, const Triangle& face) {
    constexpr double rounding = 1e-6;  // of the area
    const std::size_t before = parts_.size();
    ConvexPolygon over = part;
    for (int i = 0; i < 3; ++i) {
      const HalfSpace inside = inside_of_edge(face, i);
      add(over.inside(inside.opposite()));
      over = over.inside(inside);
    }
    const double all = part.area(), share = over.area();
    const bool is_cut = share > rounding * all && share < (1.0 - rounding) * all;
    if (is_cut)
      parts_.push_back(over);
    else
      parts_.resize(before);
    return is_cut;
  }

  std::vector<ConvexPolygon> parts_;
};

}  // namespace curvdecim::detail
