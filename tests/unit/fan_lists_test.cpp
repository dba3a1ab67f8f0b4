// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/passes/fan_lists.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/drawn_meshes.h"

namespace curvdecim::test {

using namespace detail;

namespace {

using List = std::vector<int>;

const auto everything = [](int) { return true; };

List list(const FanLists& fans, int v) { return {fans.of(v).begin(), fans.of(v).end()}; }

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

TEST(FanLists, HaveTheOrderOfTheFacesFromTheLeastOn) {
  EXPECT_EQ(list(fans_of({{3, 2, 0}, {0, 1, 3}, {2, 1, 0}, {1, 2, 3}}, 4), 0), (List{1, 3, 2}));
  EXPECT_EQ(list(fans_of({{0, 9, 4}, {2, 9, 0}, {0, 4, 2}}, 10), 0), (List{2, 9, 4}));
}

TEST(FanLists, AreEmptyWhereTheFacesAreNoClosedFan) {
  std::vector<Face> open = disk(6);
  open.pop_back();
  EXPECT_TRUE(list(fans_of(open, 7), 0).empty());
  EXPECT_TRUE(list(fans_of(disk(6), 7), 1).empty()) << "a vertex of the border";
  const std::vector<Face> two = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}};
  EXPECT_TRUE(list(fans_of(two, 7), 0).empty()) << "two fans";
  EXPECT_TRUE(list(fans_of(two, 8), 7).empty()) << "no face";
}

TEST(FanLists, AreEmptyWhereAFaceIsTheOtherWayRound) {
  std::vector<Face> faces = disk(5);
  std::swap(faces[2][1], faces[2][2]);
  EXPECT_TRUE(list(fans_of(faces, 6), 0).empty());
}

TEST(FanLists, AreEmptyWhereAnEdgeHasFourFaces) {
  std::vector<Face> faces = disk(4);
  for (const Face& face : {Face{0, 1, 5}, Face{0, 5, 6}, Face{0, 6, 1}}) faces.push_back(face);
  EXPECT_TRUE(list(fans_of(faces, 7), 0).empty());
}

TEST(FanLists, LeaveOutVerticesOfVeryManyFaces) {
  constexpr int most = FanLists::longest;
  EXPECT_EQ(list(fans_of(disk(most), most + 1), 0).size(), std::size_t{most});
  EXPECT_TRUE(list(fans_of(disk(most + 1), most + 2), 0).empty());
}

TEST(FanLists, LeaveOutWhatIsNotWanted) {
  const Shape ball = icosphere(1);
  FanLists fans;
  const int vertices = ball.vertex_count();
  fans.build(ball.faces, vertices, Parallel(1), [](int v) { return v != 3; });
  EXPECT_TRUE(list(fans, 3).empty());
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

}  // namespace
}  // namespace curvdecim::test
