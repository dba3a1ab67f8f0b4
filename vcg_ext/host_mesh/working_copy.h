// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "vcg_ext/errors.h"
#include "vcg_ext/geometry/unit_box.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// A host's mesh as index arrays, which the run changes, with the way back, which it does not.
struct WorkingCopy {
  WorkingMesh mesh;
  std::vector<int> vertex_of;  // by working vertex at the start: index in the host's mesh
  std::vector<int>
      unusable;  // the host's faces left out, to be removed: an index twice, or a double
  std::vector<int> left_alone;         // the host's faces left out that stay
  std::vector<std::uint8_t> selected;  // by working face at the start: 1 if it is
  UnitBox box;
};

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
