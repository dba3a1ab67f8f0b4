// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/metric/placement.h"

namespace curvdecim::detail {

/// The vertex that follows v on the border, other than `from`; v: of kind Boundary, next to `from`.
inline int next_on_border(const WorkingMesh& mesh, int from, int v) {
  for (int f : mesh.connectivity.faces_of(v))
    for (int u : mesh.connectivity.face(f))
      if (u != v && u != from && is_boundary_edge(mesh.connectivity, u, v)) return u;
  return from;
}

/// The plane on which the collapse of a border edge leaves the area inside the border as it is
/// @cite lindstrom1998. Without it a vertex goes to where the lines of its neighbours meet: a
/// border that is round grows tips. None at a corner, which keeps its lines. half: of the edge;
/// wing: area vector of the face at it.
inline std::optional<KeepingPlane> border_area_plane(const WorkingMesh& mesh, Edge edge,
                                                     const Vector3& half, const Vector3& wing) {
  if (!is_boundary_edge(mesh.connectivity, edge.a, edge.b)) return std::nullopt;
  const Vector3 middle = mesh.position[edge.a] + half;
  const Vector3 before = mesh.position[next_on_border(mesh, edge.b, edge.a)] - middle;
  const Vector3 after = mesh.position[next_on_border(mesh, edge.a, edge.b)] - middle;
  const auto is_round = [&](const Vector3& side) {
    constexpr double corner = 0.1;  // cosine of a turn of 84 degrees: less than a square has
    return side.dot(half) > corner * side.norm() * half.norm();
  };
  if (!is_round(-half - before) || !is_round(after - half)) return std::nullopt;
  return KeepingPlane{wing.cross(before - after), wing.dot(half.cross(before + after))};
}

}  // namespace curvdecim::detail
