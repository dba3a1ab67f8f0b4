// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "vcg_ext/geometry/vector3.h"
#include "vcg_ext/removal/feature_edges.h"
#include "vcg_ext/removal/vertex_fan.h"

namespace curvdecim::detail {

/// The distance, or 0 where it is below what float coordinates can tell at this squared length.
inline double significant(double distance, double length2) {
  constexpr double rounding = 1e-7;  // of the length
  return distance * distance <= rounding * rounding * length2 ? 0.0 : distance;
}

/// The loop around a vertex that is to go, or the part of it on one side of a line through the
/// vertex.
struct LoopPart {
  std::vector<int> corners;  // neighbours of the vertex, in the order of the faces
  std::vector<int> faces;    // face i lies between the corners i and i + 1
  bool closed = false;       // if not, a new edge joins the ends
  Vector3 apex;              // the vertex; of an open part, slid onto the new edge

  /// Cuts a part out of the fan, from its face `first` on.
  void cut(const VertexFan& fan, int first, int count, const Vector3& at) {
    const int all_faces = static_cast<int>(fan.faces().size());
    const int all_corners = static_cast<int>(fan.loop().size());
    corners.clear(), faces.clear();
    closed = count == all_corners;
    apex = at;
    for (int i = 0; i < count; ++i) faces.push_back(fan.faces()[(first + i) % all_faces]);
    for (int i = 0; i < count + !closed; ++i)
      corners.push_back(fan.loop()[(first + i) % all_corners]);
  }
};

/// A triangle over a part of a loop, by places in the part's corners, ascending.
using LoopTriangle = std::array<int, 3>;

/// By edge of the triangle: the part's face that has it; -1: none.
inline std::array<int, 3> loop_sides(const LoopPart& part, const LoopTriangle& t) {
  const int last = static_cast<int>(part.faces.size()) - 1;
  return {t[1] == t[0] + 1 ? t[0] : -1, t[2] == t[1] + 1 ? t[1] : -1,
          part.closed && t[0] == 0 && t[2] == last ? t[2] : -1};
}

/// The first of them.
inline int loop_side(const LoopPart& part, const LoopTriangle& t) {
  const std::array<int, 3> sides = loop_sides(part, t);
  return sides[0] >= 0 ? sides[0] : std::max(sides[1], sides[2]);
}

/// A face over the loop around a removed vertex. It takes the place of an old one of its part.
struct NewFace {
  int slot;
  Face corners;
  std::array<int, 3> source;  ///< by corner: an old face of the part that has it
  EdgeMarks marks;
};

/// The places are those of the old faces at a triangle's side, if it has one: each side of a loop
/// belongs to one triangle. The others, inside, take what is left. mark_of_side(face): of the side
/// that an old face has of the loop; closing: of the new edge between the ends of an open part.
template <class MarkOfSide>
void append_faces(const LoopPart& part, const std::vector<LoopTriangle>& triangles,
                  MarkOfSide mark_of_side, EdgeMark closing, std::vector<NewFace>& faces) {
  const int last = static_cast<int>(part.faces.size()) - 1;
  std::array<bool, VertexFan::longest> taken{};
  for (const LoopTriangle& t : triangles)
    if (const int side = loop_side(part, t); side >= 0) taken[side] = true;
  int free = 0;
  for (const LoopTriangle& t : triangles) {
    int place = loop_side(part, t);
    if (place < 0) {
      while (taken[free]) ++free;
      place = free++;
    }
    NewFace face{part.faces[place], {}, {}, {}};
    const std::array<int, 3> sides = loop_sides(part, t);
    for (int i = 0; i < 3; ++i) {
      face.corners[i] = part.corners[t[i]];
      face.source[i] = part.faces[std::min(t[i], last)];
      if (sides[i] >= 0) face.marks[i] = mark_of_side(part.faces[sides[i]]);
    }
    if (!part.closed && t[0] == 0 && t[2] == last + 1) face.marks[2] = closing;
    faces.push_back(face);
  }
}

}  // namespace curvdecim::detail
