// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <vector>

#include "vcg_ext/host_mesh/working_copy.h"
#include "vcg_ext/parallel/pieces.h"

namespace curvdecim::detail {

/// Gives the copy, whose wedges are known, the colours of the host's vertices, where they vary, so
/// that they count in the collapses. Its vertices are its wedges then, if it had none.
template <class MeshType>
void read_colors(const MeshType& mesh, WorkingCopy& copy, const Parallel& parallel) {
  if (!vcg::tri::HasPerVertexColor(mesh)) return;
  const int count = static_cast<int>(copy.vertex_of.size());
  const auto color_of = [&](int i) { return mesh.vert[copy.vertex_of[i]].cC(); };
  if (!any_where(count, parallel, [&](int i) { return color_of(i) != color_of(0); })) return;
  if (!copy.mesh.wedges.exist()) {
    std::vector<Face> corners(copy.mesh.connectivity.face_slots());
    parallel.for_each(static_cast<int>(corners.size()),
                      [&](int f) { corners[f] = copy.mesh.connectivity.face(f); });
    copy.mesh.wedges = Wedges(std::move(corners), count);
  }
  copy.mesh.color.resize(count);
  parallel.for_each(count, [&](int i) {
    const auto& color = mesh.vert[copy.vertex_of[i]].cC();
    copy.mesh.color[i] = Vector3(color[0], color[1], color[2]) / 255.0;
  });
}

}  // namespace curvdecim::detail
