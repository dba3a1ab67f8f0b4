// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/connectivity/triangle_connectivity.h"
#include "vcg_ext/connectivity/vertex_marks.h"

namespace curvdecim {

struct Edge {
  int a, b;  // a < b
};

inline constexpr Edge no_edge{-1, -1};

/// What surrounds an edge: the faces that its collapse removes (wings) with their third vertices,
/// and the faces that it reshapes (star). Reused from edge to edge.
class EdgeNeighborhood {
 public:
  explicit EdgeNeighborhood(int vertices) : around_a_(vertices) {}

  void gather(const TriangleConnectivity& connectivity, Edge edge) {
    edge_ = edge;
    wings_.clear(), thirds_.clear(), star_.clear();
    for (int f : connectivity.faces_of(edge.a)) {
      if (!connectivity.face_has(f, edge.b)) {
        star_.push_back(f);
        continue;
      }
      wings_.push_back(f);
      thirds_.push_back(connectivity.third_vertex(f, edge.a, edge.b));
    }
    for (int f : connectivity.faces_of(edge.b))
      if (!connectivity.face_has(f, edge.a)) star_.push_back(f);
    count_common_neighbors(connectivity);
  }

  Edge edge() const { return edge_; }
  const std::vector<int>& wings() const { return wings_; }
  const std::vector<int>& thirds() const { return thirds_; }
  const std::vector<int>& star() const { return star_; }
  int common_neighbors() const { return common_neighbors_; }

 private:
  void count_common_neighbors(const TriangleConnectivity& connectivity) {
    around_a_.clear();
    for (int f : connectivity.faces_of(edge_.a))
      for (int v : connectivity.face(f)) around_a_.insert(v);
    around_a_.erase(edge_.a), around_a_.erase(edge_.b);
    common_neighbors_ = 0;
    for (int f : connectivity.faces_of(edge_.b))
      for (int v : connectivity.face(f)) common_neighbors_ += around_a_.erase(v);
  }

  Edge edge_{};
  std::vector<int> wings_, thirds_, star_;
  VertexMarks around_a_;
  int common_neighbors_ = 0;
};

inline bool is_boundary_edge(const TriangleConnectivity& connectivity, int a, int b) {
  return connectivity.edge_valence(a, b) == 1;
}

/// An edge of the boundary, or one where more than two faces meet.
inline bool is_singular_edge(const TriangleConnectivity& connectivity, int a, int b) {
  return connectivity.edge_valence(a, b) != 2;
}

/// Calls visit(u) once for every neighbour u of v.
template <class Visit>
void for_each_neighbor(const TriangleConnectivity& connectivity, int v, VertexMarks& marks,
                       Visit visit) {
  marks.clear();
  marks.insert(v);
  for (int f : connectivity.faces_of(v))
    for (int u : connectivity.face(f))
      if (marks.insert(u)) visit(u);
}

}  // namespace curvdecim
