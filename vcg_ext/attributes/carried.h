// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/attributes/attribute_blend.h"
#include "vcg_ext/attributes/face_copies.h"

namespace curvdecim::detail {

/// What vertices and faces carry, on its way through a run: how it follows from what the input
/// carried. Wedge texture coordinates are in the mesh (WorkingMesh::texture).
struct Carried {
  BlendRecord blended;  // by the collapses
  FaceCopies new_faces;
  std::vector<BlendStep> resampled;  // from the input, after all others: by the refinement
  bool copies_differ = false;        // wedges of a vertex carry what one of the host's has once

  CollapseObservers collapse_observers() { return {&new_faces, &blended}; }
};

}  // namespace curvdecim::detail
