// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <vector>

#include "vcg_ext/host_mesh/attributes.h"
#include "vcg_ext/mesh/wedge_coordinate.h"
#include "vcg_ext/parallel/pieces.h"

namespace curvdecim::detail {

/// The texture coordinates of a vcg mesh: those of its wedges, or of its vertices where it has no
/// others and they vary, as in files that write a vertex once for each.
template <class MeshType>
class HostTexture {
 public:
  HostTexture(const MeshType& mesh, const Parallel& parallel)
      : mesh_(mesh),
        by_wedge_(vcg::tri::HasPerWedgeTexCoord(mesh)),
        by_vertex_(!by_wedge_ && vcg::tri::HasPerVertexTexCoord(mesh) && varies(mesh, parallel)) {}

  bool exists() const { return by_wedge_ || by_vertex_; }

  /// At a corner of face f, if there is a texture.
  WedgeCoordinate at(int f, int corner) const {
    const auto& face = mesh_.face[f];
    if (by_wedge_) return coordinate_of(face.cWT(corner));
    return by_vertex_ ? coordinate_of(face.cV(corner)->cT()) : WedgeCoordinate();
  }

 private:
  static bool varies(const MeshType& mesh, const Parallel& parallel) {
    return any_where(static_cast<int>(mesh.vert.size()), parallel,
                     [&](int v) { return mesh.vert[v].cT() != mesh.vert[0].cT(); });
  }

  const MeshType& mesh_;
  const bool by_wedge_, by_vertex_;
};

}  // namespace curvdecim::detail
