// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/collapse/vertex_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "support/drawn_meshes.h"
#include "support/plans.h"
#include "support/working_mesh.h"
#include "vcg_ext/collapse/collapse_operator.h"
#include "vcg_ext/collapse/near_points.h"
#include "vcg_ext/metric/quadric_metric.h"

namespace curvdecim::test {

using namespace detail;

namespace {

using Pairs = std::multiset<std::pair<int, int>>;

std::vector<int> all_of(const std::vector<Vector3>& points) {
  std::vector<int> all;
  for (std::size_t i = 0; i < points.size(); ++i) all.push_back(static_cast<int>(i));
  return all;
}

Pairs found(const std::vector<Vector3>& points, const std::vector<int>& which, double distance,
            int threads = 1) {
  Pairs pairs;
  NearPoints(points, which, distance, Parallel(threads)).for_each_pair([&](int a, int b) {
    pairs.insert({std::min(a, b), std::max(a, b)});
  });
  return pairs;
}

Pairs one_by_one(const std::vector<Vector3>& points, const std::vector<int>& which,
                 double distance) {
  Pairs pairs;
  for (int a : which)
    for (int b : which)
      if (a < b && (points[a] - points[b]).norm() < distance) pairs.insert({a, b});
  return pairs;
}

/// In a box of diagonal 1, its corners included; no two alike.
std::vector<Vector3> scattered() {
  std::vector<Vector3> points = {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, {0.5, -0.5, 0.5}};
  for (int i = 1; i < 400; ++i) {
    const auto part = [i](double step) { return std::fmod(i * step, 1.0) - 0.5; };
    points.push_back({part(0.6180339887), part(0.7548776662), part(0.5698402910)});
  }
  return points;
}

TEST(NearPoints, AreAllAndEachPairOnce) {
  const std::vector<Vector3> points = scattered();
  for (double distance : {0.01, 0.08, 0.3, 0.9, 2.0})
    EXPECT_EQ(found(points, all_of(points), distance), one_by_one(points, all_of(points), distance))
        << distance;
}

TEST(NearPoints, LieOnBothSidesOfEveryBorderBetweenCells) {
  std::vector<Vector3> points;  // neighbours are a tenth apart, in all directions
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      for (int k = 0; k < 8; ++k)
        points.push_back(Vector3(i, j, k) / 10.0 - Vector3::Constant(0.35));
  for (double distance : {0.1001, 0.1501, 0.1801})
    EXPECT_EQ(found(points, all_of(points), distance), one_by_one(points, all_of(points), distance))
        << distance;
}

TEST(NearPoints, LeaveOutWhatDoesNotCount) {
  const std::vector<Vector3> points = scattered();
  const std::vector<int> some = {0, 3, 5, 6, 7, 100, 300};
  EXPECT_EQ(found(points, some, 0.9), one_by_one(points, some, 0.9));
}

TEST(NearPoints, AreCloserAndNotAsFar) {
  const std::vector<Vector3> points = {{0, 0, 0}, {0.25, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(found(points, {0, 1, 2}, 0.25), Pairs({{0, 2}}));
  EXPECT_EQ(found(points, {0, 1, 2}, 0.2500001), Pairs({{0, 1}, {0, 2}, {1, 2}}));
}

TEST(NearPoints, TakeADistanceBelowTheFinestCells) {
  const std::vector<Vector3> points = {{-0.5, 0, 0}, {-0.5, 0, 1e-12}, {0.5, 0, 0}, {0.5, 0, 1e-9}};
  EXPECT_EQ(found(points, {0, 1, 2, 3}, 1e-11), Pairs({{0, 1}}));
}

class Partners : public testing::Test {
 protected:
  VertexPairs pairs(double distance) const { return VertexPairs(mesh_, distance, Parallel(1)); }

  static std::vector<int> of(const VertexPairs& pairs, int v) {
    const IndexRange partners = pairs.of(v);
    return {partners.begin(), partners.end()};
  }

  /// Two triangles above each other, 0 1 2 and 3 4 5, a tenth apart.
  WorkingMesh mesh_ = working_mesh(
      {{{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.1}, {0.5, 0, 0.1}, {0, 0.5, 0.1}},
       {{0, 1, 2}, {3, 4, 5}}});
};

TEST_F(Partners, AreCloserThanTheDistance) {
  const VertexPairs near = pairs(0.11);
  for (int v : {0, 1, 2}) EXPECT_EQ(of(near, v), std::vector<int>{v + 3});
  for (int v : {3, 4, 5}) EXPECT_EQ(of(near, v), std::vector<int>{v - 3});
  for (int v = 0; v < 6; ++v) EXPECT_EQ(pairs(0.09).of(v).size(), 0);
}

TEST_F(Partners, HaveNoEdge) {
  const VertexPairs all = pairs(2.0);
  for (int v : {0, 1, 2}) EXPECT_EQ(of(all, v), (std::vector<int>{3, 4, 5}));
}

TEST_F(Partners, AreNotLocked) {
  mesh_.locked[3] = 1;
  const VertexPairs near = pairs(0.11);
  EXPECT_EQ(near.of(0).size(), 0);
  EXPECT_EQ(near.of(3).size(), 0);
  EXPECT_EQ(near.of(1).size(), 1);
}

TEST_F(Partners, FollowTheMergedVertex) {
  VertexPairs near = pairs(0.11);
  near.merge(0, 1);
  EXPECT_EQ(of(near, 0), (std::vector<int>{3, 4}));
  EXPECT_EQ(of(near, 1), std::vector<int>());
  EXPECT_EQ(of(near, 4), std::vector<int>{0});
  EXPECT_TRUE(near.contains(0, 4) && near.contains(4, 0));
  EXPECT_FALSE(near.contains(1, 4) || near.contains(4, 1));
}

TEST_F(Partners, AreNeverThemselvesNorTwice) {
  VertexPairs near = pairs(0.11);
  near.merge(0, 1), near.merge(3, 4);
  EXPECT_EQ(of(near, 0), std::vector<int>{3});
  near.merge(0, 3);
  EXPECT_EQ(of(near, 0), std::vector<int>());
  EXPECT_EQ(of(near, 2), std::vector<int>{5});
}

TEST_F(Partners, AreForgottenOnBothSides) {
  VertexPairs near = pairs(0.11);
  near.forget(0);
  EXPECT_EQ(near.of(0).size() + near.of(3).size(), 0);
  EXPECT_EQ(near.of(1).size(), 1);
}

TEST_F(Partners, AreNoneUntilAskedFor) {
  const VertexPairs none;
  EXPECT_FALSE(none.active());
  EXPECT_EQ(none.of(0).size(), 0);
  EXPECT_FALSE(none.contains(0, 3));
  EXPECT_TRUE(pairs(0.01).active());
}

TEST_F(Partners, TooManyAreRefused) {
  mesh_ = working_mesh(plane_grid(30));
  EXPECT_THROW(pairs(2.0), InputError);
  EXPECT_NO_THROW(pairs(0.05));
}

// --- in the operator -----------------------------------------------------------------------------

/// The vertices that 12 may merge with once 13 went into it; above each vertex v of a grid lies
/// v + 25.
std::vector<int> mates_after_a_collapse(bool locked) {
  WorkingMesh mesh =
      working_mesh(side_by_side({plane_grid(4), translated(plane_grid(4), {0.0, 0.0, 0.05})}));
  mesh.locked[12] = locked;
  const EdgeCollapseParams params;
  QuadricMetric metric = quadric_metric(mesh, params, false);
  metric.initialize(Parallel(1));
  CollapseOperator collapses(mesh, metric, limits_of(params, false),
                             PriceUnit(mesh, CostUnit::AreaTimesSquaredLength), {});
  collapses.add_pairs(VertexPairs(mesh, 0.06, Parallel(1)));
  CollapseOperator<QuadricMetric>::Scratch scratch;
  const Candidate candidate{0.0, mesh.position[12], 0.0};
  collapses.ask({12, 13}, candidate, {}, scratch);
  collapses.collapse(candidate, 0.0, 0, scratch);
  VertexRing ring;
  collapses.gather_mates(12, ring);
  std::vector<int> above;
  for (const RingVertex& mate : ring)
    if (mate.vertex >= 25) above.push_back(mate.vertex);
  return above;
}

TEST(CollapseOperator, LetsTheMergedVertexMergeWithThePartnersOfBoth) {
  EXPECT_EQ(mates_after_a_collapse(false), (std::vector<int>{37, 38}));
}

TEST(CollapseOperator, LetsALockedVertexMergeWithNone) {
  EXPECT_EQ(mates_after_a_collapse(true), std::vector<int>());
}

}  // namespace
}  // namespace curvdecim::test
