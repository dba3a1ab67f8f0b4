// SPDX-License-Identifier: GPL-3.0-or-later
// Seams: edges at which what is carried jumps, over a surface that is not broken.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

inline bool is_on_seam(const WorkingMesh& mesh, int v) {
  return !mesh.on_seam.empty() && mesh.on_seam[v] != 0;
}

/// Whether v is on no outline of a chart: neither on a border nor on a seam.
inline bool is_inside_chart(const WorkingMesh& mesh, int v) {
  return mesh.kind[v] == VertexKind::Interior && !is_on_seam(mesh, v);
}

/// The wedge of a vertex inside a chart, which has no other.
inline int only_wedge(const WorkingMesh& mesh, int v) {
  return mesh.wedges.at(mesh.connectivity, *mesh.connectivity.faces_of(v).begin(), v);
}

/// Whether the edge ab of face f is a seam, by its wedges.
inline bool has_seam(const WorkingMesh& mesh, int f, int a, int b) {
  const int across = mesh.connectivity.face_across(f, a, b);
  return across >= 0 && mesh.wedges.differ(mesh.connectivity, f, across, a, b);
}

/// Whether it is a border or a seam: an edge of the outline of a chart.
inline bool is_outline(const WorkingMesh& mesh, int f, int a, int b) {
  const int across = mesh.connectivity.face_across(f, a, b);
  return across < 0 || mesh.wedges.differ(mesh.connectivity, f, across, a, b);
}

/// Whether it is a seam, quickly where it is none.
inline bool is_seam_edge(const WorkingMesh& mesh, int f, int a, int b) {
  return is_on_seam(mesh, a) && is_on_seam(mesh, b) && has_seam(mesh, f, a, b);
}

inline bool is_seam_edge(const WorkingMesh& mesh, Edge edge) {
  const auto faces = mesh.connectivity.faces_of(edge.a);
  return std::any_of(faces.begin(), faces.end(), [&](int f) {
    return mesh.connectivity.face_has(f, edge.b) && is_seam_edge(mesh, f, edge.a, edge.b);
  });
}

/// Whether v is an end of a seam edge, by the wedges around it.
inline bool ends_seam(const WorkingMesh& mesh, int v) {
  const auto faces = mesh.connectivity.faces_of(v);
  return std::any_of(faces.begin(), faces.end(), [&](int f) {
    const Face& face = mesh.connectivity.face(f);
    return std::any_of(face.begin(), face.end(),
                       [&](int u) { return u != v && has_seam(mesh, f, v, u); });
  });
}

/// Once the wedges at v are others.
inline void update_seam(WorkingMesh& mesh, int v) {
  if (!mesh.on_seam.empty()) mesh.on_seam[v] = ends_seam(mesh, v) ? 1 : 0;
}

/// Finds the seams of a mesh with wedges.
inline void find_seams(WorkingMesh& mesh, const Parallel& parallel) {
  mesh.on_seam.clear();
  if (!mesh.wedges.exist()) return;
  std::vector<std::uint8_t> on_seam(mesh.position.size());
  parallel.for_each(static_cast<int>(on_seam.size()),
                    [&](int v) { on_seam[v] = ends_seam(mesh, v) ? 1 : 0; });
  if (std::count(on_seam.begin(), on_seam.end(), std::uint8_t{1}) > 0)
    mesh.on_seam = std::move(on_seam);
}

}  // namespace curvdecim::detail
