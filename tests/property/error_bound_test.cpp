// SPDX-License-Identifier: GPL-3.0-or-later
// MaxError is a promise: no point of either surface is further from the other.
#include <gtest/gtest.h>

#include "support/decimation.h"
#include "support/mesh_group.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

class ErrorBoundOn : public testing::TestWithParam<NamedShape> {};

TEST_P(ErrorBoundOn, IsKeptByEveryVariant) {
  const Shape& before = GetParam().shape;
  for (double fraction : {1e-3, 1e-2})
    for (const Variant& variant : all_variants()) {
      SCOPED_TRACE(variant.name + " within " + std::to_string(fraction));
      const double bound = fraction * diagonal(before);
      const auto [after, report] = decimated(before, variant.with_max_error(bound));
      EXPECT_LE(two_sided_distance(before, after), bound);
      EXPECT_LE(report.max_error, bound);
      EXPECT_NE(report.stopped_by, StopReason::Target);
    }
}

TEST_P(ErrorBoundOn, LeavesFewerFacesWhenItIsWider) {
  const Shape& before = GetParam().shape;
  const auto faces_within = [&](double fraction) {
    EdgeCollapseParams params;
    params.max_error = fraction * diagonal(before);
    return decimated(before, params).shape.face_count();
  };
  EXPECT_LT(faces_within(0.02), faces_within(0.001));
}

INSTANTIATE_TEST_SUITE_P(Drawn, ErrorBoundOn,
                         testing::Values(NamedShape{"icosphere", icosphere(2)},
                                         NamedShape{"noisy_sphere", noisy_sphere(2, 0.02)},
                                         NamedShape{"torus", torus(24, 12)},
                                         NamedShape{"saddle", saddle(12)}),
                         name_of);

// --- all over the surfaces, where only the interior of a face may be far ------------------------

/// The bound, and what a distance on such a shape is rounded by.
double rounded_up(double bound, const Shape& shape) {
  return bound * (1.0 + 1e-9) + 1e-15 * diagonal(shape);
}

/// Promised: nothing between the two surfaces is wider than the bound that is reported.
void expect_promise_kept(const Shape& before, double fraction) {
  EdgeCollapseParams params;
  params.max_error = fraction * diagonal(before);
  for (Metric metric : {Metric::Quadric, Metric::CurvatureWeighted, Metric::CurvatureAdditive})
    for (Preset preset : {Preset::Fast, Preset::Balanced, Preset::Best}) {
      SCOPED_TRACE(static_cast<int>(metric) * 10 + static_cast<int>(preset));
      params.metric = metric, params.preset = preset;
      const auto [after, report] = decimated(before, params);
      EXPECT_LT(after.face_count(), before.face_count());
      EXPECT_LE(sampled_distance(before, after), rounded_up(report.max_error, before));
      EXPECT_LE(report.max_error, params.max_error);
    }
}

class ErrorBoundAllOver : public testing::TestWithParam<NamedShape> {};

TEST_P(ErrorBoundAllOver, IsKept) {
  for (double fraction : {2e-3, 2e-2}) expect_promise_kept(GetParam().shape, fraction);
}

INSTANTIATE_TEST_SUITE_P(Drawn, ErrorBoundAllOver,
                         testing::Values(NamedShape{"bumpy_sphere", bumpy_sphere(3)},
                                         NamedShape{"noisy_sphere", noisy_sphere(2, 0.05)},
                                         NamedShape{"saddle", saddle(16)},
                                         NamedShape{"open_cylinder", open_cylinder(24, 8)},
                                         NamedShape{"annulus", annulus(32, 4)},
                                         NamedShape{"small_holes", grid_with_small_holes(12)},
                                         NamedShape{"moebius_strip", moebius_strip(30, 6)},
                                         NamedShape{"three_pages", book(3, 8)},
                                         NamedShape{"two_components", large_and_small_sphere()}),
                         name_of);

