// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/connectivity/edge_neighborhood.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim {

/// Face f with its corner at a or b moved to x.
inline Triangle triangle_after(const WorkingMesh& mesh, int f, Edge edge, const Vector3& x) {
  Triangle triangle = mesh.triangle(f);
  for (int i = 0; i < 3; ++i)
    if (const int v = mesh.connectivity.face(f)[i]; v == edge.a || v == edge.b) triangle[i] = x;
  return triangle;
}

}  // namespace curvdecim
