// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "vcg_ext/clustering/first_seen.h"
#include "vcg_ext/clustering/flat_mesh.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// An edge with one face.
struct BoundaryEdge {
  int a, b;  // vertices
  int face;
};

/// Words for the corners of a face, of which no sum vanishes by chance: also sums of neighbours
/// that are numbered in a row.
inline std::array<std::uint64_t, 3> scrambled(const Face& face) {
  const auto word = [](int v) { return mixed(std::uint64_t(v) + 1); };
  return {word(face[0]), word(face[1]), word(face[2])};
}

/// Whether every edge has as many faces on one side as on the other, as far as orientation tells:
/// then none has a single face. An edge run through one way and back adds up to 0.
inline bool is_closed(const FlatMesh& mesh, const Parallel& parallel) {
  std::atomic<std::uint64_t> sum{0};
  parallel.for_ranges(static_cast<int>(mesh.faces.size()), [&](int begin, int end, int) {
    std::uint64_t part = 0;
    for (int f = begin; f < end; ++f) {
      if (!FlatMesh::is_face(mesh.faces[f])) continue;
      const auto [a, b, c] = scrambled(mesh.faces[f]);
      part += a * (b * b - c * c) + b * (c * c - a * a) + c * (a * a - b * b);
    }
    sum += part;
  });
  return sum == 0;
}

/// By vertex: whether its faces, as far as their orientation tells, do not close around it. Around
/// a vertex whose faces do, each neighbour comes once as the next corner and once as the one
/// before, so that their signed sum is 0.
inline std::vector<bool> open_vertices(const FlatMesh& mesh) {
  std::vector<std::uint64_t> next_minus_previous(mesh.position.size(), 0);
  for (const Face& face : mesh.faces) {
    if (!FlatMesh::is_face(face)) continue;
    const std::array<std::uint64_t, 3> word = scrambled(face);
    for (int i = 0; i < 3; ++i)
      next_minus_previous[face[i]] += word[(i + 1) % 3] - word[(i + 2) % 3];
  }
  std::vector<bool> open(mesh.position.size());
  for (std::size_t v = 0; v < open.size(); ++v) open[v] = next_minus_previous[v] != 0;
  return open;
}

/// In the order of their faces.
inline std::vector<BoundaryEdge> boundary_edges(const FlatMesh& mesh, const Parallel& parallel) {
  if (is_closed(mesh, parallel)) return {};
  const std::vector<bool> open = open_vertices(mesh);
  FirstSeen<std::array<int, 2>> seen;
  std::vector<BoundaryEdge> first;  // by number
  std::vector<int> uses;
  for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
    const Face& face = mesh.faces[f];
    for (int i = 0; i < 3 && FlatMesh::is_face(face); ++i) {
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

}  // namespace curvdecim::detail
