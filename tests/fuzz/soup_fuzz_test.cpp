// SPDX-License-Identifier: GPL-3.0-or-later
// Step by step decimation of tiny triangle soups, with random parameters.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/decimation.h"
#include "support/properties.h"
#include "support/removal.h"
#include "support/soups.h"

namespace curvdecim::test {
namespace {

EdgeCollapseParams random_params(Dice& dice) {
  EdgeCollapseParams p;
  p.target_faces = dice.below(12);
  p.preset =
      dice.any({Preset::Custom, Preset::Custom, Preset::Fast, Preset::Balanced, Preset::Best});
  p.metric = dice.any({Metric::Quadric, Metric::CurvatureWeighted, Metric::CurvatureAdditive});
  p.alpha = dice.any({-1.0, 1e-3, 1.0, 1e9});
  p.curvature_floor = dice.any({0.0, 0.5, 1.0});
  p.alpha_units = dice.any({AlphaUnits::ScaleFree, AlphaUnits::ModelUnits});
  p.curvature_kind = dice.any({CurvatureKind::Gaussian, CurvatureKind::Absolute});
  p.curvature_term = dice.any({CurvatureTerm::Melax, CurvatureTerm::Literal});
  p.quadrics = dice.any({Quadrics::Memoryless, Quadrics::Accumulated});
  p.plane_weight = dice.any({PlaneWeight::Area, PlaneWeight::Unit});
  p.placement = dice.any(
      {Placement::Optimal, Placement::Line, Placement::EndpointOrMidpoint, Placement::HalfEdge});
  p.boundary_weight = dice.any({0.0, 1.0, 1e6});
  p.feature_angle = dice.any({0.0, 60.0, 180.0});
  p.normal_angle = dice.any({10.0, 90.0, 180.0});
  p.preserve_normal = dice.coin();
  p.preserve_boundary = dice.coin();
  p.threads = dice.any({1, 2});
  p.refine_sweeps = dice.any({0, 3});
  p.prevent_intersections = dice.coin();
  return p;
}

/// The faces that the input means: neither degenerate in index nor given twice in one orientation.
Shape without_unusable_faces(Shape shape) {
  std::vector<Corners> kept, seen;
  for (const Corners& face : shape.faces) {
    Corners turned = face;
    std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
    if (turned[0] == turned[1] || turned[1] == turned[2] || turned[2] == turned[0] ||
        std::count(seen.begin(), seen.end(), turned))
      continue;
    seen.push_back(turned);
    kept.push_back(face);
  }
  shape.faces = kept;
  return shape;
}

void expect_sound(const Shape& before, const Shape& after) {
  const Topology was = topology(before), is = topology(after);
  EXPECT_TRUE(all_finite(after));
  EXPECT_EQ(is.faces_with_repeated_index, 0);
  EXPECT_EQ(is.duplicate_faces, 0);
  EXPECT_LE(is.unreferenced_vertices, was.unreferenced_vertices);
  EXPECT_LE(after.face_count(), before.face_count());
}

void expect_no_worse_topology(const Shape& before, const Shape& after) {
  const Topology was = topology(before), is = topology(after);
  EXPECT_LE(is.nonmanifold_edges, was.nonmanifold_edges);
  EXPECT_LE(is.nonmanifold_vertices, was.nonmanifold_vertices);
  EXPECT_LE(is.inconsistent_edges, was.inconsistent_edges);
  EXPECT_EQ(is.components, was.components);
  EXPECT_EQ(is.boundary_loops, was.boundary_loops);
  EXPECT_EQ(is.euler, was.euler);
}

class Fuzz : public testing::TestWithParam<Family> {
 protected:
  static constexpr int cases = 2500;

  template <class Check>
  void for_each_case(Check check) {
    for (unsigned seed = 0; seed < cases && !HasFailure(); ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Dice dice(seed);
      const Shape input = GetParam().draw(dice);
      const EdgeCollapseParams params = random_params(dice);
      const Shape usable = without_unusable_faces(input);
      if (!usable.faces.empty()) check(input, usable, params);
    }
  }
};

TEST_P(Fuzz, NeverDamagesTheTopology) {
  for_each_case([](const Shape& input, const Shape& usable, EdgeCollapseParams params) {
    params.preserve_topology = true;
    const auto [after, report] = decimated(input, params);
    if (input.face_count() <= params.target_faces) {
      EXPECT_EQ(after, input);
      return;
    }
    expect_sound(usable, after);
    expect_no_worse_topology(usable, after);
    EXPECT_TRUE(after.face_count() <= params.target_faces ||
                report.stopped_by == StopReason::NothingLeft);
  });
}

TEST_P(Fuzz, AddsNoDefectWhereTheTopologyGivesWay) {
  for_each_case([](const Shape& input, const Shape& usable, const EdgeCollapseParams& params) {
    const Shape after = decimated(input, params).shape;
    if (input.face_count() <= params.target_faces) return;
    expect_sound(usable, after);
    const Topology was = topology(usable), is = topology(after);
    EXPECT_LE(is.nonmanifold_edges, was.nonmanifold_edges);
    EXPECT_LE(is.inconsistent_edges, was.inconsistent_edges);
  });
}

TEST_P(Fuzz, IsSoundWithPairs) {
  for (double distance : {0.5, 1.1, 5.0})  // the grid's unit is 1
    for_each_case([&](const Shape& input, const Shape& usable, EdgeCollapseParams params) {
      params.pair_distance = distance;
      const auto [after, report] = decimated(input, params);
      if (input.face_count() > params.target_faces) expect_sound(usable, after);
      EXPECT_TRUE(distance >= 1.0 || report.pairs_contracted == 0);
    });
}

TEST_P(Fuzz, BySpheresNeverDamagesTheTopology) {
  for (const Variant& variant : sphere_variants())
    for_each_case([&](const Shape& input, const Shape& usable, const EdgeCollapseParams& random) {
      AnyParams params = variant.params;
      shared(params) = random;
      shared(params).preserve_topology = true;
      const Shape after = decimated(input, params).shape;
      if (input.face_count() <= random.target_faces) return;
      expect_sound(usable, after);
      expect_no_worse_topology(usable, after);
    });
}

TEST_P(Fuzz, ByVertexRemovalNeverDamagesTheTopology) {
  for (const RemovalVariant& variant : removal_variants())
    for_each_case([&](const Shape& input, const Shape& usable, const EdgeCollapseParams& random) {
      VertexRemovalParams params = variant.of({});
      static_cast<DecimationParams&>(params) = random;
      const Shape after = thinned(input, params).shape;
      if (input.face_count() <= random.target_faces) return;
      expect_sound(usable, after);
      expect_no_worse_topology(usable, after);
    });
}

INSTANTIATE_TEST_SUITE_P(Random, Fuzz, testing::ValuesIn(families()), family_name);

}  // namespace
}  // namespace curvdecim::test
