// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "vcg_ext/geometry/triangle.h"
#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/mesh/triangle_tree.h"

namespace curvdecim::detail {

/// A point of a face of the mesh and the point of the input that belongs to it: one of them is the
/// nearest to the other.
struct Match {
  Barycentric at{};     // on the face
  Vector3 target;       // on the input
  double weight = 0.0;  // the part of the area that the sample stands for
  double distance2 = 0.0;
  int input_face = SurfacePoint::none;  // that the point of the input is on; not known of curves
  Barycentric on_input{};               // where
};

/// What is kept of the nearest point: where on the face it lies is quickly found again.
struct Found {
  int face = SurfacePoint::none;
  float distance2 = 0.0f;

  Found() = default;
  explicit Found(const SurfacePoint& point)
      : face(point.face), distance2(static_cast<float>(point.distance2)) {}
};

/// How far to look.
struct MatchLimits {
  double facing2;    // squared: further away, a face is taken whichever way it faces
  double walked2;    // squared: nearer, what a walk has found is the nearest
  double rounding2;  // squared: nearer is nothing

  /// For a mesh of so many faces. A walk is trusted within a twentieth of a face's size: ten times
  /// as far, errors grow. Distances below 1e-7 of it are rounding.
  MatchLimits(double area, int faces)
      : facing2(area / faces), walked2(0.003 * facing2), rounding2(1e-14 * facing2) {}

  /// For hints that may lie on another sheet: trusts no walk.
  MatchLimits without_walks() const {
    MatchLimits limits = *this;
    limits.walked2 = 0.0;
    return limits;
  }

  void round(SurfacePoint& point) const {
    if (point.distance2 <= rounding2) point.distance2 = 0.0;
  }
};

/// A weight of a point on a face that is no more is rounding: the point is on the edge across.
inline constexpr double rounding_weight = 1e-9;

/// True if a point with these weights is on no edge of its face.
inline bool is_inside(const Barycentric& weight) {
  return *std::min_element(weight.begin(), weight.end()) > rounding_weight;
}

/// True if face f touches the point with these weights on `face`: has the corner that it is, or
/// both ends of the edge that it is on. Inside a face no other does.
inline bool touches(const TriangleConnectivity& connectivity, int f, const Face& face,
                    const Barycentric& weight) {
  for (int i = 0; i < 3; ++i)
    if (weight[i] > rounding_weight && !connectivity.face_has(f, face[i])) return false;
  return true;
}

/// A corner of the face that all faces have that touch the point with these weights on it; no hub
/// where there is another.
inline int touched_corner(const TriangleConnectivity& connectivity, const Face& face,
                          const Barycentric& weight) {
  int corner = -1;
  for (int i = 0; i < 3; ++i)
    if (weight[i] > rounding_weight && (corner < 0 || connectivity.is_hub(corner)))
      corner = face[i];
  return corner;
}

/// The point nearest to p that a walk from `start` ends at, from face to face across the edge or
/// the corner that is the nearest so far, while the distance falls: no other face that touches it
/// is nearer. Only over faces whose normal `accept` takes; not found where `start` is none.
///
/// Surface: triangle(f) and connectivity.
template <class Surface, class Accept>
SurfacePoint walk_to_nearest(const Surface& surface, const Vector3& p, int start, Accept accept) {
  SurfacePoint best;
  look_at(surface, start, p, accept, best);
  for (int from = SurfacePoint::none; best.face != from;) {
    from = best.face;
    const Barycentric weight = best.weight;
    if (is_inside(weight)) break;  // no other face touches it
    const Face& face = surface.connectivity.face(from);
    for (int f : surface.connectivity.faces_of(touched_corner(surface.connectivity, face, weight)))
      if (f != from && touches(surface.connectivity, f, face, weight))
        look_at(surface, f, p, accept, best);
  }
  return best;
}

/// True if a walk over faces along the normal may have ended here for want of a way: at a border,
/// or beside a face that faces away or has no area but rounding. Nearer ones may lie behind.
template <class Surface>
bool is_dead_end(const Surface& surface, const SurfacePoint& end, const Vector3& normal) {
  constexpr double least_shape_quality = 1e-6;  // of an area that is more than rounding
  const Face& face = surface.connectivity.face(end.face);
  if (is_inside(end.weight)) return false;
  bool is_alone = true;
  for (int f :
       surface.connectivity.faces_of(touched_corner(surface.connectivity, face, end.weight))) {
    if (f == end.face || !touches(surface.connectivity, f, face, end.weight)) continue;
    const Triangle triangle = surface.triangle(f);
    const Vector3 v = area_vector(triangle);
    if (!(v.dot(normal) > 0.0) || is_worse_shaped(triangle, v.norm(), least_shape_quality))
      return true;
    is_alone = false;
  }
  return is_alone;
}

/// The nearest point on the same sheet, where that is near; of thin walls the other sheet may be
/// nearer. A walk from the hint mostly finds it; where it ends further away than the hint's
/// neighbourhood reaches, or had no way on, all faces are searched.
template <class Surface>
SurfacePoint nearest_on_sheet(const TriangleTree<Surface>& tree, const Vector3& p,
                              const Vector3& normal, int hint, const MatchLimits& limits) {
  const auto faces_along = [&](const Vector3& n) { return n.dot(normal) >= 0.0; };
  SurfacePoint found;
  if (hint != SurfacePoint::none) found = walk_to_nearest(tree.surface(), p, hint, faces_along);
  const bool is_nearest =
      found.distance2 <= limits.rounding2 ||
      (found.distance2 < limits.walked2 && !is_dead_end(tree.surface(), found, normal));
  if (!is_nearest)
    found = tree.nearest_facing(p, normal, limits.facing2, found.found() ? found.face : hint);
  if (!found.found()) found = tree.nearest(p, hint);
  limits.round(found);
  return found;
}

}  // namespace curvdecim::detail
