// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/clustering/cell_grid.h"
#include "vcg_ext/clustering/first_seen.h"
#include "vcg_ext/clustering/flat_mesh.h"
#include "vcg_ext/parallel/pieces.h"

namespace curvdecim::detail {

/// A face between three different cells, with the face of the input that it comes from.
struct CellFace {
  Face cells;
  int origin;
};

/// The different faces between cells. Of several between the same three, the one stays that came
/// first among those of the more frequent orientation.
class CellFaceSet {
 public:
  void add(const Face& cells, int origin) {
    ++added_;
    const auto [key, even] = sorted(cells);
    entry_of(key).add(origin, even);
  }

  /// `later` has seen later faces only.
  void merge(const CellFaceSet& later) {
    added_ += later.added_;
    for (int i = 0; i < later.size(); ++i) entry_of(later.seen_.keys()[i]) += later.entries_[i];
  }

  int size() const { return seen_.size(); }
  std::int64_t added() const { return added_; }
  int origin(int i) const { return entries_[i].origin(); }

 private:
  static constexpr int none = -1;

  struct Entry {
    std::array<int, 2> first = {none, none};  // by orientation
    int balance = 0;

    void add(int origin, bool even) {
      if (first[even] == none) first[even] = origin;
      balance += even ? 1 : -1;
    }
    void operator+=(const Entry& later) {
      for (int even : {0, 1})
        if (first[even] == none) first[even] = later.first[even];
      balance += later.balance;
    }
    int origin() const {
      if (balance != 0) return first[balance > 0];
      return std::min(first[0], first[1]);
    }
  };

  /// Ascending, and whether an even number of swaps led there.
  static std::pair<Face, bool> sorted(Face face) {
    bool even = true;
    const auto order = [&](int& a, int& b) {
      if (a > b) std::swap(a, b), even = !even;
    };
    order(face[0], face[1]), order(face[1], face[2]), order(face[0], face[1]);
    return {face, even};
  }

  Entry& entry_of(const Face& key) {
    const int number = seen_.number(key);
    if (number == static_cast<int>(entries_.size())) entries_.emplace_back();
    return entries_[number];
  }

  FirstSeen<Face> seen_;
  std::vector<Entry> entries_;  // by number
  std::int64_t added_ = 0;
};

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
  const int count = static_cast<int>(mesh.faces.size()), pieces = pieces_of(count, parallel);
  std::vector<CellFaceSet> sets(pieces);
  for_pieces(count, pieces, parallel, [&](int piece, int begin, int end) {
    for (int f = begin; f < end; ++f) {
      if (!FlatMesh::is_face(mesh.faces[f])) continue;
      const Face cells = clusters.cells_of(mesh.faces[f]);
      if (!is_degenerate(cells)) sets[piece].add(cells, f);
    }
  });
  for (int piece = 1; piece < pieces; ++piece) sets[0].merge(sets[piece]);
  clusters.crossing = sets[0].added();
  for (int i = 0; i < sets[0].size(); ++i) {
    const int f = sets[0].origin(i);
    clusters.faces.push_back({clusters.cells_of(mesh.faces[f]), f});
  }
}

inline Clusters cluster(const FlatMesh& mesh, double diameter, const Parallel& parallel) {
  Clusters clusters{diameter, CellGrid(mesh.half_size, diameter), {}, {}, {}};
  number_cells(mesh, clusters, parallel);
  collect_faces(mesh, clusters, parallel);
  return clusters;
}

}  // namespace curvdecim::detail
