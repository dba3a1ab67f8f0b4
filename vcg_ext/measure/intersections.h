// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

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

/// True if a triangle reaches through the plane of another one.
inline bool reaches_through(const Triangle& t, const Vector3& on_plane, const Vector3& normal) {
  double low = 0.0, high = 0.0;
  for (const Vector3& p : t) {
    const double height = normal.dot(p - on_plane);
    low = std::min(low, height), high = std::max(high, height);
  }
  return low < -crossing_depth && high > crossing_depth;
}

/// Which faces of a surface cross another one. Faces with an edge in common lie on each other or do
/// not cross: those are folded. Faces with a vertex in common cross where the edge across from it
/// goes through the other face; faces in one plane do not cross.
class Intersections {
 public:
  explicit Intersections(const MeasuredSurface& surface)
      : surface_(surface), crosses_(surface.face_count()) {}

  int count(const Parallel& parallel) {
    parallel.for_each(
        surface_.face_count(), [&](int i) { find_crossed(i); }, Parallel::heavy);
    return static_cast<int>(std::count(crosses_.begin(), crosses_.end(), true));
  }

 private:
  /// Both faces of a pair are marked, from the one with the lower number: whatever the order, the
  /// marks in the end are the same.
  void find_crossed(int i) {
    const Triangle& t = surface_.triangle(i);
    const Vector3 middle = center_of(t);
    double radius2 = 0.0;
    for (const Vector3& p : t) radius2 = std::max(radius2, (p - middle).squaredNorm());
    surface_.tree().visit_near(middle, radius2, [&](int j) {
      if (j <= i || !cross(i, j)) return;
      crosses_[i].store(true, std::memory_order_relaxed);
      crosses_[j].store(true, std::memory_order_relaxed);
    });
  }

  bool cross(int i, int j) const {
    const Triangle &s = surface_.triangle(i), &t = surface_.triangle(j);
    return reaches_through(t, s[0], surface_.plane(i).normal) &&
           reaches_through(s, t[0], surface_.plane(j).normal) && shared_vertices(i, j) < 2 &&
           (an_edge_pierces(s, j) || an_edge_pierces(t, i));
  }

  int shared_vertices(int i, int j) const {
    const TriangleConnectivity& connectivity = surface_.mesh().connectivity;
    int shared = 0;
    for (int v : connectivity.face(surface_.number_in_mesh(i)))
      shared += connectivity.face_has(surface_.number_in_mesh(j), v);
    return shared;
  }

  /// An edge from a vertex that the faces share only touches face j there.
  bool an_edge_pierces(const Triangle& edges, int j) const {
    const Triangle& t = surface_.triangle(j);
    const Vector3& normal = surface_.plane(j).normal;
    return pierces(edges[0], edges[1], t, normal) || pierces(edges[1], edges[2], t, normal) ||
           pierces(edges[2], edges[0], t, normal);
  }

  const MeasuredSurface& surface_;
  std::vector<std::atomic<bool>> crosses_;  // by face
};

}  // namespace curvdecim::detail
