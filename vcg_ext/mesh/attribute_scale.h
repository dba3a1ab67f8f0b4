// SPDX-License-Identifier: GPL-3.0-or-later
// The units in which what corners carry is compared with lengths on the surface.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// Area of the mesh over the sum of measure(f) >= 0 of its faces; 0 where that is none. No face is
/// dead. The blocks that are summed up do not depend on the number of threads.
template <class Measure>
double area_over(const WorkingMesh& mesh, const Parallel& parallel, Measure measure) {
  constexpr int block = 1 << 12;
  const int faces = mesh.connectivity.face_slots(), blocks = (faces + block - 1) / block;
  std::vector<Vector2> sums(blocks, Vector2::Zero());  // of areas, of the measure
  parallel.for_each(
      blocks,
      [&](int b) {
        for (int f = b * block; f < std::min(faces, (b + 1) * block); ++f)
          sums[b] += Vector2(mesh.plane[f].area, measure(f));
      },
      Parallel::heavy);
  Vector2 sum = Vector2::Zero();
  for (const Vector2& each : sums) sum += each;
  return sum.y() > 0.0 ? sum.x() / sum.y() : 0.0;
}

/// Squared: lengths on the surface over those in its texture.
inline double texture_scale2(const WorkingMesh& mesh, const Parallel& parallel) {
  if (mesh.texture.empty()) return 0.0;
  return area_over(mesh, parallel,
                   [&](int f) { return 0.5 * std::abs(texture_area(mesh.texture_triangle(f))); });
}

/// Squared: the length in which colours change by 1, by the mean square of their gradient, times
/// what a colour counts against a place in a texture: an eye sees an image that is out of place
/// sooner than colours that are too even (docs/decisions/colours.md).
inline double color_scale2(const WorkingMesh& mesh, const Parallel& parallel) {
  constexpr double share = 0.3;
  if (mesh.color.empty()) return 0.0;
  return share * area_over(mesh, parallel, [&](int f) {
           return squared_gradient(mesh.triangle(f), mesh.color_triangle(f));
         });
}

}  // namespace curvdecim::detail
