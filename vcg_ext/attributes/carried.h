// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "vcg_ext/attributes/attribute_blend.h"
#include "vcg_ext/attributes/face_copies.h"
#include "vcg_ext/attributes/wedge_texture.h"

namespace curvdecim::detail {

/// What vertices and faces carry, on its way through a run: how it follows from what the input
/// carried.
struct Carried {
  BlendRecord blended;  // by the collapses
  FaceCopies new_faces;
  std::optional<WedgeTexture> wedges;  // where the mesh has wedge texture coordinates
  std::vector<BlendStep> resampled;    // from the input, after all others: by the refinement

  CollapseObservers collapse_observers() {
    CollapseObservers observers = {&blended, &new_faces};
    if (wedges) observers.push_back(&*wedges);
    return observers;
  }

  RemovalObservers removal_observers() {
    return wedges ? RemovalObservers{&*wedges} : RemovalObservers{};
  }
};

/// Tells whether the edge ab between the faces f and g is a seam. mesh and carried must outlive it.
inline auto seams_of(const WorkingMesh& mesh, const Carried& carried) {
  return [&](int f, int g, int a, int b) {
    return carried.wedges && carried.wedges->is_seam(mesh, f, g, a, b);
  };
}

}  // namespace curvdecim::detail
