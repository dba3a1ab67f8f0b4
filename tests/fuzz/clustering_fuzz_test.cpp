// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex clustering of tiny triangle soups, with random parameters.
#include <gtest/gtest.h>

#include "support/clustering.h"
#include "support/properties.h"
#include "support/soups.h"

namespace curvdecim::test {
namespace {

ClusteringParams random_params(Dice& dice) {
  ClusteringParams params = dice.coin() ? to_clusters(1 + dice.below(12))
                                        : with_cells(dice.any({0.01, 0.7, 1.1, 2.0, 4.0, 9.0}));
  const std::vector<NamedRepresentative> all = shape_representatives();
  params = all[dice.below(static_cast<int>(all.size()))].of(params);
  params.boundary_weight = dice.any({0.0, 1.0, 1e6});
  params.manifold_edges = dice.coin();
  params.threads = dice.any({1, 2});
  return params;
}

void expect_sound(const ClusteringParams& params, const Shape& before, const Clustered& done) {
  const auto& [after, report] = done;
  expect_sound_clusters(after);
  EXPECT_EQ(after.face_count() + report.degenerate + report.duplicate + report.crowded,
            before.face_count());
  EXPECT_LE(report.largest_move, report.cell_size);
  EXPECT_TRUE(!params.manifold_edges || topology(after).nonmanifold_edges == 0);
}

class ClusteringFuzz : public testing::TestWithParam<Family> {};

TEST_P(ClusteringFuzz, LeavesASoundMeshOrTheInput) {
  constexpr int cases = 2500;
  int refused = 0, small_enough = 0;
  for (unsigned seed = 0; seed < cases && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    const Shape input = GetParam().draw(dice);
    const ClusteringParams params = random_params(dice);
    try {
      const Clustered done = clustered(input, params);
      if (done.report.cell_size > 0.0) {
        expect_sound(params, input, done);
        continue;
      }
      EXPECT_EQ(done.shape, input);
      ++small_enough;
    } catch (const InputError&) {
      ++refused;  // all is one cell
    }
  }
  EXPECT_LT(refused + small_enough, cases / 2);
}

INSTANTIATE_TEST_SUITE_P(Random, ClusteringFuzz, testing::ValuesIn(families()), family_name);

}  // namespace
}  // namespace curvdecim::test
