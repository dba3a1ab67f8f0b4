// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "vcg_ext/guard/cover.h"
#include "vcg_ext/guard/near_faces.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// Parts into which a face is cut where a whole surface is asked about.
inline constexpr int many_parts = 5000;

/// How far the points of each face are from another surface at most; infinite where that is above
/// the limit, or cannot be told. From: triangle(i). near: by face, to collect the faces of the
/// other surface that it is near, or nullptr.
template <class From, class To>
std::vector<double> distances_to_surface(const From& from, int count, const TriangleTree<To>& to,
                                         double limit, std::vector<std::vector<int>>* near,
                                         const Parallel& parallel) {
  constexpr int block = 64;  // faces that find each other's neighbours
  constexpr Grain blocks{1, 1 << 8};
  std::vector<double> distance(count);
  const auto look = [&](int i) {
    Cover cover;
    std::vector<int> used;
    int hint = Cover::none;  // of this block alone: with several nearest faces it decides
    for (int f = i * block; f < std::min(count, (i + 1) * block); ++f) {
      used.clear();
      cover.add(ConvexPolygon(from.triangle(f)));
      NearInTree<To> faces(to, limit, hint, used);
      distance[f] = cover.distance(limit, many_parts, faces).value_or(HUGE_VAL);
      if (!used.empty()) hint = used.front();
      if (near) (*near)[f] = used;
    }
  };
  parallel.for_each((count + block - 1) / block, look, blocks);
  return distance;
}

}  // namespace curvdecim::detail
