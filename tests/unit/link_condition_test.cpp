// SPDX-License-Identifier: GPL-3.0-or-later
// Drawn cases: every way in which a collapse could change the topology has a name here.
#include "vcg_ext/guard/link_condition.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

bool satisfied(const Shape& shape, Edge edge) {
  const WorkingMesh mesh = working_mesh(shape);
  EXPECT_TRUE(mesh.connectivity.has_edge(edge.a, edge.b)) << "the test names no edge";
  EdgeNeighborhood around;
  around.gather(mesh.connectivity, edge);
  return satisfies_link_condition(mesh, around);
}

TEST(LinkCondition, HoldsInsideASheet) { EXPECT_TRUE(satisfied(plane_grid(4), {12, 17})); }
TEST(LinkCondition, HoldsOnAClosedSurface) { EXPECT_TRUE(satisfied(octahedron(), {0, 2})); }
TEST(LinkCondition, HoldsAlongTheBoundary) { EXPECT_TRUE(satisfied(plane_grid(4), {1, 2})); }
TEST(LinkCondition, HoldsFromInsideOntoTheBoundary) {
  EXPECT_TRUE(satisfied(plane_grid(4), {2, 7}));
}
TEST(LinkCondition, HoldsAlongASpine) { EXPECT_TRUE(satisfied(book(3, 4), {1, 2})); }
TEST(LinkCondition, HoldsForTheLastButOneTriangle) {
  EXPECT_TRUE(satisfied(two_triangles(), {0, 1}));
}

TEST(LinkCondition, RefusesToFlattenATetrahedron) {
  for (Edge edge : {Edge{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}})
    EXPECT_FALSE(satisfied(tetrahedron(), edge));
}

TEST(LinkCondition, RefusesToRemoveTheLastTriangle) {
  for (Edge edge : {Edge{0, 1}, {0, 2}, {1, 2}}) EXPECT_FALSE(satisfied(one_triangle(), edge));
}

TEST(LinkCondition, RefusesAnInnerEdgeBetweenTwoBoundaryVertices) {
  EXPECT_FALSE(satisfied(two_triangles(), {0, 2}));    // would leave nothing
  EXPECT_FALSE(satisfied(triangle_strip(6), {3, 4}));  // would pinch the strip
}

TEST(LinkCondition, RefusesToFillATriangularHole) {
  Shape holed = octahedron();
  holed.faces.erase(holed.faces.begin());
  for (Edge edge : {Edge{0, 2}, {0, 4}, {2, 4}}) EXPECT_FALSE(satisfied(holed, edge));
}

TEST(LinkCondition, RefusesToCutAThinTube) {
  const Shape tube = open_cylinder(3, 4);  // three faces around
  EXPECT_FALSE(satisfied(tube, {2, 7}));   // around the tube, away from its ends
  EXPECT_TRUE(satisfied(tube, {2, 3}));    // along it
}

TEST(LinkCondition, RefusesToCloseAThinRing) {
  const Shape ring = torus(3, 8);  // three columns around the hole
  EXPECT_FALSE(satisfied(ring, {1, 9}));
}

TEST(LinkCondition, RefusesAnEdgeWhoseEndsBothTouchTheHole) {
  EXPECT_FALSE(satisfied(annulus(6, 1), {0, 1}));  // would join the two boundaries in a point
}

TEST(LinkCondition, RefusesToDoubleAFaceOverAFilledTriangle) {
  // Vertex 3 above triangle 0 1 2, and 4 below: 0 1 2 is a separating triangle that is no face.
  const Shape bipyramid{{{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                        {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}};
  EXPECT_FALSE(satisfied(bipyramid, {0, 1}));  // 2 is a common neighbour without a face at the edge
  EXPECT_TRUE(satisfied(bipyramid, {0, 3}));
}

TEST(LinkCondition, RefusesTwoEdgesOfACurveThatMeetAgain) {
  // Three triangles around each of the edges 0-1, 1-2 and 2-0: the curve is a triangle itself.
  Shape shape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)})
    for (double height : {1.0, -1.0}) {
      shape.vertices.push_back(0.5 * (shape.vertices[a] + shape.vertices[b]) + Point(0, 0, height));
      shape.faces.push_back({a, b, shape.vertex_count() - 1});
    }
  EXPECT_FALSE(satisfied(shape, {0, 1}));
}

/// Exhaustive: on every edge of small meshes the condition says what the topology says.
class LinkConditionOn : public testing::TestWithParam<int> {};

TEST_P(LinkConditionOn, EveryEdgeAgreesWithTheTopologyAfterwards) {
  const Shape shapes[] = {octahedron(),
                          cube(),
                          torus(4, 3),
                          open_cylinder(3, 3),
                          annulus(4, 1),
                          moebius_strip(5, 2),
                          grid_with_small_holes(8),
                          bowtie(),
                          triangle_strip(5),
                          klein_bottle(5, 4)};
  const Shape& shape = shapes[GetParam()];
  const Topology before = topology(shape);
  ASSERT_EQ(before.unreferenced_vertices, 0);
  for (int a = 0; a < shape.vertex_count(); ++a)
    for (int b = a + 1; b < shape.vertex_count(); ++b) {
      WorkingMesh mesh = working_mesh(shape);
      if (!mesh.connectivity.has_edge(a, b) || mesh.kind[a] == VertexKind::Junction ||
          mesh.kind[b] == VertexKind::Junction)
        continue;
      const bool allowed = satisfied(shape, {a, b});
      mesh.connectivity.collapse(a, b);
      Topology after = topology(shape_of(mesh));
      --after.unreferenced_vertices;  // the vertex that went; no other may lose its last face
      EXPECT_EQ(allowed, keeps_topology(before, after)) << a << '-' << b << ": " << after;
    }
}

INSTANTIATE_TEST_SUITE_P(SmallMeshes, LinkConditionOn, testing::Range(0, 10));

}  // namespace
}  // namespace curvdecim::test
