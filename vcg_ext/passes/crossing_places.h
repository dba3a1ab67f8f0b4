// SPDX-License-Identifier: GPL-3.0-or-later
// Where passes have made faces cross.
#pragma once

#include <cstddef>
#include <vector>

#include "vcg_ext/geometry/box_tree.h"
#include "vcg_ext/mesh/crossings.h"
#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/passes/pass_surface.h"

namespace curvdecim::detail {

/// By face of a surface after passes: its number before them. Faces keep their order.
inline std::vector<int> numbers_before(const PassSurface& start, const PassSurface& surface) {
  std::vector<int> before(surface.face_origin.size());
  int f = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    while (start.face_origin[f] != surface.face_origin[i]) ++f;
    before[i] = f;
  }
  return before;
}

/// Boxes around the pairs of faces that cross now, and did not at the start of the passes.
inline std::vector<Box> crossing_places(const PassSurface& start, const PassSurface& surface,
                                        const Parallel& parallel) {
  const std::vector<FacePair> pairs = crossing_pairs(surface, surface.face_count(), parallel);
  if (pairs.empty()) return {};
  const std::vector<int> before = numbers_before(start, surface);
  std::vector<Box> places;
  for (const auto& [f, g] : pairs) {
    if (faces_cross(before[f], start.triangle(before[f]), before[g], start.triangle(before[g])))
      continue;
    places.push_back(box_around(surface.triangle(f)));
    places.back().add(box_around(surface.triangle(g)));
  }
  return places;
}

/// Holds what the surface has in these places, and somewhat around them. places: at least one.
inline void hold_in(const std::vector<Box>& places, PassSurface& surface,
                    const Parallel& parallel) {
  constexpr double margin = 0.5;  // of a box: as much as the next faces may reach
  BoxTree tree(static_cast<int>(places.size()));
  tree.fit([&](int count, auto work) { parallel.for_each(count, work); },
           [&](int i) {
             const Vector3 around = margin * (places[i].high - places[i].low);
             return Box{places[i].low - around, places[i].high + around};
           });
  parallel.for_each(surface.vertex_count(), [&](int v) {
    const Box here{surface.position[v], surface.position[v]};
    if (tree.any_meeting(here, [](int) { return true; })) surface.held[v] = 1;
  });
}

}  // namespace curvdecim::detail
