// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <algorithm>

#include "vcg_ext/host_mesh/attributes.h"
#include "vcg_ext/host_mesh/working_copy.h"
#include "vcg_ext/mesh/border_seams.h"

namespace curvdecim::detail {

/// True if two vertices of the host's mesh carry the same. Normals do not count: a host computes
/// them, and at a crease every copy has that of its own faces.
template <class MeshType>
bool carry_the_same(const MeshType& mesh, int v, int w) {
  const auto &a = mesh.vert[v], &b = mesh.vert[w];
  return (!vcg::tri::HasPerVertexColor(mesh) || a.cC() == b.cC()) &&
         (!vcg::tri::HasPerVertexQuality(mesh) || a.cQ() == b.cQ()) &&
         (!vcg::tri::HasPerVertexRadius(mesh) || a.cR() == b.cR()) &&
         (!vcg::tri::HasPerVertexTexCoord(mesh) || a.cT() == b.cT()) &&
         (!vcg::tri::HasPerVertexCurvatureDir(mesh) ||
          (curvatures_of(a) == curvatures_of(b) &&
           curvature_directions_of(a) == curvature_directions_of(b))) &&
         std::all_of(mesh.vert_attr.begin(), mesh.vert_attr.end(),
                     [&](const auto& attribute) { return has_same_bits(attribute, v, w); });
}

/// Joins borders that lie on each other. The first one of the host's vertices in a place stands for
/// the others.
inline void join_borders(WorkingCopy& copy, const Parallel& parallel) {
  BorderSeams seams(copy.mesh, parallel);
  Revertexed joined = seams.join();
  if (joined.faces.empty()) return;
  copy.borders_joined = seams.joined();
  reconnect(copy, std::move(joined), parallel);
}

}  // namespace curvdecim::detail
