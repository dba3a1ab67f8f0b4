// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

#include "vcg_ext/geometry/vector3.h"
#include "vcg_ext/mesh/triangle_connectivity.h"

namespace curvdecim::detail {

struct Edge {
  int a, b;  // a < b
};

inline constexpr Edge no_edge{-1, -1};

/// What surrounds an edge: the faces that its collapse removes (wings) with their third vertices,
/// and the faces that it reshapes (star). Reused from edge to edge.
class EdgeNeighborhood {
 public:
  void gather(const TriangleConnectivity& connectivity, Edge edge) {
    assert(edge.a < edge.b);
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
    star_of_a_ = star_.size();
    for (int f : connectivity.faces_of(edge.b))
      if (!connectivity.face_has(f, edge.a)) star_.push_back(f);
  }

  Edge edge() const { return edge_; }
  const std::vector<int>& wings() const { return wings_; }
  const std::vector<int>& thirds() const { return thirds_; }
  /// Those at edge().a come first.
  const std::vector<int>& star() const { return star_; }
  std::size_t star_of_a() const { return star_of_a_; }

 private:
  Edge edge_{};
  std::vector<int> wings_, thirds_, star_;
  std::size_t star_of_a_ = 0;
};

inline bool is_boundary_edge(const TriangleConnectivity& connectivity, int a, int b) {
  return connectivity.edge_valence(a, b) == 1;
}

/// An edge of the boundary, or one where more than two faces meet.
inline bool is_singular_edge(const TriangleConnectivity& connectivity, int a, int b) {
  return connectivity.edge_valence(a, b) != 2;
}

/// Two vertices that became one: `gone` went into `keep`.
struct VertexMerge {
  int keep, gone;
  Vector3 keep_was, gone_was;  // positions before
  Vector3 now;                 // position after
  double t;                    // 0: where keep was, 1: where gone was

  bool has(int v) const { return v == keep || v == gone; }
};

}  // namespace curvdecim::detail
