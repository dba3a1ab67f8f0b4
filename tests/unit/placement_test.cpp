// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/metric/placement.h"

#include <gtest/gtest.h>

namespace curvdecim::test {

using namespace detail;

namespace {

// An edge along x from -1 to 1 about its midpoint.
const Vector3 half(1, 0, 0);

QuadricOfEdge on_edge(const Quadric& q, const Vector3& half_edge = half) {
  return {q, half_edge.dot(q.a * half_edge)};
}

QuadricOfEdge planes_through(const Vector3& p) {
  Quadric q;
  for (int axis = 0; axis < 3; ++axis) q += Quadric::plane(Vector3::Unit(axis), p[axis], 1.0);
  return on_edge(q);
}

QuadricOfEdge plane_across_at(double x) {
  return on_edge(Quadric::plane(Vector3(1, 0, 0), x, 1.0));
}

TEST(Placement, OptimalIsNearTheMinimum) {
  const Vector3 minimum(0.3, -0.2, 0.1);
  const Placed placed = place(planes_through(minimum), half, Allowed::Anywhere, Placement::Optimal);
  EXPECT_LT((placed.offset - minimum).norm(), 0.01 * minimum.norm());
  EXPECT_NEAR(placed.t, 0.65, 0.01);
}

TEST(Placement, OptimalIsTheMidpointWhereNothingIsAtStake) {
  const Placed placed = place(on_edge({}), half, Allowed::Anywhere, Placement::Optimal);
  EXPECT_EQ(placed.offset, Vector3(0, 0, 0));
  EXPECT_EQ(placed.t, 0.5);
}

TEST(Placement, OptimalMakesNoSpikeBetweenNearlyParallelPlanes) {
  const Quadric q = Quadric::plane(Vector3(0, 1e-6, 1).normalized(), 1e-3, 1.0) +
                    Quadric::plane(Vector3(0, -1e-6, 1).normalized(), -1e-3, 1.0);
  EXPECT_LT(place(on_edge(q), half, Allowed::Anywhere, Placement::Optimal).offset.norm(), 1.0);
}

TEST(Placement, LineFindsTheMinimumOnTheEdge) {
  const Placed placed = place(plane_across_at(0.5), half, Allowed::Anywhere, Placement::Line);
  EXPECT_LT((placed.offset - Vector3(0.5, 0, 0)).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(placed.t, 0.75);
}

TEST(Placement, LineDoesNotLeaveTheEdge) {
  EXPECT_EQ(place(plane_across_at(9.0), half, Allowed::Anywhere, Placement::Line).offset, half);
  EXPECT_EQ(place(plane_across_at(-9.0), half, Allowed::Anywhere, Placement::Line).offset, -half);
}

TEST(Placement, LineIsTheMidpointOfAFlatQuadric) {
  EXPECT_EQ(place(on_edge({}), half, Allowed::Anywhere, Placement::Line).t, 0.5);
}

TEST(Placement, EndpointOrMidpointTakesTheBestOfThree) {
  const auto t = [](double x) {
    return place(plane_across_at(x), half, Allowed::Anywhere, Placement::EndpointOrMidpoint).t;
  };
  EXPECT_EQ(t(-0.8), 0.0);
  EXPECT_EQ(t(0.1), 0.5);
  EXPECT_EQ(t(0.7), 1.0);
}

TEST(Placement, HalfEdgeTakesTheBetterEndExactly) {
  for (double x : {-0.1, 0.1}) {
    const Placed placed = place(plane_across_at(x), half, Allowed::Anywhere, Placement::HalfEdge);
    EXPECT_EQ(placed.offset, x < 0.0 ? Vector3(-half) : half);
    EXPECT_EQ(placed.t, x < 0.0 ? 0.0 : 1.0);
  }
}

TEST(Placement, GoesWhereTheKindsDemandWhateverItIs) {
  for (Placement placement :
       {Placement::Optimal, Placement::Line, Placement::EndpointOrMidpoint, Placement::HalfEdge}) {
    EXPECT_EQ(place(plane_across_at(0.9), half, Allowed::OntoA, placement).offset, -half);
    EXPECT_EQ(place(plane_across_at(-0.9), half, Allowed::OntoB, placement).offset, half);
  }
}

TEST(Placement, OfAnEdgeWithoutLengthIsItsPoint) {
  for (Placement placement : {Placement::Line, Placement::EndpointOrMidpoint, Placement::HalfEdge})
    EXPECT_EQ(place(plane_across_at(0.9), Vector3::Zero(), Allowed::Anywhere, placement).offset,
              Vector3(0, 0, 0));
}

}  // namespace
}  // namespace curvdecim::test
