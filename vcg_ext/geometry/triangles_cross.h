// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two triangles cross. Corners in the same place count as one, as those of neighbours are.
#pragma once

#include <array>
#include <utility>

#include "vcg_ext/geometry/orientation.h"
#include "vcg_ext/geometry/triangle.h"

namespace curvdecim::detail {

inline bool are_in_one_place(const Vector3& p, const Vector3& q) {
  return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];  // mostly the first is enough
}

inline OrientedPlane plane_through(const Triangle& t) { return {t[0], t[1], t[2]}; }

using CornerRefs = std::array<const Vector3*, 3>;

/// Two triangles, each turned so that the corners which they share come first, and how many these
/// are.
struct TrianglePair {
  CornerRefs s, t;
  int shared = 0;

  TrianglePair(const Triangle& first, const Triangle& second)
      : s{&first[0], &first[1], &first[2]}, t{&second[0], &second[1], &second[2]} {
    for (int i = 0; i < 3; ++i)
      for (int k = shared; k < 3; ++k)
        if (are_in_one_place(*s[i], *t[k])) {
          std::swap(s[shared], s[i]), std::swap(t[shared], t[k]);
          ++shared;
          break;
        }
  }
};

using Sides = std::array<int, 3>;

/// On which sides of the plane of s the corners of t are, of which the first `shared` are in it.
inline Sides sides_of(const CornerRefs& s, const CornerRefs& t, int shared) {
  const OrientedPlane plane(*s[0], *s[1], *s[2]);
  return {shared > 0 ? 0 : plane.side(*t[0]), plane.side(*t[1]), plane.side(*t[2])};
}

/// True if t clearly has nothing in the plane of s but corners that both share: so it is nearly
/// always, and no more has to be looked at. plane: of s.
inline bool only_shares_corners(const Triangle& s, const OrientedPlane& plane, const Triangle& t) {
  bool has_front = false, has_back = false;
  for (const Vector3& p : t) {
    const int side = plane.side(p);
    has_front = has_front || side > 0, has_back = has_back || side < 0;
    if (side == 0 && !are_in_one_place(p, s[0]) && !are_in_one_place(p, s[1]) &&
        !are_in_one_place(p, s[2]))
      return false;
  }
  return has_front != has_back;
}

/// True if the segment from p to q meets the triangle. side_p, side_q: of its plane, not both 0.
inline bool meets(const Vector3& p, const Vector3& q, int side_p, int side_q, const CornerRefs& t) {
  if (side_p * side_q > 0) return false;
  const auto side_of_edge = [&](int i, int k) { return OrientedPlane(p, q, *t[i]).side(*t[k]); };
  const int a = side_of_edge(0, 1), b = side_of_edge(1, 2);
  if (a * b < 0) return false;
  const int c = side_of_edge(2, 0);
  return a * c >= 0 && b * c >= 0;
}

/// True if an edge of s meets t, or, where they share a corner, the one across from it. side: of
/// the plane of t. An edge in that plane is left to the edges beside it.
inline bool any_edge_meets(const CornerRefs& s, const Sides& side, const CornerRefs& t,
                           int shared) {
  for (int i = shared; i < 3 - shared; ++i) {
    const int k = (i + 1) % 3;
    if ((side[i] != 0 || side[k] != 0) && meets(*s[i], *s[k], side[i], side[k], t)) return true;
  }
  return false;
}

// --- seen from one side
// ----------------------------------------------------------------------------------

using FlatTriangle = std::array<Vector2, 3>;

/// Both triangles, seen along the axis from which the larger normal is seen best.
inline std::array<FlatTriangle, 2> flattened(const TrianglePair& pair) {
  const Vector3 of_s = area_vector(*pair.s[0], *pair.s[1], *pair.s[2]),
                of_t = area_vector(*pair.t[0], *pair.t[1], *pair.t[2]);
  int axis = 0;
  (of_s.squaredNorm() > of_t.squaredNorm() ? of_s : of_t).cwiseAbs().maxCoeff(&axis);
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  std::array<FlatTriangle, 2> flat;
  for (int i = 0; i < 3; ++i) {
    flat[0][i] = {(*pair.s[i])[x], (*pair.s[i])[y]};
    flat[1][i] = {(*pair.t[i])[x], (*pair.t[i])[y]};
  }
  return flat;
}

/// True if an edge of s has all of t on the side where s is not.
inline bool has_separating_edge(const FlatTriangle& s, const FlatTriangle& t) {
  for (int i = 0; i < 3; ++i) {
    const Vector2 &a = s[i], &b = s[(i + 1) % 3];
    const int own = orientation(a, b, s[(i + 2) % 3]), side = orientation(a, b, t[0]);
    if (side == 0 || own * side > 0) continue;
    if (orientation(a, b, t[1]) == side && orientation(a, b, t[2]) == side) return true;
  }
  return false;
}

/// True if a corner of t beside the first lies in the angle of s at its first one, which is that of
/// t.
inline bool has_corner_in_angle(const FlatTriangle& s, const FlatTriangle& t) {
  const int own = orientation(s[0], s[1], s[2]);
  for (int i = 1; i < 3; ++i)
    if (own * orientation(s[0], s[1], t[i]) >= 0 && own * orientation(s[0], t[i], s[2]) >= 0)
      return own != 0;
  return false;
}

/// True if the triangles, as they are seen along that axis, have more in common than the corners
/// that they share.
inline bool overlap_as_seen(const TrianglePair& pair) {
  const auto [s, t] = flattened(pair);
  if (pair.shared == 0) return !has_separating_edge(s, t) && !has_separating_edge(t, s);
  if (pair.shared == 1) return has_corner_in_angle(s, t) || has_corner_in_angle(t, s);
  return orientation(s[0], s[1], s[2]) * orientation(t[0], t[1], t[2]) > 0;
}

// --- in space ------------------------------------------------------------------------------------

/// As triangles_cross, of triangles that are not clearly apart.
inline bool close_triangles_cross(const Triangle& first, const Triangle& second) {
  const TrianglePair pair(first, second);
  const auto& [s, t, shared] = pair;
  if (shared == 3) return true;
  if (shared == 2)
    return OrientedPlane(*s[0], *s[1], *s[2]).side(*t[2]) == 0 && overlap_as_seen(pair);
  if (!overlap_as_seen(pair)) return false;  // nor do they in space, though rounding may hide it
  const Sides of_t = sides_of(s, t, shared), of_s = sides_of(t, s, shared);
  if (of_s == Sides{} && of_t == Sides{}) return true;
  return any_edge_meets(s, of_s, t, shared) || any_edge_meets(t, of_t, s, shared);
}

/// True if the triangles have a point in common that is no corner or edge of both. Neighbours at an
/// edge cross where one lies on the other, triangles with the same corners always do. To touch is
/// to cross, and so is what rounding cannot tell from it.
inline bool triangles_cross(const Triangle& first, const Triangle& second) {
  return !only_shares_corners(first, plane_through(first), second) &&
         !only_shares_corners(second, plane_through(second), first) &&
         close_triangles_cross(first, second);
}

}  // namespace curvdecim::detail
