// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/guard/crossing_guard.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"
#include "vcg_ext/collapse/round_crossings.h"

namespace curvdecim::test {

using namespace detail;

namespace {

const Parallel one_thread(1);
constexpr double gap = 0.02;

/// Two flat sheets of 4 x 4 cells of a tenth, one a little above the other.
Shape sheets() {
  const Shape sheet = scaled(plane_grid(4), 0.4);
  return side_by_side({sheet, translated(sheet, {0.013, 0.017, gap})});
}

constexpr int middle = 12;  // of the lower sheet
constexpr int beside = 13;
constexpr int of_sheet = 25;  // vertices

/// Whether the edge may collapse to x; the same whether its star is known to be a disk or not.
bool may_collapse(const WorkingMesh& mesh, const CrossingGuard& guard, Edge edge, const Vector3& x,
                  CrossingGuard::Star& star) {
  EdgeNeighborhood around;
  around.gather(mesh.connectivity, edge);
  std::vector<FacePlane> after;
  for (int f : around.star())
    after.push_back(face_plane(triangle_after(mesh, f, around.edge(), x)));
  const bool allows = guard.allows(around, x, after, false, star);
  EXPECT_EQ(guard.allows(around, x, after, true, star), allows);
  return allows;
}

/// Whether the edge in the middle of a sheet, from this vertex on, may collapse to so far from
/// where it is.
bool may_go(const WorkingMesh& mesh, const CrossingGuard& guard, int from, const Vector3& step,
            CrossingGuard::Star& star) {
  return may_collapse(mesh, guard, {from, from + (beside - middle)}, mesh.position[from] + step,
                      star);
}

/// Whether the edge in the middle of a sheet, from this vertex on, may collapse to so much above
/// where it is.
bool may_rise(const WorkingMesh& mesh, const CrossingGuard& guard, int from, double height,
              CrossingGuard::Star& star) {
  return may_go(mesh, guard, from, height * Vector3::UnitZ(), star);
}

bool may_become(const CrossingGuard& guard, int f, const Triangle& triangle) {
  CrossingGuard::Star star;
  star.add(f, triangle);
  return guard.allows(star);
}

TEST(CrossingGuard, RefusesAStarThatReachesAnotherSheet) {
  const WorkingMesh mesh = working_mesh(sheets());
  const CrossingGuard guard(mesh, one_thread);
  CrossingGuard::Star star;
  EXPECT_TRUE(may_rise(mesh, guard, middle, 0.9 * gap, star));
  EXPECT_FALSE(may_rise(mesh, guard, middle, 1.1 * gap, star));
  EXPECT_TRUE(may_rise(mesh, guard, middle, -1.1 * gap, star));
  EXPECT_TRUE(may_rise(mesh, guard, of_sheet + middle, 1.1 * gap, star));
  EXPECT_FALSE(may_rise(mesh, guard, of_sheet + middle, -1.1 * gap, star));
}

TEST(CrossingGuard, FollowsAndForgetsWhatIsGone) {
  WorkingMesh mesh = working_mesh(sheets());
  CrossingGuard guard(mesh, one_thread);
  CrossingGuard::Star star;
  for (int v = of_sheet; v < 2 * of_sheet; ++v) mesh.position[v].z() = -gap;
  for (int v = of_sheet; v < 2 * of_sheet; ++v) guard.update_around(v);
  EXPECT_TRUE(may_rise(mesh, guard, middle, 1.1 * gap, star));
  EXPECT_FALSE(may_rise(mesh, guard, middle, -1.1 * gap, star));
  for (int f = mesh.connectivity.face_slots() / 2; f < mesh.connectivity.face_slots(); ++f)
    mesh.connectivity.count(mesh.connectivity.remove_face(f));
  EXPECT_TRUE(may_rise(mesh, guard, middle, -1.1 * gap, star));
}

TEST(CrossingGuard, LetsGoOnCrossingWhatCrosses) {
  WorkingMesh mesh = working_mesh(sheets());
  mesh.position[middle].z() += 1.1 * gap;
  const CrossingGuard guard(mesh, one_thread);
  const int f = *mesh.connectivity.faces_of(middle).begin();
  Triangle higher = mesh.triangle(f);
  higher[mesh.connectivity.corner(f, middle)].z() += 0.001 * gap;
  EXPECT_TRUE(may_become(guard, f, higher));
  Triangle wider = higher;  // and meets others, too
  wider[mesh.connectivity.corner(f, middle)].x() -= 0.1;
  EXPECT_FALSE(may_become(guard, f, wider));
}

TEST(CrossingGuard, RefusesAStarThatFoldsOntoItself) {
  const WorkingMesh mesh = working_mesh(scaled(plane_grid(4), 0.4));
  const CrossingGuard guard(mesh, one_thread);
  CrossingGuard::Star star;
  EXPECT_TRUE(may_go(mesh, guard, middle, Vector3(0.03, 0.0, 0.0), star));
  EXPECT_FALSE(may_go(mesh, guard, middle, Vector3(0.0, 0.25, 0.0), star));
}

/// There are no other faces that it could meet.
TEST(CrossingGuard, RefusesAStarThatTurnsOver) {
  const WorkingMesh mesh = working_mesh(
      {{{-0.1, 0.0, 0.0},
        {0.1, 0.0, 0.0},
        {0.0, 0.2, 0.0},
        {-0.3, 0.1, 0.0},
        {-0.3, -0.1, 0.0},
        {0.0, -0.2, 0.0},
        {0.3, -0.1, 0.0},
        {0.3, 0.1, 0.0}},
       {{0, 1, 2}, {1, 0, 5}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {1, 5, 6}, {1, 6, 7}, {1, 7, 2}}});
  const CrossingGuard guard(mesh, one_thread);
  CrossingGuard::Star star;
  EXPECT_TRUE(may_collapse(mesh, guard, {0, 1}, {0.05, 0.0, 0.0}, star));
  EXPECT_TRUE(may_collapse(mesh, guard, {0, 1}, {0.05, 0.0, 0.4}, star));
  EXPECT_FALSE(may_collapse(mesh, guard, {0, 1}, {0.4, 0.0, 0.0}, star));
}

TEST(CrossingGuard, RefusesAFaceThroughOthers) {
  WorkingMesh mesh = working_mesh(sheets());
  const int f = mesh.connectivity.face_slots() - 1;
  mesh.connectivity.count(mesh.connectivity.remove_face(f));
  const CrossingGuard guard(mesh, one_thread);
  const Vector3 p(0.2, 0.2, 0.5 * gap);
  EXPECT_TRUE(guard.allows_face(f, {p, p + Vector3(0.1, 0.0, 0.0), p + Vector3(0.0, 0.1, 0.0)}));
  EXPECT_FALSE(guard.allows_face(f, {p, p + Vector3(0.1, 0.0, gap), p + Vector3(0.0, 0.1, 0.0)}));
}

TEST(RoundCrossings, KeepTheFirstOfTwoThatMeetHalfWay) {
  const WorkingMesh mesh = working_mesh(sheets());
  const CrossingGuard guard(mesh, one_thread);
  RoundCrossings crossings;
  crossings.begin(5);
  CrossingGuard::Star star;
  ASSERT_TRUE(may_rise(mesh, guard, middle, 0.6 * gap, star));
  CrossingGuard::Star same = star;
  crossings.keep(1, star), crossings.keep(4, same);
  ASSERT_TRUE(may_rise(mesh, guard, of_sheet + middle, -0.6 * gap, star));
  crossings.keep(2, star);
  for (int threads : {1, 3}) {
    const Parallel parallel(threads);
    EXPECT_EQ(crossings.to_drop({1, 2}, guard, parallel), std::vector<int>{2});
    EXPECT_EQ(crossings.to_drop({2, 4}, guard, parallel), std::vector<int>{4});
    EXPECT_EQ(crossings.to_drop({2}, guard, parallel), std::vector<int>{});
  }
}

}  // namespace
}  // namespace curvdecim::test
