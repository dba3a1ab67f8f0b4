// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the faces of a surface that cross each other.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/triangles_cross.h"
#include "vcg_ext/mesh/face_boxes.h"

namespace curvdecim::detail {

using FacePair = std::array<int, 2>;  ///< the lower number first

/// A face with its corners and its plane, to be compared with many others.
struct PlacedFace {
  int face;
  Triangle triangle;
  OrientedPlane plane;

  PlacedFace(int its_face, const Triangle& its_triangle)
      : face(its_face), triangle(its_triangle), plane(plane_through(its_triangle)) {}

  /// Asked in one order, since where they touch the order may decide.
  bool crosses(const PlacedFace& o) const {
    if (o.face < face) return o.crosses(*this);
    return triangles_cross(triangle, plane, o.triangle, o.plane) &&
           box_around(triangle).meets(box_around(o.triangle));
  }
};

/// Whether faces f and g, with these corners, cross.
inline bool faces_cross(int f, const Triangle& of_f, int g, const Triangle& of_g) {
  return PlacedFace(f, of_f).crosses(PlacedFace(g, of_g));
}

/// To find what crosses a face: most of what lies near it is not even looked at.
template <class Surface>
using SingleBoxes = FaceBoxes<Surface, 1>;

/// All pairs of faces that cross, in ascending order. cross(f, corners of f, g, corners of g): of
/// faces f < g whose boxes may meet.
template <class Surface, class Cross>
std::vector<FacePair> crossing_pairs(const SingleBoxes<Surface>& boxes, Cross cross,
                                     const Parallel& parallel) {
  constexpr int shares = 4096;  // of the work, about
  const auto nodes = boxes.tree().meeting_pairs(shares);
  std::vector<std::vector<FacePair>> of_worker(parallel.threads());
  const auto test = [&](int leaf, int other, std::vector<FacePair>& pairs) {
    const auto [f, g] = std::minmax(*boxes.faces_of(leaf).begin(), *boxes.faces_of(other).begin());
    if (cross(f, boxes.surface().triangle(f), g, boxes.surface().triangle(g)))
      pairs.push_back({f, g});
  };
  const auto do_range = [&](int begin, int end, int worker) {
    for (int i = begin; i < end; ++i)
      boxes.tree().for_each_meeting(
          nodes[i], [&](int leaf, int other) { test(leaf, other, of_worker[worker]); });
  };
  parallel.for_ranges(static_cast<int>(nodes.size()), do_range, Parallel::heavy);
  std::vector<FacePair> all;
  for (const std::vector<FacePair>& pairs : of_worker)
    all.insert(all.end(), pairs.begin(), pairs.end());
  std::sort(all.begin(), all.end());
  return all;
}

template <class Surface>
std::vector<FacePair> crossing_pairs(const SingleBoxes<Surface>& boxes, const Parallel& parallel) {
  return crossing_pairs(boxes, faces_cross, parallel);
}

/// The same of a surface with `faces` faces, of which there may be none.
template <class Surface>
std::vector<FacePair> crossing_pairs(const Surface& surface, int faces, const Parallel& parallel) {
  if (faces == 0) return {};
  return crossing_pairs(SingleBoxes<Surface>(surface, faces, parallel), parallel);
}

/// The faces of these pairs, ascending.
inline std::vector<int> faces_of(const std::vector<FacePair>& pairs) {
  std::vector<int> faces;
  for (const auto& [f, g] : pairs) faces.push_back(f), faces.push_back(g);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace curvdecim::detail
