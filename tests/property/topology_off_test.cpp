// SPDX-License-Identifier: GPL-3.0-or-later
// A collapse without the link condition may remove more than its two faces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

/// A plane with thin cells between wide ones. On each face of a thin cell stands a vertex of three
/// faces: the edges across the thin cells cost nothing, and their collapse would double faces.
Shape thin_cells(int cells) {
  const double wide = 1.0 / cells, thin = 0.02 * wide;
  const Shape grid = lattice(2 * cells, cells, Seam::Open, Seam::Open, [&](double u, double v) {
    const int column = static_cast<int>(std::lround(2 * cells * u));
    return Point(column / 2 * wide + column % 2 * thin, v, 0.0);
  });
  Shape shape{grid.vertices, {}};
  for (const Corners& face : grid.faces) {
    const auto [a, b, c] = corners_of(grid, face);
    if (std::max({a.x(), b.x(), c.x()}) - std::min({a.x(), b.x(), c.x()}) > 2.0 * thin) {
      shape.faces.push_back(face);
      continue;
    }
    shape.vertices.push_back((a + b + c) / 3.0 + Point(0, 0, 0.5 * wide));
    for (int i = 0; i < 3; ++i)
      shape.faces.push_back({face[i], face[(i + 1) % 3], shape.vertex_count() - 1});
  }
  return shape;
}

TEST(TopologyOff, MeetsTheTargetToo) {
  constexpr int one_collapse = 6;  // two wings, and what may fall onto each other beside them
  const Shape before = thin_cells(48);
  for (Metric metric : {Metric::Quadric, Metric::CurvatureWeighted, Metric::CurvatureAdditive}) {
    EdgeCollapseParams params = to_faces(before.face_count() - 1000);
    params.feature_angle = 180.0, params.preserve_topology = params.preserve_boundary = false;
    params.boundary_weight = 0.0, params.metric = metric;
    EXPECT_GT(decimated(before, params).shape.face_count(), params.target_faces - one_collapse);
  }
}

}  // namespace
}  // namespace curvdecim::test
