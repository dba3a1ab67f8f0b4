// SPDX-License-Identifier: GPL-3.0-or-later
// What must not matter for a clustering: the unit of length, the place, the order, the threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/clustering.h"
#include "support/mesh_group.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

/// Coordinates that are multiples of 2^-20, so that moves by whole numbers are exact.
Shape on_lattice(const Shape& shape) {
  return mapped(shape, [](const Point& p) {
    const auto snapped = [](double x) { return std::round(std::ldexp(x, 20)) / (1 << 20); };
    return Point(snapped(p.x()), snapped(p.y()), snapped(p.z()));
  });
}

std::vector<NamedShape> samples() {
  return {{"noisy_sphere", on_lattice(noisy_sphere(4, 0.02))},
          {"bumpy_sphere", on_lattice(bumpy_sphere(4))},
          {"saddle", on_lattice(saddle(24))},
          {"capped_cylinder", on_lattice(capped_cylinder(32, 12))},
          {"three_pages", on_lattice(book(3, 12))}};
}

class ClusteringSimilarity : public testing::TestWithParam<NamedShape> {
 protected:
  const Shape& shape() const { return GetParam().shape; }
  double size() const { return 0.12 * diagonal(shape()); }
};

TEST_P(ClusteringSimilarity, ScalingByAPowerOfTwoScalesTheBits) {
  for (const NamedRepresentative& each : shape_representatives()) {
    const Shape expected = clustered(shape(), each.of(with_cells(size()))).shape;
    for (int exponent : {-60, -7, 1, 60}) {
      const double factor = std::ldexp(1.0, exponent);
      const auto [after, report] =
          clustered(scaled(shape(), factor), each.of(with_cells(factor * size())));
      EXPECT_EQ(after, scaled(expected, factor)) << each.name << " 2^" << exponent;
    }
  }
}

TEST_P(ClusteringSimilarity, ScalingByAPowerOfTwoScalesTheBitsOfASearch) {
  const ClusteringParams params = to_clusters(shape().face_count() / 8);
  const Shape expected = clustered(shape(), params).shape;
  const Shape single = clustered_float(shape(), params).shape;
  for (int exponent : {-60, -7, 1, 60}) {
    const double factor = std::ldexp(1.0, exponent);
    EXPECT_EQ(clustered(scaled(shape(), factor), params).shape, scaled(expected, factor));
    EXPECT_EQ(clustered_float(scaled(shape(), factor), params).shape, scaled(single, factor));
  }
}

TEST_P(ClusteringSimilarity, AMoveMovesTheBits) {
  for (const NamedRepresentative& each : shape_representatives()) {
    const Shape expected = clustered(shape(), each.of(with_cells(size()))).shape;
    for (const Point& step : {Point(3, -5, 7), Point(1024, 77, -4096)}) {
      const Shape after = clustered(translated(shape(), step), each.of(with_cells(size()))).shape;
      ASSERT_EQ(after.faces, expected.faces) << each.name;
      for (int v = 0; v < after.vertex_count(); ++v)
        EXPECT_LE((after.vertices[v] - expected.vertices[v] - step).norm(), 4e-16 * step.norm());
    }
  }
}

TEST_P(ClusteringSimilarity, TheNumbersDoNotMatter) {
  for (const NamedRepresentative& each : shape_representatives()) {
    const Shape expected = clustered(shape(), each.of(with_cells(size()))).shape;
    for (unsigned seed : {1u, 2u, 3u}) {
      const Shape after = clustered(renumbered(shape(), seed), each.of(with_cells(size()))).shape;
      EXPECT_EQ(after.face_count(), expected.face_count());
      EXPECT_EQ(after.vertex_count(), expected.vertex_count());
      EXPECT_NEAR(area(after), area(expected), 1e-9 * area(expected)) << each.name;
    }
  }
}

TEST_P(ClusteringSimilarity, RenumberedASearchMeetsItsTarget) {
  const int target = shape().face_count() / 4;
  for (unsigned seed : {1u, 2u, 3u}) {
    const auto [after, report] = clustered(renumbered(shape(), seed), to_clusters(target));
    EXPECT_TRUE(std::abs(after.face_count() - target) <= 0.02 * target ||
                report.stopped_by == StopReason::NothingLeft);
  }
}

TEST_P(ClusteringSimilarity, SinglePrecisionGivesTheSameFaces) {
  const Shape rounded = mapped(shape(), [](const Point& p) {
    return Point(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
  });
  const Shape expected = clustered(rounded, with_cells(size())).shape;
  const Shape after = clustered_float(rounded, with_cells(size())).shape;
  EXPECT_EQ(after.faces, expected.faces);
}

INSTANTIATE_TEST_SUITE_P(Drawn, ClusteringSimilarity, testing::ValuesIn(samples()), name_of);

TEST(ClusteringThreads, DoNotShowInTheResult) {
  const Shape sphere = noisy_sphere(5, 0.01);  // large enough to be divided
  for (const NamedRepresentative& each : shape_representatives())
    for (ClusteringParams params : {with_cells(0.1), to_clusters(3000)}) {
      params = each.of(params);
      params.threads = 1;
      const Clustered one = clustered(sphere, params);
      for (int threads : {0, 2, 3}) {
        params.threads = threads;
        const Clustered many = clustered(sphere, params);
        EXPECT_EQ(many.shape, one.shape) << each.name << ", " << threads << " threads";
        EXPECT_EQ(many.report.largest_move, one.report.largest_move);
        EXPECT_EQ(many.report.cost_last, one.report.cost_last);
      }
    }
}

TEST(ClusteringHistory, DoesNotMatter) {
  const Shape expected = clustered(bumpy_sphere(3), to_clusters(300)).shape;
  for (const NamedRepresentative& each : shape_representatives())
    clustered(icosphere(2), each.of(with_cells(0.3)));
  EXPECT_EQ(clustered(bumpy_sphere(3), to_clusters(300)).shape, expected);
}

}  // namespace
}  // namespace curvdecim::test
