// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two triangles cross. Corners in the same place count as one, as those of neighbours are.
#pragma once

#include <algorithm>
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

/// What two triangles have in common beside the corners that they share.
enum class Contact {
  None,
  Touch,  ///< or too little to be told from nothing, or from a crossing
  Cross
};

using Sides = std::array<int, 3>;

/// On which sides of the plane of s the corners of t are, of which the first `shared` are in it;
/// those within `depth` are, too.
inline Sides sides_of(const CornerRefs& s, const CornerRefs& t, int shared, double depth) {
  const OrientedPlane plane(*s[0], *s[1], *s[2]);
  const double volume = depth > 0.0 ? depth * plane.normal_length() : 0.0;
  return {shared > 0 ? 0 : plane.side(*t[0], volume), plane.side(*t[1], volume),
          plane.side(*t[2], volume)};
}

/// True if t clearly has nothing in the plane of s but corners that both share: so it is nearly
/// always, and no more has to be looked at. plane: of s.
inline bool only_shares_corners(const Triangle& s, const OrientedPlane& plane, const Triangle& t) {
  bool has_front = false, has_back = false;
  for (const Vector3& p : t) {
    if (are_in_one_place(p, s[0]) || are_in_one_place(p, s[1]) || are_in_one_place(p, s[2]))
      continue;
    const int side = plane.side(p);
    if (side == 0) return false;
    has_front = has_front || side > 0, has_back = has_back || side < 0;
  }
  return has_front != has_back;
}

/// True if the triangles clearly have no more in common than corners; each with its plane.
inline bool are_clearly_apart(const Triangle& s, const OrientedPlane& of_s, const Triangle& t,
                              const OrientedPlane& of_t) {
  return only_shares_corners(s, of_s, t) || only_shares_corners(t, of_t, s);
}

/// On which side of the line from p to q the one from a to b passes; 0 within `depth` of it.
inline int side_of_line(const Vector3& p, const Vector3& q, const Vector3& a, const Vector3& b,
                        double depth) {
  const double volume = depth > 0.0 ? depth * (q - p).cross(b - a).norm() : 0.0;
  return OrientedPlane(p, q, a).side(b, volume);
}

/// What the segment from p to q has in common with t. side_p, side_q: of its plane, not both 0.
inline Contact contact_of(const Vector3& p, const Vector3& q, int side_p, int side_q,
                          const CornerRefs& t, double depth) {
  if (side_p * side_q > 0) return Contact::None;
  const int a = side_of_line(p, q, *t[0], *t[1], depth);
  const int b = side_of_line(p, q, *t[1], *t[2], depth);
  if (a * b < 0) return Contact::None;
  const int c = side_of_line(p, q, *t[2], *t[0], depth);
  if (a * c < 0 || b * c < 0) return Contact::None;
  return side_p != 0 && side_q != 0 && a * b * c != 0 ? Contact::Cross : Contact::Touch;
}

/// What the edges of s have in common with t, or, where they share a corner, the one across from
/// it. side: of the plane of t. An edge in that plane is left to the edges beside it.
inline Contact contact_of_edges(const CornerRefs& s, const Sides& side, const CornerRefs& t,
                                int shared, double depth) {
  Contact most = Contact::None;
  for (int i = shared; i < 3 - shared; ++i) {
    const int k = (i + 1) % 3;
    if (side[i] != 0 || side[k] != 0)
      most = std::max(most, contact_of(*s[i], *s[k], side[i], side[k], t, depth));
  }
  return most;
}

// --- seen from one side --------------------------------------------------------------------------

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

/// What the triangles have in common. depth: of the same unit; one that reaches no further through
/// the other, or past the other's edge, touches.
inline Contact contact_of(const Triangle& first, const Triangle& second, double depth) {
  const TrianglePair pair(first, second);
  const auto& [s, t, shared] = pair;
  if (shared == 3) return Contact::Touch;
  if (!overlap_as_seen(pair)) return Contact::None;  // in space, too, though rounding may hide it
  const Sides of_t = sides_of(s, t, shared, depth), of_s = sides_of(t, s, shared, depth);
  if (shared == 2) return of_t[2] == 0 ? Contact::Touch : Contact::None;
  if (of_s == Sides{} && of_t == Sides{}) return Contact::Touch;
  return std::max(contact_of_edges(s, of_s, t, shared, depth),
                  contact_of_edges(t, of_t, s, shared, depth));
}

/// True if the triangles have a point in common that is no corner or edge of both. Neighbours at an
/// edge cross where one lies on the other, triangles with the same corners always do. To touch is
/// to cross, and so is what rounding cannot tell from it. Each with its plane.
inline bool triangles_cross(const Triangle& first, const OrientedPlane& of_first,
                            const Triangle& second, const OrientedPlane& of_second) {
  return !are_clearly_apart(first, of_first, second, of_second) &&
         contact_of(first, second, 0.0) != Contact::None;
}

inline bool triangles_cross(const Triangle& first, const Triangle& second) {
  return triangles_cross(first, plane_through(first), second, plane_through(second));
}

/// True if one triangle clearly goes through the other, by more than this depth.
inline bool triangles_cross_deeper(double depth, const Triangle& first, const Triangle& second) {
  return !are_clearly_apart(first, plane_through(first), second, plane_through(second)) &&
         contact_of(first, second, depth) == Contact::Cross;
}

}  // namespace curvdecim::detail
