// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/touching.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// The shape with its sheets separated by what is between their faces.
Shape separated(const Shape& shape, Pairing pairing = Pairing::Material) {
  const WorkingMesh mesh = working_mesh(shape);
  const Revertexed apart = separated_sheets(mesh, pairing);
  if (apart.faces.empty()) return shape;
  Shape result{{}, apart.faces};
  for (int v : apart.old_of) result.vertices.push_back(shape.vertices[v]);
  return result;
}

/// Two closed parts without a flaw, each around material of its own.
void expect_two_parts(const Shape& shape, Pairing pairing = Pairing::Material) {
  const Topology is = topology(separated(shape, pairing));
  EXPECT_EQ(is.nonmanifold_edges, 0);
  EXPECT_EQ(is.nonmanifold_vertices, 0);
  EXPECT_EQ(is.boundary_loops, 0);
  EXPECT_EQ(is.inconsistent_edges, 0);
  EXPECT_EQ(is.components, 2);
  EXPECT_EQ(is.euler, 4);
}

void expect_as_it_is(const Shape& shape) {
  EXPECT_TRUE(separated_sheets(working_mesh(shape), Pairing::Material).faces.empty());
}

TEST(Sheets, OfBoxesWithACommonEdgeAreTheBoxes) { expect_two_parts(boxes_at_an_edge()); }

TEST(Sheets, ArePairedByTheirMaterialAndNotByTheSmallerAngle) {
  for (double half_angle : {10.0, 60.0, 85.0}) expect_two_parts(wedges_at_an_edge(half_angle));
}

TEST(Sheets, OfBoxesWithACommonFaceAreTheBoxes) {
  expect_two_parts(boxes_at_a_face(false));
  expect_two_parts(boxes_at_a_face(true));
}

/// A box and two faces back to back on an edge of it, up to a point.
Shape box_with_fin(const Point& tip) {
  Shape shape = cube();
  int a = 0, b = 0;
  for (int v = 0; v < shape.vertex_count(); ++v) {
    if (shape.vertices[v] == Point(1, 1, 0)) a = v;
    if (shape.vertices[v] == Point(1, 1, 1)) b = v;
  }
  shape.vertices.push_back(tip);
  shape.faces.push_back({a, b, 8}), shape.faces.push_back({b, a, 8});
  return shape;
}

TEST(Sheets, OfAFinInTheAirAndItsBoxAreBoth) {
  for (unsigned order = 1; order <= 8; ++order)
    expect_two_parts(renumbered(box_with_fin({2, 2, 0.5}), order));
}

TEST(Sheets, OfAFinInsideTheMaterialArePartedByTheAir) {
  const Shape shape = box_with_fin({0.5, 0.5, 0.5});
  expect_as_it_is(shape);  // it is a slit, and the material is one piece around it
  expect_two_parts(shape, Pairing::Air);
}

TEST(Sheets, OfPartsTurnedInsideOutArePartedByTheAir) {
  Shape inside_out = boxes_at_an_edge();
  for (Corners& f : inside_out.faces) std::swap(f[0], f[1]);
  expect_as_it_is(inside_out);  // the air between the boxes is one piece of material
  expect_two_parts(inside_out, Pairing::Air);
}

TEST(Sheets, DoNotDependOnThePlaceInSpace) {
  for (double angle : {0.3, 1.0, 2.5})
    expect_two_parts(rotated(translated(boxes_at_a_face(true), {3, 2, 1}), angle, {1, 2, 3}));
}

TEST(Sheets, ThatTouchInAPointAreSeparated) {
  expect_two_parts(touching_spheres());
  EXPECT_EQ(separated(bowtie()).vertex_count(), 6);
}

TEST(Sheets, OfADoubledSurfaceAreItsSides) {
  Shape doubled = fan(6);
  for (const Corners& f : fan(6).faces) doubled.faces.push_back({f[1], f[0], f[2]});
  const Topology is = topology(separated(doubled));
  EXPECT_EQ(is.nonmanifold_edges + is.nonmanifold_vertices + is.boundary_loops, 0);
  EXPECT_EQ(is.euler, 2);
}

