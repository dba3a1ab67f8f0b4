// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/removal/vertex_fan.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// Face i holds the neighbours i and i + 1, in its own direction.
void expect_in_order(const TriangleConnectivity& connectivity, const VertexFan& fan) {
  const std::vector<int>& loop = fan.loop();
  for (std::size_t i = 0; i < fan.faces().size(); ++i) {
    EXPECT_EQ(connectivity.next_vertex(fan.faces()[i], fan.vertex()), loop[i]);
    EXPECT_EQ(connectivity.next_vertex(fan.faces()[i], loop[i]), loop[(i + 1) % loop.size()]);
  }
}

TEST(VertexFan, ClosesAroundAVertexInside) {
  const TriangleConnectivity connectivity = connectivity_of(icosphere(1));
  VertexFan around;
  for (int v = 0; v < connectivity.vertex_slots(); ++v) {
    ASSERT_TRUE(around.gather(connectivity, v));
    EXPECT_TRUE(around.closed());
    EXPECT_EQ(static_cast<int>(around.faces().size()), connectivity.faces_of(v).size());
    expect_in_order(connectivity, around);
  }
}

TEST(VertexFan, RunsFromEndToEndOnTheBoundary) {
  const TriangleConnectivity connectivity = connectivity_of(two_triangles());
  VertexFan around;
  ASSERT_TRUE(around.gather(connectivity, 0));
  EXPECT_FALSE(around.closed());
  EXPECT_EQ(around.loop(), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(around.place_of(3), 2);
  expect_in_order(connectivity, around);
  ASSERT_TRUE(around.gather(connectivity, 1));
  EXPECT_EQ(around.loop(), (std::vector<int>{2, 0}));
}

TEST(VertexFan, IsNoneWhereTwoFansTouch) {
  VertexFan around;
  EXPECT_FALSE(around.gather(connectivity_of(bowtie()), 0));
  EXPECT_TRUE(around.gather(connectivity_of(bowtie()), 1));
}

TEST(VertexFan, IsNoneOfTwoFacesBackToBack) {
  const Shape pillow{one_triangle().vertices, {{0, 1, 2}, {0, 2, 1}}};
  VertexFan around;
  EXPECT_FALSE(around.gather(connectivity_of(pillow), 0));
}

TEST(VertexFan, IsNoneWhereThreeSheetsMeet) {
  VertexFan around;
  EXPECT_FALSE(around.gather(connectivity_of(book(3, 2)), 1));
}

TEST(VertexFan, IsNoneWhereAFaceIsTurnedOver) {
  Shape shape = fan(5);
  VertexFan around;
  EXPECT_TRUE(around.gather(connectivity_of(shape), 0));
  std::swap(shape.faces[2][1], shape.faces[2][2]);
  EXPECT_FALSE(around.gather(connectivity_of(shape), 0));
}

TEST(VertexFan, OfAHubIsNotGathered) {
  VertexFan around;
  EXPECT_TRUE(around.gather(connectivity_of(fan(VertexFan::longest)), 0));
  EXPECT_FALSE(around.gather(connectivity_of(fan(VertexFan::longest + 1)), 0));
}

}  // namespace
}  // namespace curvdecim::test
