// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/guard/crossing_guard.h"
#include "vcg_ext/mesh/crossings.h"
#include "vcg_ext/mesh/face_boxes.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// A mesh with its vertices elsewhere.
struct MovedMesh {
  const WorkingMesh& mesh;
  const std::vector<Vector3>& position;

  Triangle triangle(int f) const { return triangle_of(position, mesh.connectivity.face(f)); }
};

/// Takes back the moves of vertices after which faces cross that do not now. now: by vertex, where
/// it is to be; none of the mesh's faces is dead.
inline void take_back_crossings(const WorkingMesh& mesh, std::vector<Vector3>& now,
                                const Parallel& parallel) {
  const MovedMesh moved{mesh, now};
  SingleBoxes<MovedMesh> boxes(moved, mesh.connectivity.face_slots(), parallel);
  for (bool any = true; any; boxes.refit(parallel)) {
    any = false;
    for (const auto& [f, g] : crossing_pairs(boxes, parallel)) {
      if (faces_cross(f, mesh.triangle(f), g, mesh.triangle(g))) continue;
      any = true;
      for (int face : {f, g})
        for (int v : mesh.connectivity.face(face)) now[v] = mesh.position[v];
    }
  }
}

}  // namespace curvdecim::detail
