// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/allocate.h>
#include <vcg/complex/complex.h>

namespace curvdecim::detail {

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
