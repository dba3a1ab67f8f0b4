// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/connectivity/edge_neighborhood.h"

#include <gtest/gtest.h>

#include <set>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {
namespace {

EdgeNeighborhood gathered(const Shape& shape, Edge edge) {
  EdgeNeighborhood around(shape.vertex_count());
  around.gather(connectivity_of(shape), edge);
  return around;
}

TEST(EdgeNeighborhood, OfADiagonalHasTwoWings) {
  const EdgeNeighborhood around = gathered(two_triangles(), {0, 2});
  EXPECT_EQ(around.wings().size(), 2u);
  EXPECT_EQ(std::set<int>(around.thirds().begin(), around.thirds().end()), (std::set<int>{1, 3}));
  EXPECT_TRUE(around.star().empty());
  EXPECT_EQ(around.common_neighbors(), 2);
}

TEST(EdgeNeighborhood, OfABoundaryEdgeHasOneWing) {
  const EdgeNeighborhood around = gathered(two_triangles(), {0, 1});
  EXPECT_EQ(around.wings(), (std::vector<int>{0}));
  EXPECT_EQ(around.star(), (std::vector<int>{1}));
  EXPECT_EQ(around.common_neighbors(), 1);
}

TEST(EdgeNeighborhood, OfAnOctahedronHasFourStarFaces) {
  const EdgeNeighborhood around = gathered(octahedron(), {0, 2});
  EXPECT_EQ(around.wings().size(), 2u);
  EXPECT_EQ(around.star().size(), 4u);
  EXPECT_EQ(around.common_neighbors(), 2);
}

TEST(EdgeNeighborhood, CountsANeighbourThatIsInNoWing) {
  EXPECT_EQ(gathered(tetrahedron(), {0, 1}).common_neighbors(), 2);
  // A boundary edge of a triangular hole has the hole's third corner as a second common neighbour.
  Shape holed = octahedron();
  holed.faces.erase(holed.faces.begin());
  EXPECT_EQ(gathered(holed, {0, 2}).wings().size(), 1u);
  EXPECT_EQ(gathered(holed, {0, 2}).common_neighbors(), 2);
}

TEST(EdgeNeighborhood, OfASpineHasAWingAPage) {
  EXPECT_EQ(gathered(book(4, 1), {0, 1}).common_neighbors(), 4);
}

TEST(EdgeNeighborhood, IsForgottenWhenAnotherEdgeIsGathered) {
  const TriangleConnectivity ball = connectivity_of(octahedron());
  EdgeNeighborhood around(6);
  around.gather(ball, {0, 2}), around.gather(ball, {1, 3});
  EXPECT_EQ(around.edge().a, 1);
  EXPECT_EQ(around.wings().size(), 2u);
  EXPECT_EQ(around.star().size(), 4u);
}

TEST(ForEachNeighbor, VisitsEveryNeighbourOnce) {
  VertexMarks marks(6);
  std::multiset<int> seen;
  for_each_neighbor(connectivity_of(octahedron()), 0, marks, [&](int u) { seen.insert(u); });
  EXPECT_EQ(seen, (std::multiset<int>{2, 3, 4, 5}));
}

TEST(VertexMarks, IsASet) {
  VertexMarks marks(3);
  EXPECT_TRUE(marks.insert(1));
  EXPECT_FALSE(marks.insert(1));
  EXPECT_TRUE(marks.has(1));
  EXPECT_TRUE(marks.erase(1));
  EXPECT_FALSE(marks.erase(1));
  marks.insert(2);
  marks.clear();
  EXPECT_FALSE(marks.has(2));
}

}  // namespace
}  // namespace curvdecim::test
