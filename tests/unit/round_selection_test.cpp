// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/queue/round_selection.h"

#include <gtest/gtest.h>

#include <set>

#include "support/mesh_group.h"
#include "support/working_mesh.h"
#include "vcg_ext/guard/link_condition.h"

namespace curvdecim::test {
namespace {

/// The shortest edge of every vertex that lives.
EdgeChoices shortest_edges(const WorkingMesh& mesh) {
  EdgeChoices choices(mesh.connectivity.vertex_slots());
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f)
    for (int i = 0; i < 3 && mesh.connectivity.alive(f); ++i) {
      const Face& face = mesh.connectivity.face(f);
      const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
      const double length2 = (mesh.position[a] - mesh.position[b]).squaredNorm();
      choices.offer(a, {{length2, length2}, b});
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

class RoundSelectionOn : public testing::TestWithParam<NamedShape> {
 protected:
  WorkingMesh mesh_ = working_mesh(GetParam().shape);
  EdgeChoices choices_ = shortest_edges(mesh_);
  RoundSelection selection_{mesh_.connectivity};
};

TEST_P(RoundSelectionOn, PicksEdgesThatLieApart) {
  selection_.pick(choices_);
  std::set<int> taken;
  for (Edge edge : selection_.edges()) {
    const std::set<int> around = neighborhood(mesh_, edge);
    EXPECT_FALSE(meets(around, taken)) << edge.a << '-' << edge.b;
    taken.insert(around.begin(), around.end());
  }
}

TEST_P(RoundSelectionOn, PicksChoicesThatCostNoMoreThanTheLimit) {
  selection_.pick(choices_);
  EXPECT_FALSE(selection_.edges().empty());
  for (Edge edge : selection_.edges()) {
    EXPECT_EQ(choices_.of(edge.a).partner, edge.b);
    EXPECT_FALSE(selection_.limit() < choices_.priority(edge.a));
  }
}

TEST_P(RoundSelectionOn, PassesOverOnlyWhatTouchesAPickOrIsDearer) {
  selection_.pick(choices_);
  std::set<int> taken;
  for (Edge edge : selection_.edges()) taken.merge(neighborhood(mesh_, edge));
  for (int v = 0; v < mesh_.connectivity.vertex_slots(); ++v) {
    if (!choices_.exists(v) || selection_.limit() < choices_.priority(v)) continue;
    EXPECT_TRUE(meets(neighborhood(mesh_, {v, choices_.of(v).partner}), taken)) << v;
  }
}

TEST_P(RoundSelectionOn, FindsNothingOutdatedWhereAllEdgesExist) {
  selection_.pick(choices_);
  EXPECT_TRUE(selection_.outdated().empty());
}

TEST_P(RoundSelectionOn, PicksTheSameAgain) {
  RoundSelection other(mesh_.connectivity);
  selection_.pick(choices_), other.pick(choices_);
  const auto once = pairs(selection_.edges());
  EXPECT_EQ(pairs(other.edges()), once);
  selection_.pick(choices_);
  EXPECT_EQ(pairs(selection_.edges()), once);
}

TEST_P(RoundSelectionOn, PicksTheCheapestOfAllFirst) {
  int cheapest = 0;
  for (int v = 0; v < mesh_.connectivity.vertex_slots(); ++v)
    if (choices_.priority(v) < choices_.priority(cheapest)) cheapest = v;
  selection_.pick(choices_);
  EXPECT_EQ(selection_.edges().at(0).a, cheapest);
}

std::vector<NamedShape> meshes() {
  std::vector<NamedShape> all = all_meshes();
  all.push_back({"large_plane", plane_grid(40)});  // so many of one cost that they are not sorted
  return all;
}

INSTANTIATE_TEST_SUITE_P(Drawn, RoundSelectionOn, testing::ValuesIn(meshes()), name_of);

TEST(RoundSelection, LooksAtACheapestShareOfTheChoices) {
  for (int subdivisions : {3, 5}) {  // every second is a sample; every fortieth is
    const WorkingMesh mesh = working_mesh(noisy_sphere(subdivisions, 0.01));
    const EdgeChoices choices = shortest_edges(mesh);
    RoundSelection selection(mesh.connectivity);
    selection.pick(choices);
    int all = 0;
    for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v) all += choices.exists(v);
    EXPECT_NEAR(selection.candidates(), 0.25 * all, 0.03 * all);
    EXPECT_LT(selection.edges().size(), static_cast<std::size_t>(selection.candidates()));
  }
}

TEST(RoundSelection, PicksNothingWhereNothingIsChosen) {
  const WorkingMesh mesh = working_mesh(icosphere(2));
  RoundSelection selection(mesh.connectivity);
  selection.pick(shortest_edges(mesh));
  ASSERT_FALSE(selection.edges().empty());
  selection.pick(EdgeChoices(mesh.connectivity.vertex_slots()));
  EXPECT_TRUE(selection.edges().empty());
  EXPECT_TRUE(selection.outdated().empty());
  EXPECT_EQ(selection.candidates(), 0);
}

TEST(RoundSelection, TellsWhoChoseAnEdgeThatIsGone) {
  const WorkingMesh mesh = working_mesh(icosphere(2));
  constexpr Edge gone{0, 5};  // of the icosahedron, divided since
  ASSERT_FALSE(mesh.connectivity.has_edge(gone.a, gone.b));
  EdgeChoices choices = shortest_edges(mesh);
  choices.set(gone.a, {{0.0, 0.0}, gone.b});
  RoundSelection selection(mesh.connectivity);
  selection.pick(choices);
  EXPECT_EQ(selection.outdated(), std::vector<int>{gone.a});
  EXPECT_FALSE(selection.edges().empty());
  for (Edge edge : selection.edges()) EXPECT_NE(edge.a, gone.a);
  choices.remove(gone.a);
  selection.pick(choices);
  EXPECT_TRUE(selection.outdated().empty());
}

/// Collapses what the selection picks and the link condition allows.
void collapse_picked(WorkingMesh& mesh, const RoundSelection& selection) {
  EdgeNeighborhood around;
  for (Edge edge : selection.edges()) {
    around.gather(mesh.connectivity, edge);
    if (satisfies_link_condition(mesh, around))
      mesh.connectivity.count(mesh.connectivity.collapse(edge.a, edge.b));
  }
}

TEST(RoundSelection, NeverPicksTheDead) {
  WorkingMesh mesh = working_mesh(icosphere(3));
  const int start = mesh.connectivity.vertex_count();
  RoundSelection selection(mesh.connectivity);
  for (int round = 0; round < 100; ++round) {
    EdgeChoices choices = shortest_edges(mesh);
    for (int v = 0; v < start; ++v)  // the dead keep a choice that looks good
      if (mesh.connectivity.faces_of(v).size() == 0) choices.set(v, {{0.0, 0.0}, start - 1});
    selection.pick(choices);
    for (Edge edge : selection.edges())
      ASSERT_TRUE(mesh.connectivity.has_edge(edge.a, edge.b)) << edge.a << '-' << edge.b;
    for (int v : selection.outdated()) choices.remove(v);
    selection.pick(choices);
    ASSERT_FALSE(selection.edges().empty());
    collapse_picked(mesh, selection);
  }
  EXPECT_LT(mesh.connectivity.vertex_count(), start / 4);
}

}  // namespace
}  // namespace curvdecim::test
