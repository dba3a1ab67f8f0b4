// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "vcg_ext/clustering/first_seen.h"
#include "vcg_ext/mesh/flat_mesh.h"

namespace curvdecim {

/// An edge with one face.
struct BoundaryEdge {
  int a, b;  // vertices
  int face;
};

/// By vertex: whether its faces, as far as their orientation tells, do not close around it. Around
/// a vertex whose faces do, each neighbour comes once as the next corner and once as the one
/// before, so that their signed sum is 0; for others it is not, unless many neighbours conspire.
inline std::vector<bool> open_vertices(const FlatMesh& mesh) {
  // A square, and a multiple with bits all over the word: both would have to add up by chance.
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio
  const auto scrambled = [](int v) { return std::uint64_t(v) * (std::uint64_t(v) + golden); };
  std::vector<std::uint64_t> next_minus_previous(mesh.position.size(), 0);
  for (const Face& face : mesh.faces) {
    if (face == FlatMesh::no_face) continue;
    const std::array<std::uint64_t, 3> number = {scrambled(face[0]), scrambled(face[1]),
                                                 scrambled(face[2])};
    for (int i = 0; i < 3; ++i)
      next_minus_previous[face[i]] += number[(i + 1) % 3] - number[(i + 2) % 3];
  }
  std::vector<bool> open(mesh.position.size());
  for (std::size_t v = 0; v < open.size(); ++v) open[v] = next_minus_previous[v] != 0;
  return open;
}

/// In the order of their faces.
inline std::vector<BoundaryEdge> boundary_edges(const FlatMesh& mesh) {
  const std::vector<bool> open = open_vertices(mesh);
  FirstSeen<std::array<int, 2>> seen;
  std::vector<BoundaryEdge> first;  // by number
  std::vector<int> uses;
  for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
    const Face& face = mesh.faces[f];
    for (int i = 0; i < 3 && face != FlatMesh::no_face; ++i) {
      const int a = face[i], b = face[(i + 1) % 3];
      if (!open[a] || !open[b] || a == b) continue;
      const int number = seen.number({std::min(a, b), std::max(a, b)});
      if (number == static_cast<int>(first.size())) first.push_back({a, b, f}), uses.push_back(0);
      ++uses[number];
    }
  }
  std::vector<BoundaryEdge> edges;
  for (std::size_t i = 0; i < first.size(); ++i)
    if (uses[i] == 1) edges.push_back(first[i]);
  return edges;
}

}  // namespace curvdecim
