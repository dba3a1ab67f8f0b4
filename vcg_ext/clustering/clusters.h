// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "vcg_ext/clustering/cell_grid.h"
#include "vcg_ext/clustering/distinct_faces.h"
#include "vcg_ext/clustering/first_seen.h"
#include "vcg_ext/clustering/flat_mesh.h"
#include "vcg_ext/parallel/pieces.h"

namespace curvdecim::detail {

/// The vertices in cells, and the faces that are left between them @cite rossignac1993.
struct Clusters {
  static constexpr int none = -1;

  double diameter;  // of a cell, in the unit box
  CellGrid grid;
  std::vector<int> cell_of;     // by vertex; none where it is not in use
  std::vector<CellKey> keys;    // by cell, in the order of their first vertices
  std::vector<CellFace> faces;  // no two between the same three cells
  std::int64_t crossing = 0;    // faces of the input between three cells
  int crowded = 0;              // faces that were dropped at edges with more than two

  int cells() const { return static_cast<int>(keys.size()); }
  Face cells_of(const Face& face) const {
    return {cell_of[face[0]], cell_of[face[1]], cell_of[face[2]]};
  }

  /// A vertex that must stay is a cell of its own.
  static constexpr CellKey fixed_bit = CellKey(1) << 63;
  static bool is_fixed(CellKey key) { return key & fixed_bit; }
  static int fixed_vertex(CellKey key) { return static_cast<int>(key & ~fixed_bit); }

  CellBox box(int cell, const FlatMesh& mesh) const {
    if (!is_fixed(keys[cell])) return grid.box(keys[cell]);
    const Vector3& p = mesh.position[fixed_vertex(keys[cell])];
    return {p, p};
  }
};

inline CellKey cell_key(const FlatMesh& mesh, const CellGrid& grid, int v) {
  return mesh.role[v] == VertexRole::Fixed ? Clusters::fixed_bit | static_cast<CellKey>(v)
                                           : grid.key(mesh.position[v]);
}

/// Numbers the cells piece by piece; then each piece's numbers become those of all.
inline void number_cells(const FlatMesh& mesh, Clusters& clusters, const Parallel& parallel) {
  const int count = static_cast<int>(mesh.position.size()), pieces = pieces_of(count, parallel);
  clusters.cell_of.resize(count);
  std::vector<FirstSeen<CellKey>> seen(pieces);
  for_pieces(count, pieces, parallel, [&](int piece, int begin, int end) {
    CellKey last = ~CellKey(0);
    int number = Clusters::none;
    for (int v = begin; v < end; ++v) {
      if (mesh.role[v] == VertexRole::Unused) {
        clusters.cell_of[v] = Clusters::none;
        continue;
      }
      const CellKey key = cell_key(mesh, clusters.grid, v);
      if (key != last) last = key, number = seen[piece].number(key);
      clusters.cell_of[v] = number;
    }
  });
  std::vector<std::vector<int>> of_all(pieces);
  for (int piece = 1; piece < pieces; ++piece)
    for (CellKey key : seen[piece].keys()) of_all[piece].push_back(seen[0].number(key));
  for_pieces(count, pieces, parallel, [&](int piece, int begin, int end) {
    for (int v = begin; v < end && piece > 0; ++v)
      if (clusters.cell_of[v] != Clusters::none)
        clusters.cell_of[v] = of_all[piece][clusters.cell_of[v]];
  });
  clusters.keys = seen[0].keys();
}

inline void collect_faces(const FlatMesh& mesh, Clusters& clusters, const Parallel& parallel) {
  const std::vector<int> origins =
      indices_where(static_cast<int>(mesh.faces.size()), parallel, [&](int f) {
        return FlatMesh::is_face(mesh.faces[f]) && !is_degenerate(clusters.cells_of(mesh.faces[f]));
      });
  Array<CellFace> crossing(origins.size());
  parallel.for_each(static_cast<int>(origins.size()), [&](int i) {
    crossing[i] = {clusters.cells_of(mesh.faces[origins[i]]), origins[i]};
  });
  clusters.crossing = static_cast<std::int64_t>(crossing.size());
  clusters.faces = DistinctFaces(crossing, clusters.cells(), parallel).left();
}

inline Clusters cluster(const FlatMesh& mesh, double diameter, const Parallel& parallel) {
  Clusters clusters{diameter, CellGrid(mesh.half_size, diameter), {}, {}, {}};
  number_cells(mesh, clusters, parallel);
  collect_faces(mesh, clusters, parallel);
  return clusters;
}

}  // namespace curvdecim::detail
