// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// Cosine between the normals of two faces at an edge below which they lie on each other: an angle
/// of more than 179 degrees.
inline constexpr double folded_cosine = -0.99985;

inline bool lie_on_each_other(const FacePlane& f, const FacePlane& g) {
  return f.normal.dot(g.normal) < folded_cosine;
}

/// True if two faces of the star share a vertex beside the merged one.
inline bool share_edge(const WorkingMesh& mesh, int f, int g, Edge edge) {
  for (int u : mesh.connectivity.face(f))
    if (u != edge.a && u != edge.b && mesh.connectivity.face_has(g, u)) return true;
  return false;
}

/// True if, after the collapse, a face of the star would lie back to back with the face across one
/// of its edges that does not now. after: the planes of the star.
inline bool folds(const WorkingMesh& mesh, const EdgeNeighborhood& around,
                  const std::vector<FacePlane>& after) {
  constexpr double small_turn = 0.9;  // cosine: the face across the outer edge is not asked about
  const std::vector<int>& star = around.star();
  const TriangleConnectivity& connectivity = mesh.connectivity;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const FacePlane &was = mesh.plane[star[i]], &now = after[i];
    for (std::size_t j = 0; j < i && now.normal.dot(after[0].normal) < 0.0; ++j)
      if (lie_on_each_other(now, after[j]) && share_edge(mesh, star[i], star[j], around.edge()) &&
          !lie_on_each_other(was, mesh.plane[star[j]]))
        return true;
    if (was.normal.dot(now.normal) > small_turn) continue;
    const int end =
        connectivity.face_has(star[i], around.edge().a) ? around.edge().a : around.edge().b;
    const int u = connectivity.next_vertex(star[i], end);
    const int across =
        connectivity.face_across(star[i], u, connectivity.third_vertex(star[i], end, u));
    if (across >= 0 && lie_on_each_other(now, mesh.plane[across]) &&
        !lie_on_each_other(was, mesh.plane[across]))
      return true;
  }
  return false;
}

}  // namespace curvdecim::detail
