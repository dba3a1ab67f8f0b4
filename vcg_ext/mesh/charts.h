// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/mesh/disjoint_sets.h"
#include "vcg_ext/mesh/seams.h"

namespace curvdecim::detail {

/// The parts of a mesh that its seams cut it into.
struct Charts {
  std::vector<int> of_face;  // the least face of its chart
  int count = 0;
};

/// mesh: with wedges; no face is dead.
inline Charts find_charts(const WorkingMesh& mesh) {
  const TriangleConnectivity& connectivity = mesh.connectivity;
  const int faces = connectivity.face_slots();
  DisjointSets parts(faces);
  Charts charts{std::vector<int>(faces), faces};
  for (int f = 0; f < faces; ++f)
    for (int v : connectivity.face(f)) {
      const int next = connectivity.next_vertex(f, v);
      const int across = connectivity.face_across(f, v, next);
      if (across < 0 || mesh.wedges.differ(connectivity, f, across, v, next)) continue;
      if (parts.unite(f, across)) --charts.count;
    }
  for (int f = 0; f < faces; ++f) charts.of_face[f] = parts.root(f);
  return charts;
}

}  // namespace curvdecim::detail
