// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/passes/fan_lists.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"
#include "vcg_ext/passes/collapse_in_passes.h"

namespace curvdecim::test {

using namespace detail;

namespace {

const auto everything = [](int) { return true; };

std::vector<int> list(const FanLists& fans, int v) {
  return {fans.of(v).begin(), fans.of(v).end()};
}

FanLists fans_of(const std::vector<Face>& faces, int vertices, int threads = 1) {
  FanLists fans;
  fans.build(faces, vertices, Parallel(threads), everything);
  return fans;
}

/// Around vertex 0, a triangle for each side of a polygon of vertices 1 to `sides`.
std::vector<Face> disk(int sides) {
  std::vector<Face> faces;
  for (int i = 1; i <= sides; ++i) faces.push_back({0, i, i % sides + 1});
  return faces;
}

TEST(FanLists, HaveTheFacesInOrder) {
  const FanLists fans = fans_of({{3, 2, 0}, {0, 1, 3}, {2, 1, 0}, {1, 2, 3}}, 5);
  EXPECT_EQ(list(fans, 0), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(list(fans, 3), (std::vector<int>{0, 1, 3}));
  EXPECT_TRUE(list(fans, 4).empty()) << "no face";
}

TEST(Face, HasACornerThatFollows) {
  const Face face = {7, 3, 5};
  EXPECT_EQ(next_in(face, 7), 3);
  EXPECT_EQ(next_in(face, 3), 5);
  EXPECT_EQ(next_in(face, 5), 7);
}

TEST(FanLists, LeaveOutVerticesOfVeryManyFaces) {
  constexpr int most = FanLists::longest;
  const FanLists fits = fans_of(disk(most), most + 1), does_not = fans_of(disk(most + 1), most + 2);
  EXPECT_EQ(list(fits, 0).size(), std::size_t{most});
  EXPECT_TRUE(fits.has(0));
  EXPECT_TRUE(list(does_not, 0).empty());
  EXPECT_FALSE(does_not.has(0));
}

TEST(FanLists, LeaveOutWhatIsNotWanted) {
  const Shape ball = icosphere(1);
  FanLists fans;
  const int vertices = ball.vertex_count();
  fans.build(ball.faces, vertices, Parallel(1), [](int v) { return v != 3; });
  EXPECT_TRUE(list(fans, 3).empty());
  EXPECT_FALSE(fans.has(3));
  EXPECT_EQ(list(fans, 4), list(fans_of(ball.faces, vertices), 4));
  EXPECT_FALSE(list(fans, 4).empty());
}

TEST(FanLists, AreTheSameForAnyNumberOfThreads) {
  const Shape ball = icosphere(4);
  const int vertices = ball.vertex_count();
  const FanLists one = fans_of(ball.faces, vertices);
  for (int threads : {2, 3, 16}) {
    const FanLists many = fans_of(ball.faces, vertices, threads);
    for (int v = 0; v < vertices; ++v) ASSERT_EQ(list(many, v), list(one, v));
  }
}

// --- whether the faces are one fan ---------------------------------------------------------------

bool is_closed(const std::vector<Face>& faces, int vertices, int v) {
  Shape shape;
  for (int i = 0; i < vertices; ++i) shape.vertices.emplace_back(i, i * i, 0.3 * i * i * i);
  shape.faces = faces;
  return is_closed_fan(working_mesh(shape), v);
}

TEST(ClosedFan, IsADiskOfFacesThatAreOrientedAlike) {
  EXPECT_TRUE(is_closed(disk(5), 6, 0));
  EXPECT_FALSE(is_closed(disk(5), 6, 1)) << "a vertex of the border";
  std::vector<Face> turned = disk(5);
  std::swap(turned[2][1], turned[2][2]);
  EXPECT_FALSE(is_closed(turned, 6, 0));
  std::vector<Face> two = disk(3);
  for (const Face& face : {Face{0, 4, 5}, Face{0, 5, 6}, Face{0, 6, 4}}) two.push_back(face);
  EXPECT_FALSE(is_closed(two, 7, 0)) << "two fans";
}

TEST(ClosedFan, IsNoHub) {
  constexpr int hub = TriangleConnectivity::hub;
  EXPECT_TRUE(is_closed(disk(hub), hub + 1, 0));
  EXPECT_FALSE(is_closed(disk(hub + 1), hub + 2, 0));
}

}  // namespace
}  // namespace curvdecim::test
