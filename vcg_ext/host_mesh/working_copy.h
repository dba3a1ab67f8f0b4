// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "vcg_ext/errors.h"
#include "vcg_ext/geometry/unit_box.h"
#include "vcg_ext/mesh/sheets.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// A host's mesh as index arrays, which the run changes, with the way back, which it does not.
struct WorkingCopy {
  WorkingMesh mesh;
  std::vector<int> vertex_of;  // by working vertex at the start: index in the host's mesh, which
                               // several may have
  std::vector<int>
      unusable;  // the host's faces left out, to be removed: an index twice, or a double
  std::vector<int> left_alone;         // the host's faces left out that stay
  std::vector<std::uint8_t> selected;  // by working face at the start: 1 if it is
  bool selected_only = false;          // others are locked
  int vertices_read = 0;               // of the host's mesh
  int borders_joined = 0;              // pairs of edges that lay on each other
  UnitBox box;
};

/// The faces of a mesh make its adjacency; vertices have the numbers that they start with.
inline void connect(WorkingMesh& mesh, std::vector<Face> faces, const Parallel& parallel) {
  const int count = static_cast<int>(mesh.position.size());
  mesh.connectivity = TriangleConnectivity(std::move(faces), count, parallel);
  mesh.kind = classify_vertices(mesh.connectivity, parallel);
  mesh.vertex_origins = count;
  mesh.vertex_origin.resize(count);
  std::iota(mesh.vertex_origin.begin(), mesh.vertex_origin.end(), 0);
}

/// Gives the faces of a copy, as it was read, other vertices in the same places.
inline void reconnect(WorkingCopy& copy, Revertexed now, const Parallel& parallel) {
  const auto take = [&](auto& by_vertex) {
    const auto was = by_vertex;
    by_vertex.resize(now.old_of.size());
    for (std::size_t v = 0; v < now.old_of.size(); ++v) by_vertex[v] = was[now.old_of[v]];
  };
  take(copy.mesh.position), take(copy.mesh.locked), take(copy.vertex_of);
  connect(copy.mesh, std::move(now.faces), parallel);
}

/// Gives every sheet its own vertex where several touch. Vertices that are locked stay one. What
/// touches itself, so that its material is one piece around both ends of the edge, is parted where
/// the air is not.
inline void separate_sheets(WorkingCopy& copy, const Parallel& parallel) {
  const auto is_singular = [](VertexKind kind) { return kind >= VertexKind::Curve; };
  for (Pairing pairing : {Pairing::Material, Pairing::Air}) {
    if (std::none_of(copy.mesh.kind.begin(), copy.mesh.kind.end(), is_singular)) return;
    Revertexed apart = separated_sheets(copy.mesh, pairing);
    if (!apart.faces.empty()) reconnect(copy, std::move(apart), parallel);
  }
}

[[noreturn]] inline void refuse_empty_selection() {
  throw InputError(
      "selected_only is on, but no face is selected. Select faces or turn selected_only off.",
      {"selected_only"});
}

/// Faces outside the selection stay, also unusable ones, and so do their vertices. Throws
/// InputError where nothing is selected.
template <class MeshType>
void lock_unselected(const MeshType& mesh, WorkingCopy& copy) {
  if (std::none_of(copy.selected.begin(), copy.selected.end(), [](bool s) { return s; }))
    refuse_empty_selection();
  copy.selected_only = true;
  std::vector<bool> locked(mesh.vert.size(), false);
  for (const auto& face : mesh.face)
    if (!face.IsD() && !face.IsS())
      for (int i = 0; i < 3; ++i) locked[vcg::tri::Index(mesh, face.cV(i))] = true;
  for (std::size_t v = 0; v < copy.vertex_of.size(); ++v)
    copy.mesh.locked[v] = locked[copy.vertex_of[v]];
  const auto stay = std::stable_partition(copy.unusable.begin(), copy.unusable.end(),
                                          [&](int f) { return mesh.face[f].IsS(); });
  copy.left_alone.assign(stay, copy.unusable.end());
  copy.unusable.erase(stay, copy.unusable.end());
}

/// The living faces that may change.
template <class MeshType>
int count_candidates(const MeshType& mesh, bool selected_only) {
  if (!selected_only) return mesh.fn;
  return static_cast<int>(std::count_if(mesh.face.begin(), mesh.face.end(),
                                        [](const auto& f) { return !f.IsD() && f.IsS(); }));
}

}  // namespace curvdecim::detail
