// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/vertex_ring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "support/mesh_group.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

VertexRing ring_of(const WorkingMesh& mesh, int v) {
  VertexRing ring;
  gather_ring(mesh, v, ring);
  return ring;
}

std::multiset<int> neighbors(const VertexRing& ring) {
  std::multiset<int> vertices;
  for (const RingVertex& u : ring) vertices.insert(u.vertex);
  return vertices;
}

/// From all faces of the shape, by neighbour.
std::map<int, Point> brute_force(const Shape& shape, int v) {
  std::map<int, Point> wings;
  for (const Corners& face : shape.faces)
    if (std::count(face.begin(), face.end(), v) > 0)
      for (int u : face)
        if (u != v)
          wings.try_emplace(u, Point::Zero()).first->second += 0.5 * double_area(shape, face);
  return wings;
}

void expect_ring_as_by_brute_force(const Shape& shape, int v) {
  const VertexRing ring = ring_of(working_mesh(shape), v);
  const std::map<int, Point> expected = brute_force(shape, v);
  EXPECT_EQ(ring.size(), expected.size());
  for (const RingVertex& u : ring) {
    ASSERT_EQ(expected.count(u.vertex), 1u) << u.vertex << " is no neighbour of " << v;
    EXPECT_LT((u.wings - expected.at(u.vertex)).norm(), 1e-14) << v << '-' << u.vertex;
  }
}

/// A closed fan that is not flat, so that the faces at an edge differ.
Shape crown(int blades) {
  return mapped(fan(blades), [](const Point& p) {
    return Point(p.x(), p.y(), 0.3 * p.squaredNorm() * std::sin(7.0 * p.x() + p.y()));
  });
}

TEST(VertexRing, OfAnInnerVertexHasItsNeighboursOnce) {
  EXPECT_EQ(neighbors(ring_of(working_mesh(octahedron()), 0)), (std::multiset<int>{2, 3, 4, 5}));
  EXPECT_EQ(neighbors(ring_of(working_mesh(fan(6)), 0)), (std::multiset<int>{1, 2, 3, 4, 5, 6}));
}

TEST(VertexRing, OfABoundaryVertexHasBothEndsOfItsFan) {
  const WorkingMesh two = working_mesh(two_triangles());
  EXPECT_EQ(neighbors(ring_of(two, 0)), (std::multiset<int>{1, 2, 3}));
  EXPECT_EQ(neighbors(ring_of(two, 1)), (std::multiset<int>{0, 2}));
}

TEST(VertexRing, SumsTheAreaVectorsOfTheFacesAtEachEdge) {
  const WorkingMesh two = working_mesh(two_triangles());
  for (const RingVertex& u : ring_of(two, 0))
    EXPECT_EQ(u.wings, Vector3(0, 0, u.vertex == 2 ? 1.0 : 0.5)) << u.vertex;
}

TEST(VertexRing, OfAVertexWithoutFacesIsEmpty) {
  Shape shape = one_triangle();
  shape.vertices.push_back({5, 5, 5});
  VertexRing ring;
  gather_ring(working_mesh(shape), 3, ring);
  EXPECT_TRUE(ring.empty());
  gather_long_ring(working_mesh(shape), 3, ring);
  EXPECT_TRUE(ring.empty());
}

TEST(VertexRing, ForgetsTheVertexBefore) {
  for (int blades : {6, 100}) {
    const WorkingMesh mesh = working_mesh(crown(blades));
    VertexRing ring;
    for (int v : {0, 1, 0}) {
      gather_ring(mesh, v, ring);
      EXPECT_EQ(ring.size(), v == 0 ? blades : 3u);
    }
  }
}

TEST(VertexRing, OfAHubIsTheSameAsByBruteForce) {
  for (int blades : {3, 63, 64, 65, 66, 1000}) expect_ring_as_by_brute_force(crown(blades), 0);
}

TEST(VertexRing, OfAHubOfManySheetsIsTheSameAsByBruteForce) {
  const Shape sheets = book(80, 2);  // up to 240 faces at a vertex, 80 at an edge
  for (int v = 0; v <= 2; ++v) expect_ring_as_by_brute_force(sheets, v);
}

class VertexRingOn : public testing::TestWithParam<NamedShape> {};

TEST_P(VertexRingOn, IsTheSameAsByBruteForceAtEveryVertex) {
  const Shape& shape = GetParam().shape;
  for (int v = 0; v < shape.vertex_count(); v += 5) expect_ring_as_by_brute_force(shape, v);
}

TEST_P(VertexRingOn, HasTheWingsThatTheEdgeHas) {
  const WorkingMesh mesh = working_mesh(GetParam().shape);
  for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v)
    for (const RingVertex& u : ring_of(mesh, v)) {
      const Edge edge{std::min(v, u.vertex), std::max(v, u.vertex)};
      EXPECT_LT((u.wings - wings_of(mesh, edge)).norm(), 1e-14) << edge.a << '-' << edge.b;
    }
}

INSTANTIATE_TEST_SUITE_P(Drawn, VertexRingOn, testing::ValuesIn(all_meshes()), name_of);

}  // namespace
}  // namespace curvdecim::test
