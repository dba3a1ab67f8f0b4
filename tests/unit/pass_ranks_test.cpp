// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/passes/pass_ranks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/pass_surfaces.h"

namespace curvdecim::test {

using namespace detail;

namespace {

class Ranks : public testing::Test {
 protected:
  explicit Ranks() { ranks_.measure(grid_, fans_of(grid_), one_thread); }

  std::vector<int> proposers() const {
    std::vector<int> left;
    for (int v = 0; v < ranks_.count(); ++v)
      if (ranks_.partner(v) != PassRanks::none) left.push_back(v);
    return left;
  }

  PassSurface grid_ = surface_of(plane_grid(20));  // with edges that cost alike
  PassRanks ranks_;
};

TEST_F(Ranks, AreOfTheNeighbourThatIsNearestToThePlanes) {
  PassSurface tent = surface_of(plane_grid(6));
  for (Vector3& p : tent.position) p.z() = 0.3 * std::abs(p.x());
  PassRanks ranks;
  ranks.measure(tent, fans_of(tent), one_thread);
  const int on_ridge = 24;  // in the middle
  ASSERT_NE(ranks.partner(on_ridge), PassRanks::none);
  EXPECT_EQ(tent.position[ranks.partner(on_ridge)].x(), tent.position[on_ridge].x());
}

TEST_F(Ranks, ChooseNoMoreThanIsWantedAlsoOfWhatCostsTheSame) {
  const std::vector<int> all = proposers();
  const float limit = ranks_.choose(50, 1.0);
  const std::vector<int> chosen = proposers();
  EXPECT_EQ(chosen.size(), 50u);
  for (int v : chosen) EXPECT_LE(ranks_.rank(v), limit);
  EXPECT_LT(chosen.front(), all[all.size() / 4]) << "they are spread over the mesh";
  EXPECT_GT(chosen.back(), all[3 * all.size() / 4]);
}

TEST_F(Ranks, ChooseAShare) {
  const std::size_t all = proposers().size();
  ranks_.choose(1 << 20, 0.5);
  EXPECT_EQ(proposers().size(), all / 2);
}

TEST_F(Ranks, TellHowFarAnEdgeReaches) {
  for (int v : proposers()) {
    const int bits = ranks_.reach(v);
    const FanLists fans = fans_of(grid_);
    int differences = 0;
    for (int end : {v, ranks_.partner(v)})
      for (int f : fans.of(end)) differences |= next_in(grid_.faces[f], end) ^ v;
    EXPECT_EQ(differences >> bits, 0);
  }
}

}  // namespace
}  // namespace curvdecim::test
