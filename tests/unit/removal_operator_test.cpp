// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/removal/removal_operator.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/removal.h"
#include "support/removal_record.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

std::optional<Rejection> refusal(const Shape& shape, int v,
                                 const VertexRemovalParams& params = {}) {
  return RemovalOn(shape, params).ask(v).refusal;
}

int vertex_at(const Shape& shape, const Point& p) {
  const auto nearer = [&p](const Point& a, const Point& b) {
    return (a - p).norm() < (b - p).norm();
  };
  return static_cast<int>(std::min_element(shape.vertices.begin(), shape.vertices.end(), nearer) -
                          shape.vertices.begin());
}

TEST(RemovalOperator, FillsTheHoleOfAVertexInside) {
  RemovalOn removal(plane_grid(2));
  const int v = vertex_at(plane_grid(2), {0.5, 0.5, 0});
  const RemovalAnswer answer = removal.ask(v);
  ASSERT_FALSE(answer.refusal);
  EXPECT_EQ(answer.error, 0.0);
  removal.remove(answer);
  const Shape after = shape_of(removal.mesh);
  EXPECT_EQ(after.face_count(), 6);
  EXPECT_NEAR(area(after), 1.0, 1e-12);
  EXPECT_EQ(removal.mesh.connectivity.faces_of(v).size(), 0);
}

TEST(RemovalOperator, ATetrahedronStays) {
  for (int v = 0; v < 4; ++v) EXPECT_EQ(refusal(tetrahedron(), v), Rejection::LinkCondition);
  VertexRemovalParams any_angle;
  any_angle.preserve_normal = false;
  for (int v = 0; v < 6; ++v) EXPECT_FALSE(refusal(octahedron(), v, any_angle));
}

TEST(RemovalOperator, ABoundaryTriangleStays) {
  EXPECT_EQ(refusal(two_triangles(), 1), Rejection::LinkCondition);
  EXPECT_EQ(refusal(one_triangle(), 0), Rejection::LinkCondition);
}

TEST(RemovalOperator, ATriangularHoleStays) {
  // An annulus with three vertices around the hole, and the same with four.
  const Shape three = annulus(3, 2), four = annulus(4, 2);
  const Topology holes = topology(three);
  ASSERT_EQ(holes.boundary_loops, 2);
  const auto refusals = [](const Shape& ring, int around) {
    double least = 1e9;
    for (const Point& p : ring.vertices) least = std::min(least, p.norm());
    int refused = 0;
    for (int v = 0; v < ring.vertex_count(); ++v)
      if (ring.vertices[v].norm() < least + 1e-9)
        refused += refusal(ring, v) == Rejection::LinkCondition;
    EXPECT_TRUE(refused == 0 || refused == around);
    return refused;
  };
  EXPECT_EQ(refusals(three, 3), 3);
  EXPECT_EQ(refusals(four, 4), 0);
}

TEST(RemovalOperator, AComplexVertexStays) {
  EXPECT_EQ(refusal(bowtie(), 0), Rejection::VertexClass);
  EXPECT_EQ(refusal(book(3, 2), 1), Rejection::VertexClass);
}

TEST(RemovalOperator, ALockedVertexIsNoCandidate) {
  RemovalOn removal(plane_grid(4));
  const int v = vertex_at(plane_grid(4), {0.5, 0.5, 0});
  EXPECT_TRUE(removal.removals.estimate(v, removal.scratch.fan));
  removal.mesh.locked[v] = 1;
  EXPECT_FALSE(removal.removals.estimate(v, removal.scratch.fan));
}

TEST(RemovalOperator, ACornerStaysWhereFeaturesAreKept) {
  const Shape box = dense_box(4, {1, 1, 1});
  VertexRemovalParams params;
  params.preserve_features = true;
  const int corner = vertex_at(box, {0, 0, 0}), edge = vertex_at(box, {0, 0, 0.5});
  EXPECT_EQ(refusal(box, corner, params), Rejection::VertexClass);
  EXPECT_FALSE(refusal(box, edge, params));
  params.feature_angle = 100.0;
  EXPECT_NE(refusal(box, corner, params), Rejection::VertexClass);
}

