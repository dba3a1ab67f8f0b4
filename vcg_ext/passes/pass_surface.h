// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "vcg_ext/geometry/small_quadric.h"
#include "vcg_ext/geometry/triangle.h"
#include "vcg_ext/mesh/merge_record.h"
#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/metric/pass_weight.h"
#include "vcg_ext/parallel/pieces.h"

namespace curvdecim::detail {

/// Keeps of an array the elements with these numbers, ascending, in the memory that it has: each
/// piece closes its own gaps, and then they close up. An empty array stays empty.
template <class T>
void keep_only(const std::vector<int>& left, const Parallel& parallel, std::vector<T>& array) {
  if (array.empty() || left.empty()) return array.clear();
  const int count = static_cast<int>(left.size()), pieces = pieces_of(count, parallel);
  std::vector<std::array<int, 2>> bounds(pieces);  // in `left`
  for_pieces(count, pieces, parallel, [&](int piece, int begin, int end) {
    bounds[piece] = {begin, end};
    for (int i = begin; i < end; ++i) array[left[begin] + (i - begin)] = array[left[i]];
  });
  for (const auto& [begin, end] : bounds) {
    const auto first = array.begin() + left[begin];
    std::copy(first, first + (end - begin), array.begin() + begin);
  }
  array.resize(left.size());
}

/// What passes work on: flat arrays without adjacency. Elements keep their order.
struct PassSurface {
  std::vector<Vector3> position;     // by vertex
  std::vector<SmallQuadric> memory;  // by vertex: what it remembers of the input's planes
  std::vector<PassWeight> weight;    // by vertex
  std::vector<float> importance;     // by vertex: factor on the cost; empty: 1 everywhere
  std::vector<std::uint8_t> held;    // by vertex: 1 if no pass may touch it
  std::vector<int> vertex_before;    // by vertex: its number before the passes
  MergeRecord merges;                // by these numbers
  std::vector<Face> faces;           // none is degenerate
  std::vector<Face> wedges;          // by face: of the corners that are held; empty: not told apart
  std::vector<int> face_origin;      // by face: as a WorkingMesh has it
  std::vector<Vector2> texture;      // by carrier; empty: there is none
  std::vector<Vector3> color;        // by carrier; empty: they do not count
  double texture_weight = 0.0, color_weight = 0.0;  // guard/attribute_guard.h

  /// Times the length of a double area vector and the factors of a face's three corners: the weight
  /// of its plane.
  static constexpr float half_a_third = 0.5f / 3.0f;

  int vertex_count() const { return static_cast<int>(position.size()); }
  int face_count() const { return static_cast<int>(faces.size()); }
  Triangle triangle(int f) const { return triangle_of(position, faces[f]); }

  /// False where so many are held that they would have had their turn by now.
  bool is_mostly_free() const {
    constexpr double most_held = 0.15;  // of the vertices
    const auto count = std::count(held.begin(), held.end(), std::uint8_t{1});
    return static_cast<double>(count) <= most_held * static_cast<double>(held.size());
  }

  /// What a corner of face f at v is called in steps: the wedge, or the vertex before the passes. A
  /// vertex that is not held has one wedge, of the same number.
  int carrier(int f, int v) const {
    if (wedges.empty() || held[v] == 0) return vertex_before[v];
    const Face& face = faces[f];
    return wedges[f][face[0] == v ? 0 : face[1] == v ? 1 : 2];
  }

  bool weighs_attributes() const { return !texture.empty() || !color.empty(); }

  /// On the cost of the edge ab.
  float importance_of(int a, int b) const {
    return importance.empty() ? 1.0f : importance[a] + importance[b];
  }
  double weight_of(int a, int b) const {
    return 0.5 * (weight[a].factor + weight[b].factor) * importance_of(a, b);
  }

  /// into: by vertex, the one that it has become, or itself. Faces that have become degenerate go,
  /// and so do vertices that are others now.
  void close_gaps(const std::vector<int>& into, const Parallel& parallel) {
    const std::vector<int> stays =
        indices_where(vertex_count(), parallel, [&](int v) { return into[v] == v; });
    std::vector<int> number(vertex_count());
    const int vertices = static_cast<int>(stays.size());
    parallel.for_each(vertices, [&](int i) { number[stays[i]] = i; });
    parallel.for_each(face_count(), [&](int f) {
      for (int& v : faces[f]) v = number[into[v]];
    });
    const std::vector<int> left =
        indices_where(face_count(), parallel, [&](int f) { return !is_degenerate(faces[f]); });
    keep_only(stays, parallel, position), keep_only(stays, parallel, memory);
    keep_only(stays, parallel, weight), keep_only(stays, parallel, importance);
    keep_only(stays, parallel, held), keep_only(stays, parallel, vertex_before);
    keep_only(left, parallel, faces), keep_only(left, parallel, wedges);
    keep_only(left, parallel, face_origin);
  }
};

}  // namespace curvdecim::detail
