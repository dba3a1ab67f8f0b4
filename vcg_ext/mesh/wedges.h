// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/renumbering.h"
#include "vcg_ext/mesh/triangle_connectivity.h"

namespace curvdecim::detail {

/// The corners at a vertex that carry the same are one wedge @cite hoppe1999. Where the two faces
/// at an edge have different wedges, what they carry jumps.
class Wedges {
 public:
  static constexpr int none = -1;

  /// The corners at a vertex are not told apart.
  Wedges() = default;

  /// of_face: by face, the wedges of its corners, all below `count`. Vertex v has wedge v, and
  /// maybe others.
  Wedges(std::vector<Face> of_face, int count) : of_face_(std::move(of_face)), first_(count) {}

  bool exist() const { return !of_face_.empty(); }

  /// Those that there were and that were made.
  int count() const { return first_ + static_cast<int>(source_.size()); }

  const Face& of_face(int f) const { return of_face_[f]; }

  /// Those of the faces, which are left without any; reset() has to follow.
  std::vector<Face> release() { return std::exchange(of_face_, {}); }
  void reset(std::vector<Face> of_face) { of_face_ = std::move(of_face); }

  int at(const TriangleConnectivity& connectivity, int f, int v) const {
    return of_face_[f][connectivity.corner(f, v)];
  }

  /// True if two faces have different wedges at an end of their edge.
  bool differ(const TriangleConnectivity& connectivity, int f, int g, int a, int b) const {
    return at(connectivity, f, a) != at(connectivity, g, a) ||
           at(connectivity, f, b) != at(connectivity, g, b);
  }

  void set(const TriangleConnectivity& connectivity, int f, int v, int wedge) {
    of_face_[f][connectivity.corner(f, v)] = wedge;
  }
  void set_face(int f, const Face& wedges) { of_face_[f] = wedges; }

  /// Each corner of a new face is as in another face of its vertex.
  void add(const TriangleConnectivity& connectivity, int f) {
    for (int v : connectivity.face(f))
      for (int g : connectivity.faces_of(v))
        if (g != f) set(connectivity, f, v, at(connectivity, g, v));
  }

  /// Before TriangleConnectivity::flip of an edge at which they do not differ.
  void flip(const TriangleConnectivity& connectivity, int f, int g, int a, int b) {
    const int at_c = at(connectivity, f, connectivity.third_vertex(f, a, b));
    const int at_d = at(connectivity, g, connectivity.third_vertex(g, a, b));
    set(connectivity, f, b, at_d);
    set(connectivity, g, a, at_c);
  }

  /// A new wedge, and the one that its corners had.
  struct Parted {
    int now, source;
  };

  /// The faces around v have it from a vertex that had their wedges: v gets new ones.
  std::vector<Parted> part(const TriangleConnectivity& connectivity, int v) {
    std::vector<Parted> parted;
    for (int f : connectivity.faces_of(v)) {
      const int was = at(connectivity, f, v);
      auto known = std::find_if(parted.begin(), parted.end(),
                                [&](const Parted& each) { return each.source == was; });
      if (known == parted.end()) {
        known = parted.insert(parted.end(), {count(), was});
        source_.push_back(was);
      }
      set(connectivity, f, v, known->now);
    }
    return parted;
  }

  /// By wedge beyond the first ones: the one that it was parted from.
  const std::vector<int>& sources() const { return source_; }

  void renumber(const Renumbering& numbers) { numbers.faces(of_face_); }

 private:
  std::vector<Face> of_face_;
  int first_ = 0;            // wedges at the start
  std::vector<int> source_;  // of those that were made
};

}  // namespace curvdecim::detail
