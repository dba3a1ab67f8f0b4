// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim {

/// The target as absolute counts; faces and vertices that take no part are counted by the caller.
struct StopCriterion {
  int faces = 0;     ///< stop at this many faces of the working mesh
  int vertices = 0;  ///< stop at this many vertices of the working mesh
  int start = 0;     ///< faces of the working mesh at the start

  /// once_removed: what is about to go.
  bool reached(const TriangleConnectivity& connectivity, const Removed& once_removed = {}) const {
    return connectivity.face_count() - once_removed.faces <= faces ||
           connectivity.vertex_count() - once_removed.vertices <= vertices;
  }

  /// Collapses until the target, if each removes two faces and a vertex.
  double collapses_left(const TriangleConnectivity& connectivity) const {
    return std::min(0.5 * (connectivity.face_count() - faces),
                    1.0 * (connectivity.vertex_count() - vertices));
  }

  /// The part of the faces to go that is gone, 0..1.
  double progress(const TriangleConnectivity& connectivity) const {
    const double all = std::max(1, start - faces);
    return std::clamp((start - connectivity.face_count()) / all, 0.0, 1.0);
  }
};

}  // namespace curvdecim