TEST(ErrorBound, IsKeptWithoutTheGuardsToo) {
  for (const Shape& before : {noisy_sphere(2, 0.05), saddle(16), annulus(32, 4)}) {
    EdgeCollapseParams params;
    params.max_error = 0.02 * diagonal(before);
    params.preserve_normal = params.preserve_boundary = params.preserve_topology = false;
    const auto [after, report] = decimated(before, params);
    EXPECT_LE(sampled_distance(before, after), rounded_up(report.max_error, before));
    EXPECT_LE(report.max_error, params.max_error);
  }
}

Shape in_single_precision(Shape shape) {
  for (Point& p : shape.vertices) p = p.cast<float>().cast<double>();
  return shape;
}

/// Far from the origin what is written moves by some per cent of the bound.
TEST(ErrorBound, HasRoomForTheRoundingOfTheResult) {
  const Shape before = in_single_precision(translated(bumpy_sphere(3), {900.0, -700.0, 400.0}));
  for (double fraction : {2e-4, 1e-3, 5e-3}) {
    EdgeCollapseParams params;
    params.max_error = fraction * diagonal(before);
    const auto [after, report] = decimated_float(before, params);
    EXPECT_LT(after.face_count(), before.face_count());
    EXPECT_LE(sampled_distance(before, after), params.max_error * (1.0 + 1e-9));
    EXPECT_LE(sampled_distance(before, after), report.max_error * (1.0 + 1e-9));
    EXPECT_LE(report.max_error, params.max_error * (1.0 + 1e-9));
  }
}

TEST(ErrorBound, AndATargetStopAtWhicheverComesFirst) {
  EdgeCollapseParams params = to_faces(300);
  params.max_error = 1.0;  // never reached
  EXPECT_EQ(decimated(icosphere(2), params).report.stopped_by, StopReason::Target);
  params.target_faces = 4;
  params.max_error = 0.01;
  const auto [after, report] = decimated(icosphere(2), params);
  EXPECT_GT(after.face_count(), 4);
  EXPECT_NE(report.stopped_by, StopReason::Target);
}

TEST(ErrorBound, OfACancelledRunIsNone) {
  BareMesh mesh;
  fill(mesh, noisy_sphere(4, 0.01));
  EdgeCollapseParams params = to_faces(100);
  params.max_error = 0.1;
  const DecimationReport report =
      decimate(mesh, params, [](int percent, const char*) { return percent < 20; });
  EXPECT_EQ(report.stopped_by, StopReason::Cancelled);
  EXPECT_EQ(report.max_error, 0.0);
}

// --- faces without area -------------------------------------------------------------------------

/// Every face cut at the middle of its first edge, with a face without area along that edge.
Shape with_vertices_on_edges(const Shape& shape) {
  Shape cut{shape.vertices, {}};
  for (const auto& [a, b, c] : shape.faces) {
    const int middle = cut.vertex_count();
    Point half;
    for (int k = 0; k < 3; ++k) half[k] = 0.5 * (shape.vertices[a][k] + shape.vertices[b][k]);
    cut.vertices.push_back(half);
    cut.faces.insert(cut.faces.end(), {{a, middle, c}, {middle, b, c}, {a, b, middle}});
  }
  return cut;
}

/// They refused nearly every collapse around them: 6,144 faces of a plane became 5,924.
TEST(ErrorBound, IsNoNarrowerBesideFacesWithoutArea) {
  EdgeCollapseParams params;
  for (const Shape& plain : {plane_grid(8), saddle(12)}) {
    const Shape before = with_vertices_on_edges(plain);
    params.max_error = 0.01 * diagonal(before);
    const auto [after, report] = decimated(before, params);
    EXPECT_LE(after.face_count(), 2 * decimated(plain, params).shape.face_count() + 20);
    EXPECT_LE(two_sided_distance(before, after), rounded_up(report.max_error, before));
  }
}

}  // namespace
}  // namespace curvdecim::test
