// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/refine/triangle_tree.h"

namespace curvdecim::detail {

/// True if face f touches the point with these weights on `face`: has the corner that it is, or
/// both ends of the edge that it is on. Inside a face no other does.
inline bool touches(const TriangleConnectivity& connectivity, int f, const Face& face,
                    const Barycentric& weight) {
  for (int i = 0; i < 3; ++i)
    if (weight[i] != 0.0 && !connectivity.face_has(f, face[i])) return false;
  return true;
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
    const Face& face = surface.connectivity.face(from);
    const Barycentric weight = best.weight;
    const int corner = weight[0] != 0.0 ? face[0] : weight[1] != 0.0 ? face[1] : face[2];
    for (int f : surface.connectivity.faces_of(corner))
      if (f != from && touches(surface.connectivity, f, face, weight))
        look_at(surface, f, p, accept, best);
  }
  return best;
}

}  // namespace curvdecim::detail
