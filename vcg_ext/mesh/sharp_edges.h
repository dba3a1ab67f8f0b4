// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// Tells which edges are sharp: those between faces whose normals differ by an angle or more.
class SharpEdges {
 public:
  /// angle: degrees; 180: no edge is sharp.
  SharpEdges(const WorkingMesh& mesh, double angle)
      : mesh_(mesh),
        none_(angle >= 180.0),
        cosine_(cosine_of(angle)),
        cosine_of_half_(cosine_of(0.5 * angle)) {}

  /// No edge is sharp, whatever the mesh.
  bool none() const { return none_; }

  /// The edge between two faces.
  bool between(int f, int g) const { return !none_ && cosine_between(f, g) <= cosine_; }

  /// Sure to have none: all faces around v turn from one of them by less than half the angle.
  bool none_at(int v) const {
    const auto faces = mesh_.connectivity.faces_of(v);
    return std::all_of(faces.begin(), faces.end(),
                       [&](int f) { return cosine_between(f, *faces.begin()) > cosine_of_half_; });
  }

 private:
  static double cosine_of(double degrees) { return std::cos(degrees * (M_PI / 180.0)); }

  double cosine_between(int f, int g) const {
    return mesh_.plane[f].normal.dot(mesh_.plane[g].normal);
  }

  const WorkingMesh& mesh_;
  const bool none_;
  const double cosine_, cosine_of_half_;
};

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

}  // namespace curvdecim::detail
