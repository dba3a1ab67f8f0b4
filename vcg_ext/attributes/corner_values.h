// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// What the corners of faces carry, and where faces do not agree about a vertex.
template <class Value>
class CornerValues {
 public:
  using OfFace = std::array<Value, 3>;

  explicit CornerValues(std::vector<OfFace> of_face) : of_face_(std::move(of_face)) {}

  OfFace& operator[](int f) { return of_face_[f]; }
  const OfFace& operator[](int f) const { return of_face_[f]; }

  /// The value of face f at its vertex v.
  Value& at(const WorkingMesh& mesh, int f, int v) {
    return of_face_[f][mesh.connectivity.corner(f, v)];
  }
  const Value& at(const WorkingMesh& mesh, int f, int v) const {
    return of_face_[f][mesh.connectivity.corner(f, v)];
  }

  /// Each corner of a new face is as in another face of its vertex.
  void add(const WorkingMesh& mesh, int f) {
    for (int v : mesh.connectivity.face(f))
      for (int g : mesh.connectivity.faces_of(v))
        if (g != f) at(mesh, f, v) = at(mesh, g, v);
  }

  /// True if a vertex has different values in different faces.
  bool on_seam(const WorkingMesh& mesh, int v) const {
    const auto faces = mesh.connectivity.faces_of(v);
    return std::any_of(faces.begin(), faces.end(),
                       [&](int f) { return !(at(mesh, f, v) == at(mesh, *faces.begin(), v)); });
  }

  /// True if two faces do not agree about an end of their edge.
  bool is_seam(const WorkingMesh& mesh, int f, int g, int a, int b) const {
    return !(at(mesh, f, a) == at(mesh, g, a)) || !(at(mesh, f, b) == at(mesh, g, b));
  }

  /// Before TriangleConnectivity::flip of an edge that is no seam.
  void flip(const WorkingMesh& mesh, int f, int g, int a, int b) {
    const Value at_c = at(mesh, f, mesh.connectivity.third_vertex(f, a, b));
    const Value at_d = at(mesh, g, mesh.connectivity.third_vertex(g, a, b));
    at(mesh, f, b) = at_d;
    at(mesh, g, a) = at_c;
  }

  void renumber(const Renumbering& numbers) { numbers.faces(of_face_); }

 private:
  std::vector<OfFace> of_face_;
};

}  // namespace curvdecim::detail
