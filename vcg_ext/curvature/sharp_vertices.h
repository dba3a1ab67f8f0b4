// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel.h"

namespace curvdecim {

/// Tells which vertices are an end of a sharp edge: one whose faces' normals differ by an angle or
/// more.
class SharpVertices {
 public:
  /// angle: degrees; 180: no edge is sharp.
  SharpVertices(const WorkingMesh& mesh, double angle)
      : mesh_(mesh),
        none_(angle >= 180.0),
        cosine_(std::cos(angle * (M_PI / 180.0))),
        cosine_of_half_(std::cos(0.5 * angle * (M_PI / 180.0))) {}

  bool operator()(int v) const {
    if (none_) return false;
    const auto faces = mesh_.connectivity.faces_of(v);
    const auto turns_little = [&](int f) {
      return mesh_.plane[f].normal.dot(mesh_.plane[*faces.begin()].normal) > cosine_of_half_;
    };
    if (std::all_of(faces.begin(), faces.end(), turns_little)) return false;
    if (faces.size() > hub) return true;  // rather than to look at all pairs
    return std::any_of(faces.begin(), faces.end(),
                       [&](int f) { return is_sharp(f, v, mesh_.connectivity.next_vertex(f, v)); });
  }

 private:
  /// Between face f and another one at its edge from v to u.
  bool is_sharp(int f, int v, int u) const {
    for (int g : mesh_.connectivity.faces_of(v))
      if (g != f && mesh_.connectivity.face_has(g, u) &&
          mesh_.plane[f].normal.dot(mesh_.plane[g].normal) <= cosine_)
        return true;
    return false;
  }

  static constexpr int hub = 64;  // faces

  const WorkingMesh& mesh_;
  const bool none_;
  const double cosine_, cosine_of_half_;
};

}  // namespace curvdecim
