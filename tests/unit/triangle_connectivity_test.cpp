// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/triangle_connectivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

std::set<int> faces_of(const TriangleConnectivity& connectivity, int v) {
  const auto range = connectivity.faces_of(v);
  return {range.begin(), range.end()};
}

void expect_consistent(const TriangleConnectivity& connectivity) {
  EXPECT_NO_THROW(connectivity.validate());
}

/// What validate() complains of; empty: nothing.
std::string flaw_of(const TriangleConnectivity& connectivity) {
  try {
    connectivity.validate();
    return "";
  } catch (const std::logic_error& error) {
    return error.what();
  }
}

TEST(TriangleConnectivity, KnowsItsFlaws) {
  TriangleConnectivity ball = connectivity_of(octahedron());
  EXPECT_EQ(flaw_of(ball), "");
  const Removed removed = ball.collapse(0, 2);
  EXPECT_NE(flaw_of(ball).find("faces are miscounted"), std::string::npos);
  ball.count({removed.faces, 0});
  EXPECT_NE(flaw_of(ball).find("vertices are miscounted"), std::string::npos);
  ball.count({0, removed.vertices});
  EXPECT_EQ(flaw_of(ball), "");
  const TriangleConnectivity folded({{0, 0, 1}}, 2);
  EXPECT_NE(flaw_of(folded).find("a vertex twice"), std::string::npos);
}

TEST(TriangleConnectivity, ListsTheFacesAroundAVertex) {
  const TriangleConnectivity two = connectivity_of(two_triangles());
  EXPECT_EQ(faces_of(two, 0), (std::set<int>{0, 1}));
  EXPECT_EQ(faces_of(two, 1), (std::set<int>{0}));
  EXPECT_EQ(faces_of(two, 3), (std::set<int>{1}));
}

TEST(TriangleConnectivity, CountsOnlyVerticesWithAFace) {
  Shape shape = two_triangles();
  shape.vertices.push_back({5, 5, 5});
  const TriangleConnectivity connectivity = connectivity_of(shape);
  EXPECT_EQ(connectivity.vertex_slots(), 5);
  EXPECT_EQ(connectivity.vertex_count(), 4);
}

TEST(TriangleConnectivity, FindsEdgesFacesAndCorners) {
  const TriangleConnectivity two = connectivity_of(two_triangles());
  EXPECT_TRUE(two.has_edge(0, 2));
  EXPECT_FALSE(two.has_edge(1, 3));
  EXPECT_EQ(two.find_face(3, 0, 2), 1);
  EXPECT_EQ(two.find_face(1, 2, 3), -1);
  EXPECT_EQ(two.corner(1, 2), 1);
  EXPECT_EQ(two.third_vertex(1, 3, 0), 2);
}

TEST(TriangleConnectivity, RemovesAFace) {
  TriangleConnectivity two = connectivity_of(two_triangles());
  two.count(two.remove_face(1));
  EXPECT_FALSE(two.alive(1));
  EXPECT_EQ(two.vertex_count(), 3);
  expect_consistent(two);
}

TEST(TriangleConnectivity, CollapseRemovesTheWingsAndReconnectsTheStar) {
  TriangleConnectivity ball = connectivity_of(octahedron());
  ball.count(ball.collapse(0, 2));
  EXPECT_EQ(ball.face_count(), 6);
  EXPECT_EQ(ball.vertex_count(), 5);
  EXPECT_EQ(ball.faces_of(2).size(), 0);
  EXPECT_TRUE(ball.has_edge(0, 1));
  expect_consistent(ball);
}

TEST(TriangleConnectivity, CollapseKeepsTheOrientation) {
  TriangleConnectivity grid = connectivity_of(plane_grid(2));
  const Shape shape = plane_grid(2);
  grid.count(grid.collapse(4, 3));  // the centre takes in a neighbour on the boundary
  for (int f = 0; f < grid.face_slots(); ++f)
    EXPECT_TRUE(!grid.alive(f) || double_area(shape, grid.face(f)).z() > 0.0);
  expect_consistent(grid);
}

TEST(TriangleConnectivity, FlipTakesTheOtherDiagonalAndKeepsTheOrientation) {
  TriangleConnectivity square = connectivity_of(two_triangles());
  const Shape shape = two_triangles();
  ASSERT_TRUE(square.has_edge(0, 2));
  const bool first_runs_along = square.face(0)[(square.corner(0, 0) + 1) % 3] == 2;
  square.flip(0, 1, first_runs_along ? 0 : 2, first_runs_along ? 2 : 0);
  EXPECT_FALSE(square.has_edge(0, 2));
  EXPECT_TRUE(square.has_edge(1, 3));
  for (int f : {0, 1}) EXPECT_GT(double_area(shape, square.face(f)).z(), 0.0);
  expect_consistent(square);
}

TEST(TriangleConnectivity, SurvivesAVertexThatSwallowsAllOthers) {
  TriangleConnectivity grid = connectivity_of(plane_grid(20));
  for (int v = 1; v < grid.vertex_slots() && grid.face_count() > 0; ++v) {
    grid.count(grid.collapse(0, v));
    expect_consistent(grid);
  }
  EXPECT_EQ(grid.face_count(), 0);
  EXPECT_EQ(grid.vertex_count(), 0);
}

TEST(TriangleConnectivity, ReplacesFacesAndReplacesThemBack) {
  TriangleConnectivity star = connectivity_of(fan(5));
  const TriangleConnectivity before = star;
  const std::vector<int> which = {0, 1, 2, 3, 4};
  std::vector<Face> old;
  for (int f : which) old.push_back(star.face(f));
  const Face none = {TriangleConnectivity::dead, TriangleConnectivity::dead,
                     TriangleConnectivity::dead};
  const Removed removed = star.replace(which, {{1, 2, 3}, {1, 3, 4}, none, {1, 4, 5}, none});
  EXPECT_EQ(removed.faces, 2);
  EXPECT_EQ(removed.vertices, 1);
  star.count(removed);
  expect_consistent(star);
  star.count(star.replace(which, old));
  expect_consistent(star);
  for (int v = 0; v < star.vertex_slots(); ++v) {
    const IndexRange now = star.faces_of(v), was = before.faces_of(v);
    EXPECT_TRUE(std::equal(now.begin(), now.end(), was.begin(), was.end()));
  }
}

}  // namespace
}  // namespace curvdecim::test
