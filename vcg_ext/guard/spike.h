// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// The squared distance between x and the faces around the edge.
inline double squared_distance_around(const WorkingMesh& mesh, const EdgeNeighborhood& around,
                                      const Vector3& x) {
  double least = HUGE_VAL;
  for (const std::vector<int>* faces : {&around.star(), &around.wings()})
    for (int f : *faces) least = std::min(least, squared_distance(mesh.triangle(f), x));
  return least;
}

/// What it costs that the merged vertex stands off the surface, in area times squared length. Where
/// the planes around meet far away, as below a cone's tip, a quadric takes that for the best place
/// (docs/decisions/spikes.md). after: the planes of the star.
inline double spike_price(const WorkingMesh& mesh, const EdgeNeighborhood& around, const Vector3& x,
                          const std::vector<FacePlane>& after) {
  constexpr double near = 2.0;  // on the squared half edge; so near the quadric is right
  /// The mean squared height of a face of which one corner is lifted by 1, seen from both surfaces.
  constexpr double tent = 1.0 / 6.0 + 1.0 / 6.0;
  const Vector3 &a = mesh.position[around.edge().a], &b = mesh.position[around.edge().b];
  if (!((x - 0.5 * (a + b)).squaredNorm() > near * 0.25 * (b - a).squaredNorm())) return 0.0;
  double area = 0.0;
  for (const FacePlane& plane : after) area += plane.area;
  return tent * area * squared_distance_around(mesh, around, x);
}

}  // namespace curvdecim::detail
