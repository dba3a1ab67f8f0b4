// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/mesh/triangle_tree.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// The input as it was, to measure what becomes of it.
class ReferenceSurface {
 public:
  static constexpr int none = SurfacePoint::none;

  /// The mesh has faces, and none that is dead.
  ReferenceSurface(const WorkingMesh& mesh, const Parallel& parallel)
      : triangles_(mesh.connectivity.face_slots()), across_(triangles_.size()) {
    parallel.for_each(size(), [&](int r) {
      triangles_[r] = mesh.triangle(r);
      for (int i = 0; i < 3; ++i) across_[r][i] = mate(mesh.connectivity, r, i);
    });
  }

  int size() const { return static_cast<int>(triangles_.size()); }
  const Triangle& triangle(int r) const { return triangles_[r]; }

  /// The face at its edge i, i+1; none where that is not one face that runs the other way there.
  int across(int r, int i) const { return across_[r][i]; }

 private:
  static int mate(const TriangleConnectivity& connectivity, int f, int i) {
    const int a = connectivity.face(f)[i], b = connectivity.face(f)[(i + 1) % 3];
    if (connectivity.edge_valence(a, b) != 2) return none;
    const int g = connectivity.face_across(f, a, b);
    return connectivity.next_vertex(g, b) == a ? g : none;
  }

  std::vector<Triangle> triangles_;
  std::vector<Face> across_;
};

}  // namespace curvdecim::detail
