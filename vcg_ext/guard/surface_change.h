// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "vcg_ext/geometry/mixed.h"
#include "vcg_ext/guard/near_faces.h"
#include "vcg_ext/mesh/edge_neighborhood.h"

namespace curvdecim::detail {

/// What a step does to the faces of a mesh. Reused from step to step.
struct SurfaceChange {
  std::vector<int> gone;          ///< faces that it moves or removes
  std::vector<NumberedFace> now;  ///< what is there instead, by numbers of these

  /// The edge collapses to x.
  void set_collapse(const WorkingMesh& mesh, const EdgeNeighborhood& around, const Vector3& x) {
    gone.assign(around.wings().begin(), around.wings().end()), now.clear();
    for (int f : around.star()) {
      const bool at_a = mesh.connectivity.face_has(f, around.edge().a);
      if (mesh.position[at_a ? around.edge().a : around.edge().b] == x) continue;  // it stays
      gone.push_back(f);
      now.push_back({f, triangle_after(mesh, f, around.edge(), x)});
    }
  }

  /// The same for changes to the same places; others hardly ever share it.
  std::uint64_t fingerprint() const {
    std::uint64_t print = 0;
    for (const NumberedFace& face : now)
      for (const Vector3& p : face.triangle)
        for (const double x : p) {
          std::uint64_t bits;
          std::memcpy(&bits, &x, sizeof bits);
          print = mixed(print + bits);
        }
    return print;
  }
};

}  // namespace curvdecim::detail
