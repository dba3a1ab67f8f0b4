// SPDX-License-Identifier: GPL-3.0-or-later
// Random meshes, bounds and settings try to break the promise of MaxError.
#include <gtest/gtest.h>

#include <random>

#include "support/clustering.h"
#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/removal.h"

namespace curvdecim::test {
namespace {

using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

Shape drawn(Random& random) {
  switch (random() % 8) {
    case 0: return noisy_sphere(2, uniform(random, 0.0, 0.2));
    case 1: return torus(8 + random() % 20, 4 + random() % 10);
    case 2: return saddle(6 + random() % 10);
    case 3: return open_cylinder(6 + random() % 20, 2 + random() % 6);
    case 4: return dense_box(2 + random() % 4, {1.0, uniform(random, 0.05, 1.0), 0.3});
    case 5: return book(3, 2 + random() % 6);
    case 6: return annulus(8 + random() % 20, 2 + random() % 3);
    default: return grid_with_small_holes(8 + random() % 5);
  }
}

/// Some vertices go astray, so that faces fold and cross.
Shape disturbed(Shape shape, Random& random) {
  const double size = diagonal(shape) * uniform(random, 0.0, 0.05);
  for (Point& p : shape.vertices)
    if (random() % 4 == 0)
      for (int k = 0; k < 3; ++k) p[k] += uniform(random, -size, size);
  return shape;
}

void expect_within(const DecimationReport& report, const DecimationParams& params,
                   const Shape& before, const Shape& after) {
  const double measured =
      std::max(sampled_distance(before, after), two_sided_distance(before, after));
  EXPECT_LE(measured, params.max_error * (1.0 + 1e-9));
  EXPECT_LE(measured, report.max_error * (1.0 + 1e-9) + 1e-14);
}

TEST(ErrorBound, IsNotBrokenByRandomMeshes) {
  constexpr int runs = 400;
  for (int seed = 0; seed < runs; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Shape before = disturbed(drawn(random), random);
    EdgeCollapseParams params;
    params.max_error = diagonal(before) * std::pow(10.0, uniform(random, -3.3, -1.3));
    params.preset = static_cast<Preset>(random() % 3);
    params.preserve_normal = random() % 4 != 0;
    params.preserve_boundary = random() % 3 != 0;
    params.preserve_topology = random() % 3 != 0;
    const auto [after, report] = decimated(before, params);
    expect_within(report, params, before, after);
  }
}

TEST(ErrorBound, OfVertexRemovalIsNotBrokenByRandomMeshes) {
  constexpr int runs = 400;
  for (int seed = 0; seed < runs; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Shape before = disturbed(drawn(random), random);
    VertexRemovalParams params;
    params.target_faces = 0;
    params.max_error = diagonal(before) * std::pow(10.0, uniform(random, -3.3, -1.3));
    params.criterion = static_cast<RemovalCriterion>(random() % 2);
    params.preserve_normal = random() % 4 != 0;
    params.preserve_boundary = random() % 3 != 0;
    const auto [after, report] = thinned(before, params);
    expect_within(report, params, before, after);
  }
}

TEST(ErrorBound, OfClusteringIsNotBrokenByRandomMeshes) {
  constexpr int runs = 200;
  int fewer = 0;
  for (int seed = 0; seed < runs; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Shape before = disturbed(drawn(random), random);
    ClusteringParams params;
    params.max_error = diagonal(before) * std::pow(10.0, uniform(random, -2.0, -0.7));
    params.representative = static_cast<Representative>(random() % 5);
    if (random() % 2 == 0) params.cell_size = 2.0 * params.max_error;
    const auto [after, report] = clustered(before, params);
    EXPECT_LE(sampled_distance(before, after), params.max_error * (1.0 + 1e-9));
    EXPECT_LE(sampled_distance(before, after), report.max_error * (1.0 + 1e-9) + 1e-14);
    fewer += after.face_count() < before.face_count();
  }
  EXPECT_GT(fewer, runs / 4);
}

TEST(ErrorBound, OnOneSideIsNotBrokenByRandomMeshes) {
  constexpr int runs = 200;
  int fewer = 0;
  for (int seed = 0; seed < runs; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Shape before = disturbed(drawn(random), random);
    EdgeCollapseParams params;
    params.max_error = diagonal(before) * std::pow(10.0, uniform(random, -3.3, -1.3));
    params.preserve_boundary = false;
    const int two_sided = decimated(before, params).report.faces;
    params.max_error_one_sided = true;
    const auto [after, report] = decimated(before, params);
    EXPECT_LE(one_sided_sampled_distance(after, before), params.max_error * (1.0 + 1e-9));
    fewer += after.face_count() < two_sided;
  }
  EXPECT_GT(fewer, runs / 4);
}

}  // namespace
}  // namespace curvdecim::test