TEST(Sheets, CopiesFollowTheirOriginal) {
  const Revertexed apart = separated_sheets(working_mesh(bowtie()), Pairing::Material);
  EXPECT_EQ(apart.old_of, (std::vector<int>{0, 0, 1, 2, 3, 4}));
}

TEST(Sheets, ThatMeetInThreesOrAllInOneDirectionStayTogether) {
  expect_as_it_is(torus(8, 6));
  expect_as_it_is(book(3, 4));
  expect_as_it_is(book(4, 4));
  expect_as_it_is(book(5, 4));
}

TEST(Sheets, WithAFaceThatHasNoSideStayTogether) {
  Shape shape = boxes_at_an_edge();
  const auto [a, b] = edge_in_common(shape);
  shape.vertices.push_back(0.5 * (shape.vertices[a] + shape.vertices[b]));
  const int middle = shape.vertex_count() - 1;
  shape.faces.push_back({a, b, middle}), shape.faces.push_back({b, a, middle});
  EXPECT_EQ(topology(separated(shape)).nonmanifold_edges, topology(shape).nonmanifold_edges);
}

/// How many sheets can be parted at v.
int partable_at(const Shape& shape, int v) {
  const std::vector<int> sheets = partable_sheets(working_mesh(shape), v);
  return sheets.empty() ? 0 : *std::max_element(sheets.begin(), sheets.end()) + 1;
}

TEST(Sheets, OfABookCanBeParted) {
  for (int pages : {3, 4, 5}) {  // they all run alike along the spine: none hang together
    EXPECT_EQ(partable_at(book(pages, 4), 2), pages);
    EXPECT_EQ(partable_at(book(pages, 4), 0), pages);  // at the end of the spine
  }
}

TEST(Sheets, OfAManifoldOrAtALockedVertexCannotBeParted) {
  EXPECT_EQ(partable_at(plane_grid(4), 12), 0);
  EXPECT_EQ(partable_at(plane_grid(4), 0), 0);
  WorkingMesh mesh = working_mesh(book(3, 4));
  mesh.locked[2] = 1;
  EXPECT_TRUE(partable_sheets(mesh, 2).empty());
}

TEST(Sheets, ThatAreFlattestHangTogether) {
  // From the origin: a plane in two halves, and a third page that stands on it.
  Shape shape{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0.2}, {0.1, 0, 1}}, {}};
  shape.faces = {{0, 2, 1}, {1, 3, 0}, {0, 1, 4}};
  EXPECT_EQ(partable_sheets(working_mesh(shape), 0), (std::vector<int>{0, 0, 1}));
}

TEST(Sheets, AreAllPartedWhereTheFlattestHangTogetherInARing) {
  // Four sheets around a line through vertex 0; above it 0 goes on as 1 and 2 as 3, below 0 as 3.
  Shape shape{{{0, 0, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
  const auto add = [&](double degrees, double z) {
    const double angle = degrees * M_PI / 180.0;
    shape.vertices.push_back({std::cos(angle), std::sin(angle), z});
    return shape.vertex_count() - 1;
  };
  const double above[] = {0, 180, 80, 260}, below[] = {0, 80, 260, 180};
  for (int i = 0; i < 4; ++i) {
    const int m = add(above[i], 0.5), n = add(below[i], -0.5);
    shape.faces.insert(shape.faces.end(), {{0, 1, m}, {0, m, n}, {0, n, 2}});
  }
  EXPECT_EQ(partable_at(shape, 0), 4);
}

TEST(Sheets, LockedVerticesStayOne) {
  WorkingMesh mesh = working_mesh(touching_spheres());
  mesh.locked[0] = 1;
  EXPECT_TRUE(separated_sheets(mesh, Pairing::Material).faces.empty());
}

}  // namespace
}  // namespace curvdecim::test
