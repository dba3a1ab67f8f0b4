// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/removal/vertex_fan.h"

#include <gtest/gtest.h>

#include <utility>

#include "support/drawn_meshes.h"
#include "support/removal.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// Two flat halves of `cells` squares that meet in a ridge along y, at this angle between their
/// normals.
Shape roof(double degrees, int cells = 4) {
  const double slope = std::tan(0.5 * degrees * M_PI / 180.0);
  return mapped(plane_grid(cells), [slope](const Point& p) {
    return Point(p.x(), p.y(), -slope * std::abs(p.x() - 0.5));
  });
}

int vertex_at(const Shape& shape, const Point& p) {
  for (int v = 0; v < shape.vertex_count(); ++v)
    if ((shape.vertices[v] - p).norm() < 1e-9) return v;
  ADD_FAILURE() << "no vertex at " << p.transpose();
  return 0;
}

VertexClass class_at(const Shape& shape, const Point& p, double angle = 60.0) {
  VertexRemovalParams params;
  params.feature_angle = angle;
  return RemovalOn(shape, params).class_of(vertex_at(shape, p));
}

TEST(VertexClass, SimpleInAPlane) {
  EXPECT_EQ(class_at(plane_grid(4), {0.5, 0.5, 0}), VertexClass::Simple);
}

TEST(VertexClass, BoundaryWhereTheFanIsOpen) {
  EXPECT_EQ(class_at(plane_grid(4), {0.5, 0, 0}), VertexClass::Boundary);
}

TEST(VertexClass, ComplexWhereTheFanIsNone) {
  EXPECT_EQ(RemovalOn(bowtie()).class_of(0), VertexClass::Complex);
  EXPECT_EQ(RemovalOn(book(3, 2)).class_of(1), VertexClass::Complex);
  Shape turned = fan(5);
  std::swap(turned.faces[2][1], turned.faces[2][2]);
  EXPECT_EQ(RemovalOn(turned).class_of(0), VertexClass::Complex);
  EXPECT_EQ(RemovalOn(fan(5)).class_of(0), VertexClass::Simple);
}

TEST(VertexClass, InteriorEdgeOnARidgeOfTheAngleOrMore) {
  EXPECT_EQ(class_at(roof(61), {0.5, 0.5, 0}), VertexClass::InteriorEdge);
  EXPECT_EQ(class_at(roof(59), {0.5, 0.5, 0}), VertexClass::Simple);
  EXPECT_EQ(class_at(roof(59), {0.5, 0.5, 0}, 30.0), VertexClass::InteriorEdge);
  EXPECT_EQ(class_at(roof(90), {0.5, 0.5, 0}, 180.0), VertexClass::Simple);
}

TEST(VertexClass, CornerWhereARidgeMeetsTheBoundary) {
  EXPECT_EQ(class_at(roof(90), {0.5, 0, 0}), VertexClass::Corner);
  EXPECT_EQ(class_at(roof(30), {0.5, 0, 0}), VertexClass::Boundary);
}

TEST(VertexClass, CornerWhereThreeSharpEdgesMeet) {
  const Shape box = dense_box(4, {1, 1, 1});
  EXPECT_EQ(class_at(box, {0, 0, 0}), VertexClass::Corner);
  EXPECT_EQ(class_at(box, {0, 0, 0.5}), VertexClass::InteriorEdge);
  EXPECT_EQ(class_at(box, {0, 0.5, 0.5}), VertexClass::Simple);
  EXPECT_EQ(class_at(box, {0, 0, 0}, 100.0), VertexClass::Simple);
}

/// A line of one sharp edge: both its ends are corners.
TEST(VertexClass, CornerWhereARidgeEnds) {
  Shape cut = roof(90);
  for (Point& p : cut.vertices)
    if (p.y() > 0.6 || p.y() < 0.4) p.z() = 0.0;
  const RemovalOn removal(cut);
  int corners = 0;
  VertexFan around;
  for (int v = 0; v < cut.vertex_count(); ++v)
    corners += removal.removals.class_at(v, around) == VertexClass::Corner;
  EXPECT_GE(corners, 2);
}

}  // namespace
}  // namespace curvdecim::test
