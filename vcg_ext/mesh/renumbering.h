// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <numeric>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/triangle_connectivity.h"

namespace curvdecim::detail {

/// New numbers for what is left of a mesh, in the old order: close in memory again, so that later
/// work does not read what is gone. Or the old numbers, and room for more.
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

  /// All keep their numbers; after them come those of vertices and faces that are to be made.
  Renumbering(const TriangleConnectivity& connectivity, int more_vertices, int more_faces)
      : new_vertex_(connectivity.vertex_slots()),
        old_face_(connectivity.face_slots()),
        more_vertices_(more_vertices),
        more_faces_(more_faces) {
    std::iota(new_vertex_.begin(), new_vertex_.end(), 0);
    std::iota(old_face_.begin(), old_face_.end(), 0);
    old_vertex_ = new_vertex_;
  }

  /// The new number of an old vertex, or gone.
  int vertex(int old) const { return new_vertex_[old]; }

  /// Keep of an array by vertex, or by face, what is left. An empty array stays empty.
  template <class T, class Memory>
  void vertices(std::vector<T, Memory>& by_vertex) const {
    keep(old_vertex_, more_vertices_, by_vertex);
  }
  template <class T, class Memory>
  void faces(std::vector<T, Memory>& by_face) const {
    keep(old_face_, more_faces_, by_face);
  }

  /// The same for numbers that are given once each, of which `next` is the first that is free.
  void vertices(std::vector<int>& by_vertex, int& next) const {
    vertices(by_vertex);
    std::iota(by_vertex.end() - more_vertices_, by_vertex.end(), next);
    next += more_vertices_;
  }
  void faces(std::vector<int>& by_face, int& next) const {
    faces(by_face);
    std::iota(by_face.end() - more_faces_, by_face.end(), next);
    next += more_faces_;
  }

  /// The same for the connectivity, in the memory that it has if there is room for no more.
  void apply(TriangleConnectivity& connectivity) const {
    if (more_vertices_ + more_faces_ > 0)
      connectivity.extend(more_vertices_, more_faces_);
    else
      connectivity.keep(old_face_, new_vertex_, static_cast<int>(old_vertex_.size()));
  }

 private:
  template <class T, class Memory>
  static void keep(const std::vector<int>& old, int more, std::vector<T, Memory>& array) {
    if (array.empty()) return;
    assert(old.size() <= array.size());
    for (std::size_t i = 0; i < old.size(); ++i) array[i] = array[old[i]];
    array.reserve(old.size() + more);  // to double it would be too much
    array.resize(old.size() + more);
  }

  std::vector<int> new_vertex_;             // by old vertex
  std::vector<int> old_vertex_, old_face_;  // by new number
  int more_vertices_ = 0, more_faces_ = 0;
};

}  // namespace curvdecim::detail
