// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "vcg_ext/mesh/sharp_edges.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim {

/// Tells which vertices are an end of a sharp edge.
class SharpVertices {
 public:
  /// angle: degrees, of a sharp edge; 180: no edge is sharp.
  SharpVertices(const WorkingMesh& mesh, double angle) : mesh_(mesh), sharp_(mesh, angle) {}

  bool operator()(int v) const {
    if (sharp_.none() || sharp_.none_at(v)) return false;
    const auto faces = mesh_.connectivity.faces_of(v);
    if (faces.size() > hub) return true;  // rather than to look at all pairs
    return std::any_of(faces.begin(), faces.end(), [&](int f) {
      return is_at_sharp(f, v, mesh_.connectivity.next_vertex(f, v));
    });
  }

 private:
  /// The edge of face f from v to u, between it and another one.
  bool is_at_sharp(int f, int v, int u) const {
    for (int g : mesh_.connectivity.faces_of(v))
      if (g != f && mesh_.connectivity.face_has(g, u) && sharp_.between(f, g)) return true;
    return false;
  }

  static constexpr int hub = 64;  // faces

  const WorkingMesh& mesh_;
  const SharpEdges sharp_;
};

}  // namespace curvdecim
