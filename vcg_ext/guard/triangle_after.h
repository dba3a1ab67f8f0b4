// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/connectivity/edge_neighborhood.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim {

/// Face f with its corner at a or b moved to x.
inline Triangle triangle_after(const WorkingMesh& mesh, int f, Edge edge, const Vector3& x) {
  const Face& face = mesh.connectivity.face(f);
  const auto corner = [&](int v) -> const Vector3& {
    return v == edge.a || v == edge.b ? x : mesh.position[v];
  };
  return {corner(face[0]), corner(face[1]), corner(face[2])};
}

}  // namespace curvdecim
