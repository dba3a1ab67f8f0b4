// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// Whether an edge is part of a line on the mesh; the stronger, the later.
enum class EdgeMark : std::uint8_t {
  None,
  Feature,  ///< of one that guides
  Held,     ///< of one that nothing may leave, and whose corners stay
};

/// By edge of a face, from its first, second and third corner.
using EdgeMarks = std::array<EdgeMark, 3>;

/// The lines on a mesh. They are those of the input: where a vertex on a line goes, its two
/// neighbours on the line are joined, and no line appears elsewhere.
class FeatureEdges {
 public:
  /// mark(f, g, a, b): of the edge ab between the faces f and g.
  template <class Mark>
  FeatureEdges(const TriangleConnectivity& connectivity, const Parallel& parallel, Mark mark)
      : connectivity_(connectivity), marks_(connectivity.face_slots()) {
    parallel.for_each(connectivity.face_slots(), [&](int f) {
      const Face& face = connectivity.face(f);
      for (int i = 0; i < 3; ++i) {
        const int a = face[i], b = face[(i + 1) % 3], g = connectivity.face_across(f, a, b);
        marks_[f][i] = g >= 0 ? mark(f, g, a, b) : EdgeMark::None;
      }
    });
  }

  /// Edges of v with this mark or a stronger one; each counts in the face that it leads into.
  int edges_at(int v, EdgeMark least = EdgeMark::Feature) const {
    int edges = 0;
    for (int f : connectivity_.faces_of(v)) edges += mark_from(f, v) >= least;
    return edges;
  }

  /// The other ends of the marked edges of v, which are two.
  std::array<int, 2> ends_at(int v) const {
    std::array<int, 2> ends{};
    int found = 0;
    for (int f : connectivity_.faces_of(v))
      if (mark_from(f, v) != EdgeMark::None) ends[found++] = connectivity_.next_vertex(f, v);
    return ends;
  }

  /// The mark of the edge of f that v is not on.
  EdgeMark mark_across(int f, int v) const {
    return marks_[f][(connectivity_.corner(f, v) + 1) % 3];
  }

  void set(int f, const EdgeMarks& marks) { marks_[f] = marks; }

 private:
  EdgeMark mark_from(int f, int v) const { return marks_[f][connectivity_.corner(f, v)]; }

  const TriangleConnectivity& connectivity_;
  std::vector<EdgeMarks> marks_;  // by face
};

}  // namespace curvdecim::detail
