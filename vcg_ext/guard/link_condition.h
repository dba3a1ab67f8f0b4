// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// True if the ends have a common neighbour other than the third vertices of the faces at the edge.
/// Most neighbours of b are ruled out by a bit each of those of a.
inline bool has_other_common_neighbor(const TriangleConnectivity& connectivity,
                                      const EdgeNeighborhood& around) {
  const auto [a, b] = around.edge();
  const std::vector<int>&thirds = around.thirds(), &star = around.star();
  const auto bit = [](int v) { return std::uint64_t{1} << (v & 63); };
  std::uint64_t near_a = 0;
  for (std::size_t i = 0; i < around.star_of_a(); ++i)
    for (int u : connectivity.face(star[i])) near_a |= bit(u);
  for (std::size_t i = around.star_of_a(); i < star.size(); ++i)
    for (int u : connectivity.face(star[i]))
      if (u != b && (near_a & bit(u)) != 0 &&
          std::find(thirds.begin(), thirds.end(), u) == thirds.end() && connectivity.has_edge(a, u))
        return true;
  return false;
}

/// Link condition @cite dey1999: the links of both ends meet in the link of the edge and nowhere
/// else, and the same holds within the graph of singular edges. So no hole closes or merges with
/// another, no component vanishes and no face doubles another.
inline bool satisfies_link_condition(const WorkingMesh& mesh, const EdgeNeighborhood& around) {
  const TriangleConnectivity& connectivity = mesh.connectivity;
  const auto [a, b] = around.edge();
  const std::vector<int>& thirds = around.thirds();
  if (has_other_common_neighbor(connectivity, around)) return false;
  if (mesh.kind[a] != VertexKind::Interior && mesh.kind[b] != VertexKind::Interior &&
      thirds.size() == 2)
    return false;
  for (std::size_t i = 0; i < thirds.size(); ++i) {
    if (is_singular_edge(connectivity, a, thirds[i]) &&
        is_singular_edge(connectivity, b, thirds[i]))
      return false;
    for (std::size_t j = 0; j < i; ++j)
      if (connectivity.find_face(a, thirds[i], thirds[j]) >= 0 &&
          connectivity.find_face(b, thirds[i], thirds[j]) >= 0)
        return false;
  }
  return true;
}

}  // namespace curvdecim::detail
