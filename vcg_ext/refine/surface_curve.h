// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/seams.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// Edges of one face.
inline std::vector<Edge> border_edges(const WorkingMesh& mesh) {
  std::vector<Edge> edges;
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f)
    for (int i = 0; i < 3 && mesh.connectivity.alive(f); ++i) {
      const int a = mesh.connectivity.face(f)[i], b = mesh.connectivity.face(f)[(i + 1) % 3];
      if (is_on_border(mesh, a, b)) edges.push_back({std::min(a, b), std::max(a, b)});
    }
  return edges;
}

/// Edges between two faces that carry what jumps there.
inline std::vector<Edge> seam_edges(const WorkingMesh& mesh) {
  std::vector<Edge> edges;
  if (mesh.on_seam.empty()) return edges;
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f)
    for (int i = 0; i < 3 && mesh.connectivity.alive(f); ++i) {
      const int a = mesh.connectivity.face(f)[i], b = mesh.connectivity.face(f)[(i + 1) % 3];
      if (is_seam_edge(mesh, f, a, b) && f < mesh.connectivity.face_across(f, a, b))
        edges.push_back({std::min(a, b), std::max(a, b)});
    }
  return edges;
}

/// Edges of a surface as faces without area, to look for nearest points on.
struct SurfaceCurve {
  const std::vector<Vector3>& position;  // by vertex
  std::vector<Edge> edges;

  SurfaceCurve(const std::vector<Vector3>& positions, std::vector<Edge> of_curve)
      : position(positions), edges(std::move(of_curve)) {}

  int size() const { return static_cast<int>(edges.size()); }
  Triangle triangle(int e) const {
    const auto [a, b] = edges[e];
    return {position[a], position[b], position[b]};
  }
  double length(int e) const { return (position[edges[e].b] - position[edges[e].a]).norm(); }
};

}  // namespace curvdecim::detail
