// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// What the faces around a vertex form, in the order in which one kind gives way to the next.
/// Creases are not a kind: constraint quadrics hold them.
enum class VertexKind : std::uint8_t {
  Interior,  ///< a disk
  Boundary,  ///< half a disk
  Curve,     ///< three or more sheets that meet in a curve through the vertex: a non-manifold edge
  Junction,  ///< anything else: ends and crossings of curves, disks that touch in a point
};

/// Where the kinds of an edge's two ends let the merged vertex lie.
enum class Allowed { Anywhere, OntoA, OntoB };

/// Tells the kinds by the link: the graph with the neighbours as nodes and a face as an edge
/// between its two other vertices. Orientation plays no part. Holds the scratch arrays.
class VertexClassifier {
 public:
  explicit VertexClassifier(const TriangleConnectivity& connectivity)
      : connectivity_(connectivity) {}

  VertexKind classify(int v) {
    if (const auto kind = kind_of_simple_link(v)) return *kind;
    degree_.resize(connectivity_.vertex_slots(), 0), others_.resize(degree_.size(), 0);
    build_link(v);
    const VertexKind kind = kind_of_link(v);
    for (int f : connectivity_.faces_of(v))
      for (int u : connectivity_.face(f)) degree_[u] = others_[u] = 0;
    return kind;
  }

 private:
  /// The kind of a vertex of a manifold, without the scratch arrays: walks along the link by edges.
  /// nullopt: the link is long, or is not one cycle or one path.
  std::optional<VertexKind> kind_of_simple_link(int v) const {
    constexpr int longest = 16;  // the walk looks at each edge of the link in each step
    const auto faces = connectivity_.faces_of(v);
    if (faces.size() == 0 || faces.size() > longest) return std::nullopt;
    std::array<std::array<int, 2>, longest> link;
    int left = 0;
    for (int f : faces) link[left++] = link_edge(f, v);
    const auto [start, second] = link[--left];
    const std::optional<int> end = walk_off(second, start, link.data(), left);
    if (!end) return std::nullopt;
    if (*end == start) return left == 0 ? std::optional(VertexKind::Interior) : std::nullopt;
    const std::optional<int> other_end = walk_off(start, *end, link.data(), left);
    return other_end && left == 0 ? std::optional(VertexKind::Boundary) : std::nullopt;
  }

  /// Takes from the `left` edges those that lead on from `at`, to `home` at the furthest; where
  /// they end. nullopt: somewhere two lead on.
  static std::optional<int> walk_off(int at, int home, std::array<int, 2>* link, int& left) {
    for (;;) {
      if (at == home) return at;
      int next = -1;
      for (int i = 0; i < left; ++i) {
        if (link[i][0] != at && link[i][1] != at) continue;
        if (next >= 0) return std::nullopt;
        next = i;
      }
      if (next < 0) return at;
      at = link[next][0] ^ link[next][1] ^ at;
      link[next] = link[--left];
    }
  }

  void build_link(int v) {
    for (int f : connectivity_.faces_of(v)) {
      const auto [a, b] = link_edge(f, v);
      ++degree_[a], ++degree_[b];
      others_[a] ^= b, others_[b] ^= a;
    }
  }

  std::array<int, 2> link_edge(int f, int v) const {
    const Face& face = connectivity_.face(f);
    const int i = connectivity_.corner(f, v);
    return {face[(i + 1) % 3], face[(i + 2) % 3]};
  }

  VertexKind kind_of_link(int v) const {
    const auto faces = connectivity_.faces_of(v);
    if (faces.size() == 0) return VertexKind::Interior;
    int ends = 0, branches = 0, start = link_edge(*faces.begin(), v)[0];
    for (int f : faces)
      for (int u : link_edge(f, v)) {
        if (degree_[u] == 2) continue;
        ++(degree_[u] == 1 ? ends : branches);
        start = u;
      }
    if (branches > 0)
      return ends == 0 && branches == 2 * degree_[start] && is_theta(v, start)
                 ? VertexKind::Curve
                 : VertexKind::Junction;
    if (ends > 2 || walk_all(v, start) != faces.size()) return VertexKind::Junction;
    return ends == 0 ? VertexKind::Interior : VertexKind::Boundary;
  }

  /// Link edges met from `start` along its first link edge.
  int walk_all(int v, int start) const {
    for (int f : connectivity_.faces_of(v)) {
      const auto [a, b] = link_edge(f, v);
      if (a == start || b == start) return walk(start, a == start ? b : a).length;
    }
    return 0;
  }

  struct Walk {
    int end, length;
  };

  /// Through nodes of degree 2 until another node or the start is reached.
  Walk walk(int start, int next) const {
    int from = start, at = next, length = 1;
    while (degree_[at] == 2 && at != start) {
      const int to = others_[at] ^ from;
      from = at;
      at = to;
      ++length;
    }
    return {at, length};
  }

  /// True if every path from one branch ends at the same other branch and together they are all.
  bool is_theta(int v, int branch) const {
    int length = 0, end = -1;
    for (int f : connectivity_.faces_of(v)) {
      const auto [a, b] = link_edge(f, v);
      if (a != branch && b != branch) continue;
      const Walk path = walk(branch, a == branch ? b : a);
      if (path.end == branch || (end >= 0 && path.end != end)) return false;
      end = path.end;
      length += path.length;
    }
    return length == connectivity_.faces_of(v).size() && degree_[end] == degree_[branch];
  }

  const TriangleConnectivity& connectivity_;
  std::vector<int> degree_;  // in the link, by neighbour; empty until it is needed
  std::vector<int> others_;  // exclusive or of the adjacent nodes: at degree 2, one gives the other
};

inline std::vector<VertexKind> classify_vertices(const TriangleConnectivity& connectivity,
                                                 const Parallel& parallel) {
  std::vector<VertexKind> kinds(connectivity.vertex_slots());
  std::vector<VertexClassifier> classifiers(parallel.threads(), VertexClassifier(connectivity));
  parallel.for_ranges(connectivity.vertex_slots(), [&](int begin, int end, int worker) {
    for (int v = begin; v < end; ++v) kinds[v] = classifiers[worker].classify(v);
  });
  return kinds;
}

}  // namespace curvdecim::detail