TEST(RemovalOperator, AVertexOnARidgeLeavesTheRidge) {
  const Shape box = dense_box(4, {1, 1, 1});
  RemovalOn removal(box);
  const RemovalAnswer answer = removal.ask(vertex_at(box, {0, 0, 0.5}));
  ASSERT_FALSE(answer.refusal);
  EXPECT_EQ(answer.cost, 0.0);
  removal.remove(answer);
  EXPECT_TRUE(removal.mesh.connectivity.has_edge(vertex_at(box, {0, 0, 0.25}),
                                                 vertex_at(box, {0, 0, 0.75})));
  EXPECT_EQ(removal.class_of(vertex_at(box, {0, 0, 0.25})), VertexClass::InteriorEdge);
  EXPECT_NEAR(volume(shape_of(removal.mesh)), 1.0, 1e-12);
}

/// The distance that the paper gives each class, as the estimate of the first removal.
TEST(RemovalOperator, EstimatesByPlaneBoundaryLineAndFeatureLine) {
  const double height = 0.1;
  const auto estimate = [](const Shape& shape, const Point& near) {
    RemovalOn removal(shape);
    return removal.removals.estimate(vertex_at(shape, near), removal.scratch.fan)->distance;
  };
  Shape bump = fan(6);
  bump.vertices[0].z() = height;  // centres of the faces lie at a third of it
  EXPECT_NEAR(estimate(bump, {0, 0, height}), 2.0 / 3.0 * height, 1e-12);
  Shape dent = plane_grid(2);
  const int middle = vertex_at(dent, {0.5, 0, 0});
  dent.vertices[middle].y() = -height;
  EXPECT_NEAR(estimate(dent, {0.5, -height, 0}), height, 1e-12);
  Shape box = dense_box(2, {1, 1, 1});
  const int edge = vertex_at(box, {0, 0, 0.5});
  box.vertices[edge] = {-height, -height, 0.5};
  EXPECT_NEAR(estimate(box, {-height, -height, 0.5}), std::sqrt(2.0) * height, 1e-12);
}

TEST(RemovalOperator, ErrorsAddUpAtTheNeighbours) {
  RemovalOn removal(noisy_sphere(2, 0.05));
  double largest = 0.0;
  int removed = 0;
  for (int v = 0; v < removal.mesh.connectivity.vertex_slots(); ++v) {
    const RemovalAnswer answer = removal.ask(v);
    if (answer.refusal) continue;
    removal.remove(answer);
    const std::vector<int> loop = removal.scratch.fan.loop();
    for (int u : loop) {
      const RemovalAnswer next = removal.ask(u);
      EXPECT_TRUE(next.refusal || next.error >= answer.error);
    }
    largest = std::max(largest, answer.error);
    ++removed;
  }
  EXPECT_GT(removed, 50);
  EXPECT_LE(sampled_distance(noisy_sphere(2, 0.05), shape_of(removal.mesh)), largest);
}

TEST(RemovalOperator, RefusesWhatWouldExceedTheBound) {
  VertexRemovalParams params;
  params.distance_bound = 0.05;
  Shape bump = fan(6);
  bump.vertices[0].z() = 0.1;
  EXPECT_EQ(refusal(bump, 0, params), Rejection::ErrorBound);
  bump.vertices[0].z() = 0.04;
  EXPECT_FALSE(refusal(bump, 0, params));
}

TEST(RemovalOperator, RefusesToTurnFaces) {
  Shape spike = fan(6);
  spike.vertices[0].z() = 3.0;  // faces at 70 degrees to the new ones
  EXPECT_EQ(refusal(spike, 0), Rejection::NormalFlip);
  VertexRemovalParams params;
  params.preserve_normal = false;
  EXPECT_FALSE(refusal(spike, 0, params));
}

TEST(RemovalRecord, InsertsTheLastVertexAgain) {
  RemovalRecord record;
  RemovalOn removal(torus(8, 6), {}, {&record});
  const Shape before = shape_of(removal.mesh);
  int v = 0;
  RemovalAnswer answer;
  do {
    answer = removal.ask(v++);
  } while (answer.refusal);
  removal.remove(answer);
  EXPECT_FALSE(shape_of(removal.mesh) == before);
  record.insert_last(removal.mesh);
  EXPECT_EQ(shape_of(removal.mesh), before);
  EXPECT_EQ(record.size(), 0u);
}

}  // namespace
}  // namespace curvdecim::test
