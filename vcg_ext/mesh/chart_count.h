// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/mesh/disjoint_sets.h"
#include "vcg_ext/mesh/seams.h"

namespace curvdecim::detail {

/// Parts of a mesh with wedges, of which no face is dead, that its seams cut it into.
inline int count_charts(const WorkingMesh& mesh) {
  const TriangleConnectivity& connectivity = mesh.connectivity;
  DisjointSets charts(connectivity.face_slots());
  int count = connectivity.face_slots();
  for (int f = 0; f < connectivity.face_slots(); ++f)
    for (int v : connectivity.face(f)) {
      const int next = connectivity.next_vertex(f, v);
      const int across = connectivity.face_across(f, v, next);
      if (across < 0 || mesh.wedges.differ(connectivity, f, across, v, next)) continue;
      if (charts.unite(f, across)) --count;
    }
  return count;
}

}  // namespace curvdecim::detail
