// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim {

/// The target as absolute counts; faces and vertices that take no part are counted by the caller.
struct StopCriterion {
  int faces = 0;     ///< stop at this many faces of the working mesh
  int vertices = 0;  ///< stop at this many vertices of the working mesh

  bool reached(const TriangleConnectivity& connectivity) const {
    return connectivity.face_count() <= faces || connectivity.vertex_count() <= vertices;
  }
};

}  // namespace curvdecim
