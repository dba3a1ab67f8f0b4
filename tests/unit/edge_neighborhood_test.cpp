// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/edge_neighborhood.h"

#include <gtest/gtest.h>

#include <set>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

EdgeNeighborhood gathered(const Shape& shape, Edge edge) {
  EdgeNeighborhood around;
  around.gather(connectivity_of(shape), edge);
  return around;
}

TEST(EdgeNeighborhood, OfADiagonalHasTwoWings) {
  const EdgeNeighborhood around = gathered(two_triangles(), {0, 2});
  EXPECT_EQ(around.wings().size(), 2u);
  EXPECT_EQ(std::set<int>(around.thirds().begin(), around.thirds().end()), (std::set<int>{1, 3}));
  EXPECT_TRUE(around.star().empty());
}

TEST(EdgeNeighborhood, OfABoundaryEdgeHasOneWing) {
  const EdgeNeighborhood around = gathered(two_triangles(), {0, 1});
  EXPECT_EQ(around.wings(), (std::vector<int>{0}));
  EXPECT_EQ(around.star(), (std::vector<int>{1}));
}

TEST(EdgeNeighborhood, OfAnOctahedronHasFourStarFaces) {
  const EdgeNeighborhood around = gathered(octahedron(), {0, 2});
  EXPECT_EQ(around.wings().size(), 2u);
  EXPECT_EQ(around.star().size(), 4u);
}

TEST(EdgeNeighborhood, OfASpineHasAWingAPage) {
  EXPECT_EQ(gathered(book(4, 1), {0, 1}).wings().size(), 4u);
}

TEST(EdgeNeighborhood, ListsTheStarOfTheFirstEndFirst) {
  const Shape shape = octahedron();
  const EdgeNeighborhood around = gathered(shape, {0, 2});
  ASSERT_EQ(around.star_of_a(), 2u);
  for (std::size_t i = 0; i < around.star().size(); ++i)
    EXPECT_EQ(connectivity_of(shape).face_has(around.star()[i], 0), i < around.star_of_a());
}

TEST(EdgeNeighborhood, IsForgottenWhenAnotherEdgeIsGathered) {
  const TriangleConnectivity ball = connectivity_of(octahedron());
  EdgeNeighborhood around;
  around.gather(ball, {0, 2}), around.gather(ball, {1, 3});
  EXPECT_EQ(around.edge().a, 1);
  EXPECT_EQ(around.wings().size(), 2u);
  EXPECT_EQ(around.star().size(), 4u);
}

}  // namespace
}  // namespace curvdecim::test
