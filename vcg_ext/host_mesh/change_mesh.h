// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/allocate.h>
#include <vcg/complex/complex.h>

#include <array>

#include "vcg_ext/geometry/vector3.h"

namespace curvdecim::detail {

/// Gives a face these vertices. One that does not change keeps its normal. moved: whether a vertex
/// is.
template <class MeshType>
void connect_face(MeshType& mesh, int f,
                  const std::array<typename MeshType::VertexType*, 3>& vertices, bool moved,
                  const Vector3& normal) {
  auto& face = mesh.face[f];
  for (int i = 0; i < 3; ++i) {
    moved = moved || face.cV(i) != vertices[i];
    face.V(i) = vertices[i];
  }
  if (!moved) return;
  if (vcg::tri::HasPerFaceNormal(mesh)) assign(face.N(), normal);
}

/// Marks of edges inside polygons (faux edges) mean nothing once a polygon is cut: what could
/// change has none afterwards, so that it is of triangles. mesh: compact, so that only what is left
/// is looked at.
template <class MeshType>
void drop_polygons(MeshType& mesh, bool selected_only) {
  for (auto& face : mesh.face)
    if (!selected_only || face.IsS()) face.ClearAllF();
}

/// Compaction follows these pointers; after a change of the faces they lead nowhere.
template <class MeshType>
void clear_adjacency(MeshType& mesh) {
  if (vcg::tri::HasVFAdjacency(mesh)) {
    for (auto& v : mesh.vert) v.VFClear();
    for (auto& f : mesh.face)
      for (int i = 0; i < 3; ++i) f.VFClear(i);
  }
  if (vcg::tri::HasFFAdjacency(mesh))
    for (auto& f : mesh.face)
      for (int i = 0; i < 3; ++i) f.FFp(i) = nullptr;
}

/// The end of every change: no deleted element is left, the adjacency relations are empty and the
/// bounding box fits.
template <class MeshType>
void compact_mesh(MeshType& mesh) {
  clear_adjacency(mesh);
  vcg::tri::Allocator<MeshType>::CompactEveryVector(mesh);
  vcg::tri::UpdateBounding<MeshType>::Box(mesh);
}

}  // namespace curvdecim::detail
