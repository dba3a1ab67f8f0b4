// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "vcg_ext/measure/fixed_blocks.h"
#include "vcg_ext/measure/measured_surface.h"

namespace curvdecim::detail {

/// How deep a face must reach through another one, in the box of diagonal 1: what only touches, up
/// to the rounding of single precision, does not cross.
inline constexpr double crossing_depth = 1e-7;

/// True if p lies over the triangle, away from its edges; normal: its unit normal.
inline bool is_inside(const Triangle& t, const Vector3& normal, const Vector3& p) {
  for (int i = 0; i < 3; ++i) {
    const Vector3 edge = t[(i + 1) % 3] - t[i];
    if (!(normal.cross(edge).dot(p - t[i]) > crossing_depth * edge.norm())) return false;
  }
  return true;
}

/// True if the segment from a to b goes through the triangle.
inline bool pierces(const Vector3& a, const Vector3& b, const Triangle& t, const Vector3& normal) {
  const double above = normal.dot(a - t[0]), below = normal.dot(b - t[0]);
  if ((above > 0.0) == (below > 0.0)) return false;
  if (std::min(std::abs(above), std::abs(below)) <= crossing_depth) return false;
  return is_inside(t, normal, a + (above / (above - below)) * (b - a));
}

/// Which faces of a surface cross another one. Faces with an edge in common lie on each other or do
/// not cross: those are folded. Faces with a vertex in common cross where the edge across from it
/// goes through the other face; faces in one plane do not cross.
class Intersections {
 public:
  explicit Intersections(const MeasuredSurface& surface) : surface_(surface) {}

  int count(const Parallel& parallel) const {
    return static_cast<int>(
        sum_of(surface_.face_count(), parallel, [&](int i) { return crosses_any(i) ? 1.0 : 0.0; }));
  }

 private:
  const Face& corners_of(int i) const {
    return surface_.mesh().connectivity.face(surface_.number_in_mesh(i));
  }

  bool crosses_any(int i) const {
    const Triangle& t = surface_.triangle(i);
    const Vector3 middle = center_of(t);
    double radius2 = 0.0;
    for (const Vector3& p : t) radius2 = std::max(radius2, (p - middle).squaredNorm());
    bool found = false;
    surface_.tree().visit_near(middle, radius2, [&](int j) {
      found = found || (j != i && may_meet(t, surface_.triangle(j)) && cross(i, j));
    });
    return found;
  }

  /// False where their boxes are apart.
  static bool may_meet(const Triangle& s, const Triangle& t) {
    for (int k = 0; k < 3; ++k) {
      const auto [low_s, high_s] = std::minmax({s[0][k], s[1][k], s[2][k]});
      const auto [low_t, high_t] = std::minmax({t[0][k], t[1][k], t[2][k]});
      if (high_s < low_t || high_t < low_s) return false;
    }
    return true;
  }

  bool cross(int i, int j) const {
    const Face &f = corners_of(i), &g = corners_of(j);
    const auto is_shared = [&](int v) { return std::find(g.begin(), g.end(), v) != g.end(); };
    if (std::count_if(f.begin(), f.end(), is_shared) > 1) return false;
    return an_edge_pierces(i, j) || an_edge_pierces(j, i);
  }

  /// An edge of face i through face j. One from a vertex that they share only touches it there.
  bool an_edge_pierces(int i, int j) const {
    const Triangle &edges = surface_.triangle(i), &t = surface_.triangle(j);
    const Vector3& normal = surface_.plane(j).normal;
    return pierces(edges[0], edges[1], t, normal) || pierces(edges[1], edges[2], t, normal) ||
           pierces(edges[2], edges[0], t, normal);
  }

  const MeasuredSurface& surface_;
};

}  // namespace curvdecim::detail
