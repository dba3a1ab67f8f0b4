// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/collapse/round_selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "support/mesh_group.h"
#include "support/working_mesh.h"
#include "vcg_ext/guard/link_condition.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// The shortest edge of every vertex that lives.
EdgeChoices shortest_edges(const WorkingMesh& mesh) {
  EdgeChoices choices(mesh.connectivity.vertex_slots());
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f)
    for (int i = 0; i < 3 && mesh.connectivity.alive(f); ++i) {
      const Face& face = mesh.connectivity.face(f);
      const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
      const double length2 = (mesh.position[a] - mesh.position[b]).squaredNorm();
      const EdgeChoice choice{{length2, length2}, b};
      if (!choices.exists(a) || choice < choices.of(a)) choices.set(a, choice);
    }
  return choices;
}

/// Both ends and all their neighbours.
std::set<int> neighborhood(const WorkingMesh& mesh, Edge edge) {
  std::set<int> vertices;
  for (int v : {edge.a, edge.b})
    for (int f : mesh.connectivity.faces_of(v))
      for (int u : mesh.connectivity.face(f)) vertices.insert(u);
  return vertices;
}

bool meets(const std::set<int>& vertices, const std::set<int>& others) {
  return std::any_of(vertices.begin(), vertices.end(), [&](int v) { return others.count(v) > 0; });
}

std::vector<std::pair<int, int>> pairs(const std::vector<Edge>& edges) {
  std::vector<std::pair<int, int>> result;
  for (Edge edge : edges) result.push_back({edge.a, edge.b});
  return result;
}

constexpr double share = 0.25;
const Parallel one_thread(1);

class RoundSelectionOn : public testing::TestWithParam<NamedShape> {
 protected:
  WorkingMesh mesh_ = working_mesh(GetParam().shape);
  EdgeChoices choices_ = shortest_edges(mesh_);
  RoundSelection selection_{mesh_.connectivity, choices_};
};

TEST_P(RoundSelectionOn, PicksEdgesThatLieApart) {
  selection_.begin(share, one_thread);
  for (int picks = 0; picks < 3; ++picks) {
    selection_.pick(one_thread);
    std::set<int> taken;
    for (Edge edge : selection_.edges()) {
      const std::set<int> around = neighborhood(mesh_, edge);
      EXPECT_FALSE(meets(around, taken)) << edge.a << '-' << edge.b;
      taken.insert(around.begin(), around.end());
    }
  }
}

TEST_P(RoundSelectionOn, PicksChoicesThatCostNoMoreThanTheLimit) {
  selection_.begin(share, one_thread);
  selection_.pick(one_thread);
  EXPECT_FALSE(selection_.edges().empty());
  for (Edge edge : selection_.edges()) {
    EXPECT_EQ(choices_.of(edge.a).partner, edge.b);
    EXPECT_FALSE(selection_.limit() < choices_.priority(edge.a));
  }
}

TEST_P(RoundSelectionOn, PassesOverOnlyWhatTouchesAPickOrIsDearer) {
  selection_.begin(share, one_thread);
  selection_.pick(one_thread);
  std::set<int> taken;
  for (Edge edge : selection_.edges()) taken.merge(neighborhood(mesh_, edge));
  for (int v = 0; v < mesh_.connectivity.vertex_slots(); ++v) {
    if (!choices_.exists(v) || selection_.limit() < choices_.priority(v)) continue;
    EXPECT_TRUE(meets(neighborhood(mesh_, {v, choices_.of(v).partner}), taken)) << v;
  }
}

TEST_P(RoundSelectionOn, PicksEveryCandidateOnce) {
  selection_.begin(share, one_thread);
  const int candidates = selection_.candidates();
  std::set<std::pair<int, int>> picked;
  while (selection_.candidates() > 0) {
    selection_.pick(one_thread);
    for (Edge edge : selection_.edges()) EXPECT_TRUE(picked.insert({edge.a, edge.b}).second);
  }
  EXPECT_EQ(static_cast<int>(picked.size()), candidates);
}

TEST_P(RoundSelectionOn, PicksNoEdgeOfAVertexMergedInTheRound) {
  selection_.begin(share, one_thread);
  std::set<int> merged;
  while (selection_.candidates() > 0) {
    selection_.pick(one_thread);
    for (Edge edge : selection_.edges()) {
      EXPECT_FALSE(meets({edge.a, edge.b}, merged)) << edge.a << '-' << edge.b;
      merged.insert({edge.a, edge.b});
      selection_.set_merged(edge);
    }
  }
  selection_.begin(share, one_thread);
  selection_.pick(one_thread);
  EXPECT_FALSE(selection_.edges().empty()) << "a new round";
}

TEST_P(RoundSelectionOn, PicksTheSameAgainOnAnyNumberOfThreads) {
  const Parallel three_threads(3);
  RoundSelection other(mesh_.connectivity, choices_);
  selection_.begin(share, one_thread), other.begin(share, three_threads);
  for (int picks = 0; picks < 3; ++picks) {
    selection_.pick(one_thread), other.pick(three_threads);
    EXPECT_EQ(pairs(other.edges()), pairs(selection_.edges()));
  }
}

TEST_P(RoundSelectionOn, PicksInTheOrderOfTheOwners) {
  selection_.begin(share, one_thread);
  selection_.pick(one_thread);
  const auto picked = pairs(selection_.edges());
  EXPECT_TRUE(std::is_sorted(picked.begin(), picked.end()));
}

TEST_P(RoundSelectionOn, PicksTheCheapestOfAll) {
  int cheapest = 0;
  for (int v = 0; v < mesh_.connectivity.vertex_slots(); ++v)
    if (choices_.priority(v) < choices_.priority(cheapest)) cheapest = v;
  selection_.begin(share, one_thread);
  selection_.pick(one_thread);
  const auto picked = pairs(selection_.edges());
  EXPECT_TRUE(std::binary_search(picked.begin(), picked.end(),
                                 std::pair(cheapest, choices_.of(cheapest).partner)));
}

std::vector<NamedShape> meshes() {
  std::vector<NamedShape> all = all_meshes();
  all.push_back({"large_plane", plane_grid(40)});  // so many of one cost that they are not sorted
  all.push_back({"many_blocks", plane_grid(120)});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Drawn, RoundSelectionOn, testing::ValuesIn(meshes()), name_of);

TEST(RoundSelection, LooksAtACheapestShareOfTheChoices) {
  for (int subdivisions : {3, 5})  // every second is a sample; every fortieth is
    for (double part : {0.25, 0.8}) {
      const WorkingMesh mesh = working_mesh(noisy_sphere(subdivisions, 0.01));
      const EdgeChoices choices = shortest_edges(mesh);
      RoundSelection selection(mesh.connectivity, choices);
      selection.begin(part, one_thread);
      int all = 0;
      for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v) all += choices.exists(v);
      EXPECT_NEAR(selection.candidates(), part * all, 0.05 * all);
    }
}

TEST(RoundSelection, PicksNothingWhereNothingIsChosen) {
  const WorkingMesh mesh = working_mesh(icosphere(2));
  EdgeChoices choices = shortest_edges(mesh);
  RoundSelection selection(mesh.connectivity, choices);
  selection.begin(share, one_thread);
  selection.pick(one_thread);
  ASSERT_FALSE(selection.edges().empty());
  choices = EdgeChoices(mesh.connectivity.vertex_slots());
  selection.begin(share, one_thread);
  EXPECT_EQ(selection.candidates(), 0);
  selection.pick(one_thread);
  EXPECT_TRUE(selection.edges().empty());
}

}  // namespace
}  // namespace curvdecim::test
