// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/mesh/vertex_kind.h"
#include "vcg_ext/report.h"

namespace curvdecim::detail {

/// The faces around a vertex, one after the other, and the loop of neighbours that they leave when
/// they go: face i lies between the neighbours i and i + 1. The loop closes around a vertex inside;
/// on the boundary it runs from end to end. Reused from vertex to vertex.
class VertexFan {
 public:
  static constexpr int longest = 64;  ///< faces: ordering them looks at each for each

  /// False where the faces are not one fan, are not all oriented alike, are two back to back, or
  /// are too many.
  bool gather(const TriangleConnectivity& connectivity, int v) {
    vertex_ = v;
    faces_.clear(), loop_.clear(), edges_.clear();
    if (connectivity.faces_of(v).size() > longest) return false;
    for (int f : connectivity.faces_of(v)) {
      const int from = connectivity.next_vertex(f, v);
      edges_.push_back({from, connectivity.third_vertex(f, v, from), f});
    }
    return !edges_.empty() && walk() && !(closed() && loop_.size() == 2);
  }

  int vertex() const { return vertex_; }
  const std::vector<int>& faces() const { return faces_; }
  const std::vector<int>& loop() const { return loop_; }
  bool closed() const { return loop_.size() == faces_.size(); }

  /// Where in the loop the neighbour stands.
  int place_of(int neighbor) const {
    const auto found = std::find(loop_.begin(), loop_.end(), neighbor);
    assert(found != loop_.end());
    return static_cast<int>(found - loop_.begin());
  }

 private:
  struct LinkEdge {
    int from, to, face;
  };

  bool walk() {
    const int start = first();
    for (int at = start;;) {
      loop_.push_back(at);
      const int i = leading_from(at);
      if (i < 0) break;
      faces_.push_back(edges_[i].face);
      at = edges_[i].to;
      edges_[i] = edges_.back();
      edges_.pop_back();
      if (at == start) break;
    }
    return edges_.empty();
  }

  /// The end that no face leads to; of a closed loop that of the first face.
  int first() const {
    for (const LinkEdge& edge : edges_) {
      const auto leads_here = [&](const LinkEdge& other) { return other.to == edge.from; };
      if (std::none_of(edges_.begin(), edges_.end(), leads_here)) return edge.from;
    }
    return edges_[0].from;
  }

  int leading_from(int neighbor) const {
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (edges_[i].from == neighbor) return static_cast<int>(i);
    return -1;
  }

  int vertex_ = -1;
  std::vector<int> faces_, loop_;
  std::vector<LinkEdge> edges_;  // not yet walked
};

/// oriented: whether the faces around the vertex are oriented alike.
inline VertexClass class_of(VertexKind kind, bool oriented, int sharp_edges) {
  if (kind > VertexKind::Boundary || !oriented) return VertexClass::Complex;
  const bool inside = kind == VertexKind::Interior;
  if (sharp_edges == 0) return inside ? VertexClass::Simple : VertexClass::Boundary;
  return inside && sharp_edges == 2 ? VertexClass::InteriorEdge : VertexClass::Corner;
}

}  // namespace curvdecim::detail
