// SPDX-License-Identifier: GPL-3.0-or-later
// With prevent_intersections no face crosses another that it did not cross before.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/expectations.h"
#include "support/mesh_group.h"
#include "support/properties.h"
#include "support/rich_mesh.h"
#include "support/soups.h"
#include "vcg_ext/geometry/triangles_cross.h"

namespace curvdecim::test {
namespace {

Shape inside_out(Shape shape) {
  for (Corners& face : shape.faces) std::swap(face[1], face[2]);
  return shape;
}

/// wall: of the radius, which is 1.
Shape hollow_sphere(int subdivisions, double wall = 0.02) {
  const Shape inner = rotated(scaled(icosphere(subdivisions), 1.0 - wall), 0.3, {0.0, 0.0, 1.0});
  return side_by_side({icosphere(subdivisions), inside_out(inner)});
}

/// Two bent plates of width 2 with a gap between them.
Shape bent_plates(double gap) {
  const auto bent = [](const Shape& flat, double lift) {
    return mapped(flat, [lift](const Point& p) {
      return Point(2.0 * p.x(), 2.0 * p.y(), lift + 0.3 * std::sin(9.0 * p.x()) * p.y());
    });
  };
  return side_by_side({bent(plane_grid(30), 0.0), bent(plane_grid(37), gap)});
}

/// In millimetres: two rings of a chain, each in the other one, that hang .3 mm apart.
Shape chain() {
  constexpr double radius = 6.0, thickness = 0.4 * radius, gap = 0.3, quarter = 0.5 * M_PI;
  const Shape ring = scaled(torus(64, 28), radius);
  constexpr double apart = 2.0 * radius - 2.0 * thickness - gap;
  return side_by_side(
      {ring, translated(rotated(ring, quarter, {1.0, 0.0, 0.0}), {apart, 0.0, 0.0})});
}

/// In millimetres: a ball, and a cup around its lower part with a wall of 1 mm, .3 mm apart.
Shape ball_in_socket() {
  constexpr double radius = 8.0, gap = 0.3, wall = 1.0;
  const auto cup = [](double r) {
    Shape sphere = rotated(scaled(icosphere(3), r), 0.3, {0.0, 1.0, 1.0});
    const auto is_above = [&](const Corners& face) {
      return corners_of(sphere, face)[0].z() > 0.5 * r;
    };
    sphere.faces.erase(std::remove_if(sphere.faces.begin(), sphere.faces.end(), is_above),
                       sphere.faces.end());
    return sphere;
  };
  return side_by_side({scaled(icosphere(3), radius), cup(radius + gap), cup(radius + gap + wall)});
}

/// Faces that cross others, by all pairs.
std::set<std::array<int, 2>> crossing(const Shape& shape) {
  std::set<std::array<int, 2>> pairs;
  for (int f = 0; f < shape.face_count(); ++f)
    for (int g = f + 1; g < shape.face_count(); ++g)
      if (detail::triangles_cross(corners_of(shape, shape.faces[f]),
                                  corners_of(shape, shape.faces[g])))
        pairs.insert({f, g});
  return pairs;
}

std::int64_t count_of_faces(const std::set<std::array<int, 2>>& pairs) {
  std::set<int> faces;
  for (const auto& [f, g] : pairs) faces.insert(f), faces.insert(g);
  return static_cast<std::int64_t>(faces.size());
}

EdgeCollapseParams apart(int faces, Preset preset) {
  EdgeCollapseParams params = to_faces(faces);
  params.preset = preset;
  params.prevent_intersections = true;
  return params;
}

constexpr Preset presets[] = {Preset::Fast, Preset::Balanced, Preset::Best};

TEST(PreventIntersections, KeepsShellsApartThatCrossWithoutIt) {
  const Shape shells = hollow_sphere(4);
  const int target = shells.face_count() / 20;
  for (Preset preset : presets) {
    EdgeCollapseParams params = apart(target, preset);
    const Decimated kept = decimated(shells, params);
    EXPECT_EQ(kept.report.stopped_by, StopReason::Target);
    EXPECT_EQ(kept.report.faces, target);
    EXPECT_EQ(kept.report.crossing, 0);
    EXPECT_TRUE(crossing(kept.shape).empty());
    params.prevent_intersections = false;
    EXPECT_FALSE(crossing(decimated(shells, params).shape).empty());
  }
}

TEST(PreventIntersections, KeepsPlatesApart) {
  const Shape plates = bent_plates(0.01);
  ASSERT_TRUE(crossing(plates).empty());
  for (Preset preset : presets) {
    EdgeCollapseParams params = apart(plates.face_count() / 20, preset);
    EXPECT_TRUE(crossing(decimated(plates, params).shape).empty());
    params.prevent_intersections = false;
    EXPECT_FALSE(crossing(decimated(plates, params).shape).empty());
  }
}

/// No face even touches one of another part, so that the gap between them is more than none.
TEST(PreventIntersections, KeepsPartsThatMoveApart) {
  for (const Shape& parts : {chain(), ball_in_socket()}) {
    ASSERT_TRUE(crossing(parts).empty());
    for (Preset preset : presets) {
      EdgeCollapseParams params = apart(parts.face_count() / 40, preset);
      const Decimated kept = decimated(parts, params);
      EXPECT_EQ(kept.report.stopped_by, StopReason::Target);
      EXPECT_TRUE(crossing(kept.shape).empty());
      params.prevent_intersections = false;
      EXPECT_FALSE(crossing(decimated(parts, params).shape).empty());
    }
  }
}

/// The bound is wider than the gap, so that alone it would not keep them apart.
TEST(PreventIntersections, HoldsTogetherWithABound) {
  for (const auto& [shells, preset] :
       {std::pair(hollow_sphere(3), Preset::Balanced), std::pair(hollow_sphere(3), Preset::Best),
        std::pair(hollow_sphere(4), Preset::Fast),
        std::pair(hollow_sphere(4, 0.002), Preset::Fast)}) {
    EdgeCollapseParams params = apart(0, preset);
    params.max_error = 0.03;
    const Decimated kept = decimated(shells, params);
    EXPECT_EQ(kept.report.stopped_by, StopReason::ErrorBound);
    EXPECT_GT(kept.report.max_error, 0.0);
    EXPECT_LE(kept.report.max_error, params.max_error);
    EXPECT_LE(two_sided_distance(shells, kept.shape), params.max_error);
    EXPECT_TRUE(crossing(kept.shape).empty());
    params.prevent_intersections = false;
    EXPECT_FALSE(crossing(decimated(shells, params).shape).empty());
  }
}

/// Where the places of the vertices are rounded at the end.
TEST(PreventIntersections, HoldsInSinglePrecision) {
  for (const Shape& parts : {hollow_sphere(4), chain()})
    EXPECT_TRUE(
        crossing(decimated_float(parts, apart(parts.face_count() / 40, Preset::Balanced)).shape)
            .empty());
}

TEST(PreventIntersections, HoldsForSpheresAndTheirRefinement) {
  const Shape shells = hollow_sphere(3);
  SphereParams params = spheres_to_faces(shells.face_count() / 20);
  params.prevent_intersections = true;
  params.refine_sweeps = 2;
  EXPECT_TRUE(crossing(decimated(shells, AnyParams(params)).shape).empty());
}

/// A large mesh goes in passes first, which are done anew where they have made faces cross.
TEST(PreventIntersections, HoldsAfterPasses) {
  const Shape shells = hollow_sphere(5, 0.01);
  EdgeCollapseParams params = apart(shells.face_count() / 30, Preset::Fast);
  const Decimated kept = decimated(shells, params);
  EXPECT_EQ(kept.report.stopped_by, StopReason::Target);
  EXPECT_TRUE(crossing(kept.shape).empty());
  params.prevent_intersections = false;
  EXPECT_FALSE(crossing(decimated(shells, params).shape).empty());
}

void expect_same_bits_on_any_number_of_threads(const Shape& shape, EdgeCollapseParams params) {
  params.threads = 1;
  const Decimated expected = decimated(shape, params);
  for (int threads : {2, 5}) {
    params.threads = threads;
    const Decimated found = decimated(shape, params);
    EXPECT_EQ(found.shape, expected.shape);
    EXPECT_EQ(found.report.rejected, expected.report.rejected);
  }
}

TEST(PreventIntersections, GivesTheSameBitsOnAnyNumberOfThreads) {
  const Shape shells = hollow_sphere(4);
  for (Preset preset : presets)
    expect_same_bits_on_any_number_of_threads(shells, apart(shells.face_count() / 20, preset));
  EdgeCollapseParams within = apart(0, Preset::Balanced);
  within.max_error = 0.03;
  expect_same_bits_on_any_number_of_threads(hollow_sphere(3), within);
}

/// Pairs of faces that cross, by the numbers of the input's faces, which are their qualities.
std::set<std::array<int, 2>> crossing_by_quality(const RichMesh& mesh) {
  std::vector<int> number;
  for (const RichFace& face : mesh.face)
    if (!face.IsD()) number.push_back(static_cast<int>(face.cQ()));
  std::set<std::array<int, 2>> pairs;
  for (const auto& [f, g] : crossing(shape_of(mesh)))
    pairs.insert({std::min(number[f], number[g]), std::max(number[f], number[g])});
  return pairs;
}

void expect_no_new_pairs(const Shape& shape, EdgeCollapseParams params) {
  RichMesh mesh;
  fill_with_attributes(mesh, shape);
  const std::set<std::array<int, 2>> before = crossing_by_quality(mesh);
  params.preserve_topology = true;  // no face is added, which would have no number
  const DecimationReport report = decimate(mesh, params);
  for (const auto& [f, g] : crossing_by_quality(mesh))
    EXPECT_EQ(before.count({f, g}), 1u) << f << ' ' << g << " of " << report.faces;
}

/// Parts that stick in each other.
TEST(PreventIntersections, AddsNoPairWhereManyCross) {
  const Shape balls =
      side_by_side({icosphere(3), translated(icosphere(3), {0.9, 0.1, 0.0}), torus(40, 20)});
  for (Preset preset : presets) {
    expect_no_new_pairs(balls, apart(balls.face_count() / 10, preset));
    const Decimated kept = decimated(balls, apart(balls.face_count() / 10, preset));
    EXPECT_GT(kept.report.crossing, 0);
    EXPECT_EQ(kept.report.crossing, count_of_faces(crossing(kept.shape)));
  }
}

class CrossingSoups : public testing::TestWithParam<Family> {};

TEST_P(CrossingSoups, GetNoNewPair) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    Dice dice(seed);
    const Shape soup = GetParam().draw(dice);
    EdgeCollapseParams params = apart(dice.below(12), Preset::Custom);
    params.scheduler = dice.any({Scheduler::Rounds, Scheduler::Lazy});
    params.refine_sweeps = dice.any({0, 2});
    params.preserve_normal = dice.coin();
    SCOPED_TRACE(seed);
    expect_no_new_pairs(soup, params);
  }
}

