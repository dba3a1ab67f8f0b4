// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "vcg_ext/errors.h"
#include "vcg_ext/geometry/vector3.h"

namespace curvdecim::detail {

/// Throws InputError where there is no triangle mesh.
template <class MeshType>
void require_faces(const MeshType& mesh) {
  if (mesh.vn == 0) throw InputError("The mesh is empty; load a triangle mesh first.");
  if (mesh.fn == 0)
    throw InputError(
        "The mesh has " + std::to_string(mesh.vn) +
        " points but no faces; decimation needs a triangle mesh. Reconstruct a surface first.");
}

template <class MeshType>
Vector3 point_of(const MeshType& mesh, int v) {
  return vector_of(mesh.vert[v].cP());
}

/// The vertex at a corner of a face; -1 where the face uses no living vertex of the mesh.
template <class MeshType>
int vertex_at(const MeshType& mesh, int f, int corner) {
  const auto* vertex = mesh.face[f].cV(corner);
  const auto index = vertex ? vertex - mesh.vert.data() : -1;
  const bool exists = index >= 0 && index < static_cast<std::ptrdiff_t>(mesh.vert.size());
  return exists && !vertex->IsD() ? static_cast<int>(index) : -1;
}

/// The same. Throws InputError where the face uses a vertex that it cannot.
template <class MeshType>
int usable_vertex_at(const MeshType& mesh, int f, int corner) {
  const int v = vertex_at(mesh, f, corner);
  if (v < 0)
    throw InputError("Face " + std::to_string(f) +
                     " refers to a vertex that does not exist. Clean the mesh first.");
  if (!point_of(mesh, v).allFinite())
    throw InputError("Vertex " + std::to_string(v) + " of face " + std::to_string(f) +
                     " has a coordinate that is not finite. Delete it or its faces first.");
  return v;
}

}  // namespace curvdecim::detail
