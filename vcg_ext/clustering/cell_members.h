// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/clustering/clusters.h"
#include "vcg_ext/mesh/triangle_connectivity.h"

namespace curvdecim::detail {

/// Numbers in groups, ascending in each.
class Groups {
 public:
  /// groups_of(i, take) calls take(group) for each group of i, below count.
  template <class GroupsOf>
  Groups(int groups, int count, GroupsOf groups_of) : begin_(groups + 1, 0) {
    for (int i = 0; i < count; ++i) groups_of(i, [&](int group) { ++begin_[group + 1]; });
    for (int group = 0; group < groups; ++group) begin_[group + 1] += begin_[group];
    items_.resize(begin_.back());
    std::vector<int> end(begin_.begin(), begin_.end() - 1);
    for (int i = 0; i < count; ++i) groups_of(i, [&](int group) { items_[end[group]++] = i; });
  }

  IndexRange operator[](int group) const {
    return {items_.data() + begin_[group], items_.data() + begin_[group + 1]};
  }

 private:
  std::vector<int> begin_;  // by group, and the end of the last
  std::vector<int> items_;
};

inline Groups vertices_by_cell(const Clusters& clusters) {
  return Groups(clusters.cells(), static_cast<int>(clusters.cell_of.size()), [&](int v, auto take) {
    if (clusters.cell_of[v] != Clusters::none) take(clusters.cell_of[v]);
  });
}

/// The faces with a corner in a cell.
inline Groups faces_by_cell(const FlatMesh& mesh, const Clusters& clusters) {
  return Groups(clusters.cells(), static_cast<int>(mesh.faces.size()), [&](int f, auto take) {
    if (FlatMesh::is_face(mesh.faces[f])) for_different(clusters.cells_of(mesh.faces[f]), take);
  });
}

}  // namespace curvdecim::detail
