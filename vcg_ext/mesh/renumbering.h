// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/triangle_connectivity.h"

namespace curvdecim::detail {

/// New numbers for what is left of a mesh, in the old order: close in memory again, so that later
/// work does not read what is gone.
class Renumbering {
 public:
  static constexpr int gone = -1;

  explicit Renumbering(const TriangleConnectivity& connectivity)
      : new_vertex_(connectivity.vertex_slots(), gone) {
    old_vertex_.reserve(connectivity.vertex_count());
    old_face_.reserve(connectivity.face_count());
    for (int v = 0; v < connectivity.vertex_slots(); ++v) {
      if (connectivity.faces_of(v).size() == 0) continue;
      new_vertex_[v] = static_cast<int>(old_vertex_.size());
      old_vertex_.push_back(v);
    }
    for (int f = 0; f < connectivity.face_slots(); ++f)
      if (connectivity.alive(f)) old_face_.push_back(f);
  }

  /// The new number of an old vertex, or gone.
  int vertex(int old) const { return new_vertex_[old]; }

  /// Keep of an array by vertex, or by face, what is left. An empty array stays empty.
  template <class T>
  void vertices(std::vector<T>& by_vertex) const {
    keep(old_vertex_, by_vertex);
  }
  template <class T>
  void faces(std::vector<T>& by_face) const {
    keep(old_face_, by_face);
  }

  /// The same for the connectivity, in the memory that it has.
  void apply(TriangleConnectivity& connectivity) const {
    connectivity.keep(old_face_, new_vertex_, static_cast<int>(old_vertex_.size()));
  }

 private:
  template <class T>
  static void keep(const std::vector<int>& old, std::vector<T>& array) {
    if (array.empty()) return;
    assert(old.size() <= array.size());
    for (std::size_t i = 0; i < old.size(); ++i) array[i] = array[old[i]];
    array.resize(old.size());
  }

  std::vector<int> new_vertex_;             // by old vertex
  std::vector<int> old_vertex_, old_face_;  // by new number
};

}  // namespace curvdecim::detail
