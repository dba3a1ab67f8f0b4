// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/vertex_kind.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

std::vector<VertexKind> kinds(const Shape& shape) {
  return classify_vertices(connectivity_of(shape), Parallel(1));
}

int count(const Shape& shape, VertexKind kind) {
  const std::vector<VertexKind> all = kinds(shape);
  return static_cast<int>(std::count(all.begin(), all.end(), kind));
}

TEST(VertexKind, OfAClosedManifoldIsInterior) {
  for (const Shape& shape : {tetrahedron(), octahedron(), cube(), torus(8, 6), klein_bottle(12, 6)})
    EXPECT_EQ(count(shape, VertexKind::Interior), shape.vertex_count());
}

TEST(VertexKind, OfTwoFacesBackToBackIsInterior) {
  EXPECT_EQ(count({one_triangle().vertices, {{0, 1, 2}, {0, 2, 1}}}, VertexKind::Interior), 3);
}

TEST(VertexKind, OfASheetIsInteriorInsideAndBoundaryAround) {
  EXPECT_EQ(count(plane_grid(4), VertexKind::Interior), 9);
  EXPECT_EQ(count(plane_grid(4), VertexKind::Boundary), 16);
  EXPECT_EQ(count(one_triangle(), VertexKind::Boundary), 3);
  EXPECT_EQ(count(two_triangles(), VertexKind::Boundary), 4);
}

TEST(VertexKind, OfAFanIsInteriorAtItsApex) { EXPECT_EQ(kinds(fan(9))[0], VertexKind::Interior); }

TEST(VertexKind, WhereTwoTrianglesTouchIsJunction) {
  EXPECT_EQ(kinds(bowtie())[0], VertexKind::Junction);
  EXPECT_EQ(count(bowtie(), VertexKind::Boundary), 4);
}

TEST(VertexKind, WhereTwoSpheresTouchIsJunction) {
  EXPECT_EQ(kinds(touching_spheres())[0], VertexKind::Junction);
  EXPECT_EQ(count(touching_spheres(), VertexKind::Junction), 1);
}

TEST(VertexKind, AlongTheSpineOfABookIsCurveAndJunctionAtItsEnds) {
  for (int pages : {3, 4, 5}) {
    EXPECT_EQ(count(book(pages, 4), VertexKind::Curve), 3);
    EXPECT_EQ(count(book(pages, 4), VertexKind::Junction), 2);
  }
}

TEST(VertexKind, OfTwoPagesIsThatOfOneSheet) {
  EXPECT_EQ(count(book(2, 4), VertexKind::Curve), 0);
  EXPECT_EQ(count(book(2, 4), VertexKind::Junction), 0);
}

TEST(VertexKind, WhereCurvesEndInsideASheetIsJunctionInAnyOrderOfTheFaces) {
  // A fin stands on the middle of a sheet; its foot is an edge curve with two ends.
  Shape shape = plane_grid(4);
  shape.vertices.push_back({0.5, 0.5, 1.0});
  shape.faces.push_back({12, 17, 25});
  for (int turn = 0; turn < shape.face_count(); ++turn) {
    std::rotate(shape.faces.begin(), shape.faces.begin() + 1, shape.faces.end());
    ASSERT_EQ(kinds(shape)[12], VertexKind::Junction);
    ASSERT_EQ(kinds(shape)[17], VertexKind::Junction);
    ASSERT_EQ(kinds(shape)[25], VertexKind::Boundary);
  }
}

TEST(VertexKind, DoesNotDependOnOrientation) {
  Shape shape = plane_grid(3);
  for (int f = 0; f < shape.face_count(); f += 2) std::swap(shape.faces[f][0], shape.faces[f][1]);
  EXPECT_EQ(kinds(shape), kinds(plane_grid(3)));
}

TEST(VertexKind, OfAVertexWithoutFacesIsInterior) {
  Shape shape = one_triangle();
  shape.vertices.push_back({1, 2, 3});
  EXPECT_EQ(kinds(shape)[3], VertexKind::Interior);
}

}  // namespace
}  // namespace curvdecim::test
