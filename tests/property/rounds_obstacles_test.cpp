// SPDX-License-Identifier: GPL-3.0-or-later
// Large meshes on which edges are refused or few lie apart from each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

// --- hubs ---------------------------------------------------------------------------------------

void expect_sound(const Shape& before, const EdgeCollapseParams& params) {
  const Shape after = decimated(before, params).shape;
  EXPECT_PRED2(keeps_topology, topology(before), topology(after));
  EXPECT_TRUE(all_finite(after));
  EXPECT_LT(after.face_count(), before.face_count());
}

TEST(Hub, OfThousandsOfFacesIsDecimated) {
  for (const Shape& shape : {fan(10000), double_cone(10000)})
    expect_sound(shape, to_faces(shape.face_count() / 2));
}

TEST(Hub, BesideALargeMeshIsDecimated) {
  const Shape both = side_by_side({double_cone(2000), translated(torus(96, 48), {3, 0, 0})});
  for (int target : {9000, 2000}) expect_sound(both, to_faces(target));
}

/// An edge with a price came up while its hub rested, was queued with its price again, and so on.
TEST(Hub, WithPricedEdgesIsNotAskedAboutForever) {
  constexpr int patience = 1000;  // calls; a run that ends makes about ten
  const Shape before = capped_cylinder(800, 1);
  for (Scheduler scheduler : {Scheduler::Lazy, Scheduler::Eager}) {
    EdgeCollapseParams params = to_faces(before.face_count() / 10);
    params.preset = Preset::Custom, params.quadrics = Quadrics::Accumulated;
    params.scheduler = scheduler;
    BareMesh mesh;
    fill(mesh, before);
    int calls = 0;
    const DecimationReport report =
        decimate(mesh, params, [&](int, const char*) { return ++calls < patience; });
    EXPECT_EQ(report.stopped_by, StopReason::Target);
  }
}

/// Each collapse summed the planes of a hub on the border anew, in the square of its faces: that
/// took hours.
TEST(Hub, OnTheBorderIsDecimated) { expect_sound(polygon_fan(20000), to_faces(10000)); }

/// Edges whose cost had fallen were asked about while their hub rested. A question takes the hub's
/// faces, and more where there is a bound.
TEST(Hub, RestsWhereCostsFall) {
  constexpr int sides = 20000, few = 1000;
  EdgeCollapseParams params = to_faces(100);  // the bound ends it
  params.max_error = 0.05;
  const DecimationReport report = decimated(rough_cone(sides), params).report;
  EXPECT_GT(report.rejected[Rejection::HubAtRest], few);
  EXPECT_LT(report.rejected[Rejection::NormalFlip], few);
}

/// Neighbours of one hub that were refused ask again in every round. Asked on several threads, time
/// decided which of them found the hub at rest.
TEST(Hub, GivesTheSameBitsOnAnyNumberOfThreads) {
  for (const auto& [sides, count] : {std::pair(80, 60), std::pair(300, 16), std::pair(2000, 4)}) {
    const Shape before = rough_cones(sides, count);
    EdgeCollapseParams params = to_faces(before.face_count() / 5);
    params.normal_angle = 30.0, params.threads = 1;
    const Decimated expected = decimated(before, params);
    EXPECT_GT(expected.report.rejected[Rejection::HubAtRest], 0) << sides << " sides";
    for (int threads : {2, 3, 8}) {
      params.threads = threads;
      const Decimated found = decimated(before, params);
      EXPECT_EQ(found.shape, expected.shape) << sides << " sides, " << threads << " threads";
      EXPECT_EQ(found.report.rejected, expected.report.rejected) << sides << ", " << threads;
    }
  }
}

// --- guards -------------------------------------------------------------------------------------

/// Every ring of a long rod may go for nothing: needles along it are what it consists of.
TEST(Needle, AlongARodCostsNothing) {
  Shape rod = capped_cylinder(16, 60);
  for (Point& point : rod.vertices) point[2] *= 1000.0;
  for (Preset preset : {Preset::Fast, Preset::Balanced, Preset::Best}) {
    EdgeCollapseParams params = to_faces(rod.face_count() / 20);
    params.preset = preset;
    const Shape after = decimated(rod, params).shape;
    EXPECT_LE(after.face_count(), rod.face_count() / 20);
    EXPECT_LT(two_sided_distance(rod, after), 1e-6 * diagonal(rod));
  }
}

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

TEST(Rounds, AskTheGuards) {
  const Shape before = thin_cells(48);
  EdgeCollapseParams params = to_faces(before.face_count() - 1000);
  params.feature_angle = 180.0;
  params.preserve_topology = true;
  const auto [after, report] = decimated(before, params);
  EXPECT_PRED2(keeps_topology, topology(before), topology(after));
  EXPECT_GE(after.face_count(), params.target_faces - 1);
  EXPECT_GT(report.rejected[Rejection::LinkCondition], 0);
  EXPECT_EQ(flipped_faces(before, after), 0);
}

/// Without the link condition a collapse may remove more than its two faces.
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
