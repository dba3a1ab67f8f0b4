// SPDX-License-Identifier: GPL-3.0-or-later
// What the connectivity promises to collapses whose neighbourhoods share no vertex.
#include <gtest/gtest.h>

#include <set>

#include "support/mesh_group.h"
#include "support/working_mesh.h"
#include "vcg_ext/collapse/edge_queue.h"
#include "vcg_ext/collapse/round_selection.h"
#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::test {

using namespace detail;

namespace {

using Counts = std::pair<int, int>;

Counts counts(const Removed& removed) { return {removed.faces, removed.vertices}; }
Counts counts(const TriangleConnectivity& c) { return {c.face_count(), c.vertex_count()}; }

std::set<int> listed(const TriangleConnectivity& connectivity, int v) {
  const auto faces = connectivity.faces_of(v);
  return {faces.begin(), faces.end()};
}

std::set<int> with_corner(const TriangleConnectivity& connectivity, int v) {
  std::set<int> faces;
  for (int f = 0; f < connectivity.face_slots(); ++f)
    if (connectivity.face_has(f, v)) faces.insert(f);
  return faces;
}

Counts removed_by_collapse(const Shape& shape, int keep, int gone) {
  TriangleConnectivity connectivity = connectivity_of(shape);
  return counts(connectivity.collapse(keep, gone));
}

TEST(Removed, SaysWhatACollapseTookAway) {
  EXPECT_EQ(removed_by_collapse(octahedron(), 0, 2), Counts(2, 1));
  EXPECT_EQ(removed_by_collapse(plane_grid(4), 1, 2), Counts(1, 1));  // along the boundary
  EXPECT_EQ(removed_by_collapse(one_triangle(), 0, 1), Counts(1, 3));
  EXPECT_EQ(removed_by_collapse(two_triangles(), 0, 1), Counts(1, 1));
  EXPECT_EQ(removed_by_collapse(two_triangles(), 0, 2), Counts(2, 4));
}

TEST(Removed, AddsUp) {
  Removed all{1, 2};
  all += {10, 20};
  EXPECT_EQ(counts(all), Counts(11, 22));
}

TEST(TriangleConnectivity, ChangesItsCountsOnlyWhenItIsTold) {
  TriangleConnectivity ball = connectivity_of(octahedron());
  const Removed removed = ball.collapse(0, 2);
  EXPECT_EQ(counts(ball), Counts(8, 6));
  ball.count(removed);
  EXPECT_EQ(counts(ball), Counts(6, 5));
}

class ApartCollapsesOn : public testing::TestWithParam<NamedShape> {
 protected:
  void SetUp() override {
    EdgeChoices choices(connectivity_.vertex_slots());
    for (int f = 0; f < connectivity_.face_slots(); ++f)
      for (int i = 0; i < 3; ++i) {
        const auto [a, b] =
            std::minmax(connectivity_.face(f)[i], connectivity_.face(f)[(i + 1) % 3]);
        if (!choices.exists(a) || b < choices.of(a).partner) choices.set(a, {{0.0, 0.0}, b});
      }
    RoundSelection selection(connectivity_, choices);
    const Parallel one_thread(1);
    selection.begin(0.25, one_thread), selection.pick(one_thread);
    edges_ = selection.edges();
  }

  /// Where each vertex's list is in memory.
  std::vector<const int*> places() const {
    std::vector<const int*> all;
    for (int v = 0; v < connectivity_.vertex_slots(); ++v)
      all.push_back(connectivity_.faces_of(v).first);
    return all;
  }

  TriangleConnectivity connectivity_ = connectivity_of(GetParam().shape);
  std::vector<Edge> edges_;
};

TEST_P(ApartCollapsesOn, MoveNoListButTheirOwnOnceRoomIsMade) {
  for (Edge edge : edges_)
    connectivity_.make_room(edge.a, edge.b, connectivity_.edge_valence(edge.a, edge.b));
  std::vector<const int*> expected = places();
  for (Edge edge : edges_) {
    connectivity_.collapse(edge.a, edge.b);
    if (places()[edge.a] != expected[edge.a])  // the other list was roomier
      std::swap(expected[edge.a], expected[edge.b]);
  }
  EXPECT_EQ(places(), expected);
}

TEST_P(ApartCollapsesOn, GiveTheSameAtTheSameTimeAsInTurn) {
  ASSERT_GT(edges_.size(), 1u);
  TriangleConnectivity in_turn = connectivity_;
  for (Edge edge : edges_) in_turn.count(in_turn.collapse(edge.a, edge.b));
  for (Edge edge : edges_)
    connectivity_.make_room(edge.a, edge.b, connectivity_.edge_valence(edge.a, edge.b));
  std::vector<Removed> removed(edges_.size());
  Parallel(3).for_each(
      static_cast<int>(edges_.size()),
      [&](int i) { removed[i] = connectivity_.collapse(edges_[i].a, edges_[i].b); }, Grain{1, 64});
  for (const Removed& one : removed) connectivity_.count(one);
  EXPECT_EQ(counts(connectivity_), counts(in_turn));
  for (int f = 0; f < connectivity_.face_slots(); ++f)
    EXPECT_EQ(connectivity_.face(f), in_turn.face(f));
  for (int v = 0; v < connectivity_.vertex_slots(); ++v)
    EXPECT_EQ(listed(connectivity_, v), with_corner(in_turn, v)) << v;
}

INSTANTIATE_TEST_SUITE_P(Drawn, ApartCollapsesOn,
                         testing::Values(NamedShape{"icosphere", icosphere(2)},
                                         NamedShape{"torus", torus(24, 12)},
                                         NamedShape{"plane_grid", plane_grid(12)},
                                         NamedShape{"three_pages", book(3, 8)}),
                         name_of);

}  // namespace
}  // namespace curvdecim::test