INSTANTIATE_TEST_SUITE_P(Tiny, CrossingSoups, testing::ValuesIn(families()), family_name);

class CrossingMeshes : public testing::TestWithParam<NamedShape> {};

/// Where the topology gives way, too.
TEST_P(CrossingMeshes, HaveNoMoreCrossingFaces) {
  const Shape& shape = GetParam().shape;
  const std::int64_t crossing_before = count_of_faces(crossing(shape));
  for (int part : {3, 10, 1000})
    for (Preset preset : {Preset::Balanced, Preset::Best}) {
      const DecimationReport report =
          decimated(shape, apart(shape.face_count() / part, preset)).report;
      EXPECT_LE(report.crossing, crossing_before);
    }
}

INSTANTIATE_TEST_SUITE_P(Drawn, CrossingMeshes, testing::ValuesIn(all_meshes()), name_of);

TEST(PreventIntersections, IsToldInTheLog) {
  const DecimationReport report = decimated(hollow_sphere(3), apart(100, Preset::Balanced)).report;
  EXPECT_TRUE(is_said(report, "No face crosses or touches another"));
  EXPECT_FALSE(is_said(decimated(hollow_sphere(3), to_faces(100)).report, "touches"));
}

TEST(PreventIntersections, IsTheReasonWhereItStopsARun) {
  const DecimationReport report = decimated(hollow_sphere(3), apart(8, Preset::Balanced)).report;
  EXPECT_EQ(report.crossing, 0);
  EXPECT_GT(report.rejected[Rejection::Crossing], 0);
}

}  // namespace
}  // namespace curvdecim::test
