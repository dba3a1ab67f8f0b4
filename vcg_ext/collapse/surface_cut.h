// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// A cut of the surface along a path of edges: at each of its vertices the faces to the right of it
/// go over to a copy of the vertex. A closed path of three edges gets a face on each side that has
/// faces, so that no hole is left.
class SurfaceCut {
 public:
  /// path: two vertices, an edge from boundary to boundary, or three, a loop.
  SurfaceCut(const WorkingMesh& mesh, std::vector<int> path)
      : mesh_(mesh), path_(std::move(path)), right_(path_.size()) {
    if (is_loop() && !has_face_along()) std::swap(path_[1], path_[2]);
    is_possible_ = is_oriented();
    for (int i = 0; i < size(); ++i) is_possible_ = is_possible_ && find_right(i);
    const auto is_empty = [](const std::vector<int>& faces) { return faces.empty(); };
    if (is_loop() && std::all_of(right_.begin(), right_.end(), is_empty)) fills_ = true;
    if (!is_loop() && std::any_of(right_.begin(), right_.end(), is_empty)) is_possible_ = false;
  }

  /// False where the faces around a vertex are not parted by the path.
  bool is_possible() const { return is_possible_; }
  bool is_loop() const { return path_.size() == 3; }
  /// True if the loop is the boundary of a hole: nothing is copied.
  bool fills() const { return fills_; }
  /// Slots that it takes.
  int new_vertices() const { return fills_ ? 0 : size(); }
  int new_faces() const { return is_loop() ? 2 - fills_ : 0; }

  const std::vector<int>& path() const { return path_; }
  /// The faces at path()[i] that go over.
  const std::vector<int>& right(int i) const { return right_[i]; }

 private:
  static constexpr int none = -1;

  int size() const { return static_cast<int>(path_.size()); }
  int before(int i) const { return is_loop() ? path_[(i + 2) % 3] : i == 1 ? path_[0] : none; }
  int after(int i) const { return is_loop() ? path_[(i + 1) % 3] : i == 0 ? path_[1] : none; }

  /// True if the face runs from one to the other; none: there is no such edge.
  bool has_directed(int f, int from, int to) const {
    return from != none && mesh_.connectivity.face_has(f, from) &&
           mesh_.connectivity.next_vertex(f, from) == to;
  }

  /// How many faces run along the path's edge from its i-th vertex, and against it.
  std::array<int, 2> faces_along(int i) const {
    const int from = path_[i], to = after(i);
    std::array<int, 2> count{};
    for (int f : mesh_.connectivity.faces_of(from))
      if (to != none && mesh_.connectivity.face_has(f, to)) ++count[!has_directed(f, from, to)];
    return count;
  }

  bool has_face_along() const {
    bool found = false;
    for (int i = 0; i < size(); ++i) found = found || faces_along(i)[0] > 0;
    return found;
  }

  /// One face at most on each side of each edge: elsewhere left and right mean nothing.
  bool is_oriented() const {
    for (int i = 0; i < size(); ++i)
      if (const auto [along, against] = faces_along(i); along > 1 || against > 1) return false;
    return true;
  }

  /// False if a face is on both sides.
  bool find_right(int i) {
    const int v = path_[i], p = before(i), n = after(i);
    const auto follows = [&](int f) {  // an edge of the path lies along the face's left side
      return has_directed(f, v, n) || has_directed(f, p, v);
    };
    const auto opposes = [&](int f) { return has_directed(f, v, p) || has_directed(f, n, v); };
    std::vector<int>& faces = right_[i];
    for (int f : mesh_.connectivity.faces_of(v))
      if (opposes(f)) faces.push_back(f);
    for (std::size_t k = 0; k < faces.size(); ++k) add_neighbors(faces[k], v, p, n, faces);
    return std::none_of(faces.begin(), faces.end(), follows);
  }

  void add_neighbors(int f, int v, int p, int n, std::vector<int>& faces) const {
    for (int u : mesh_.connectivity.face(f)) {
      if (u == v || u == p || u == n) continue;
      for (int g : mesh_.connectivity.faces_of(v))
        if (mesh_.connectivity.face_has(g, u) &&
            std::find(faces.begin(), faces.end(), g) == faces.end())
          faces.push_back(g);
    }
  }

  const WorkingMesh& mesh_;
  std::vector<int> path_;
  std::vector<std::vector<int>> right_;  // by place on the path
  bool is_possible_ = true, fills_ = false;
};

}  // namespace curvdecim::detail
