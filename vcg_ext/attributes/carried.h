// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "vcg_ext/attributes/attribute_blend.h"
#include "vcg_ext/attributes/corner_copies.h"
#include "vcg_ext/attributes/face_copies.h"
#include "vcg_ext/attributes/wedge_texture.h"

namespace curvdecim::detail {

/// What vertices and faces carry, on its way through a run: how it follows from what the input
/// carried.
struct Carried {
  BlendRecord blended;  // by the collapses
  FaceCopies new_faces;
  std::optional<CornerCopies> copies;  // instead of `blended`, where a vertex stands for several
  std::optional<WedgeTexture> wedges;  // where the mesh has wedge texture coordinates
  std::vector<BlendStep> resampled;    // from the input, after all others: by the refinement

  CollapseObservers collapse_observers() {
    CollapseObservers observers = {&new_faces};
    if (copies)
      observers.push_back(&*copies);
    else
      observers.push_back(&blended);
    if (wedges) observers.push_back(&*wedges);
    return observers;
  }

  /// Whether it follows from the steps of the vertices alone.
  bool is_by_vertex() const { return !copies && !wedges; }

  RemovalObservers removal_observers() {
    return wedges ? RemovalObservers{&*wedges} : RemovalObservers{};
  }

  /// use(BlendStep), in the order of the collapses, or at the same time for such that have no
  /// vertex in common.
  template <class Use>
  void for_each_step(const Parallel& parallel, Use use) const {
    copies ? copies->for_each(use) : blended.for_each(parallel, use);
  }

  // --- what faces do not agree about ------------------------------------------------------------

  /// True if a vertex carries different values in different faces.
  bool on_seam(const WorkingMesh& mesh, int v) const {
    return (wedges && wedges->values().on_seam(mesh, v)) ||
           (copies && copies->values().on_seam(mesh, v));
  }

  /// True if two faces do not agree about an end of their edge.
  bool is_seam(const WorkingMesh& mesh, int f, int g, int a, int b) const {
    return (wedges && wedges->values().is_seam(mesh, f, g, a, b)) ||
           (copies && copies->values().is_seam(mesh, f, g, a, b));
  }

  /// Before TriangleConnectivity::flip of an edge that is no seam.
  void flip(const WorkingMesh& mesh, int f, int g, int a, int b) {
    if (wedges) wedges->values().flip(mesh, f, g, a, b);
    if (copies) copies->values().flip(mesh, f, g, a, b);
  }

  void renumber(const Renumbering& numbers) {
    if (wedges) wedges->renumber(numbers);
    if (copies) copies->renumber(numbers);
  }
};

/// Tells whether the edge ab between the faces f and g is a seam. mesh and carried must outlive it.
inline auto seams_of(const WorkingMesh& mesh, const Carried& carried) {
  return [&](int f, int g, int a, int b) { return carried.is_seam(mesh, f, g, a, b); };
}

}  // namespace curvdecim::detail
