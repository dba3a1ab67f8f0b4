// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/guard/collapse_guards.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/drawn_meshes.h"
#include "support/plans.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// About an edge of the rim of two cones of three faces. Merged, it would leave their other faces
/// back to back.
GuardAnswer answer_at_a_rim(bool gives_way, bool keeps_normal) {
  const WorkingMesh mesh = working_mesh(double_cone(3));
  EdgeNeighborhood around;
  around.gather(mesh.connectivity, {1, 2});
  DecimationParams params;
  params.preserve_normal = keeps_normal;
  std::vector<FacePlane> after;
  const CollapseGuards guards(mesh, limits_of(params, true, gives_way));
  return guards.ask(around, 0.5 * (mesh.position[1] + mesh.position[2]), after);
}

TEST(CollapseGuards, LetANeckBeCutThoughItsCollapseWouldFoldFaces) {
  for (bool keeps_normal : {true, false}) {
    const GuardAnswer answer = answer_at_a_rim(true, keeps_normal);
    EXPECT_FALSE(answer.refusal);
    EXPECT_EQ(answer.obstacle.kind, Obstacle::Kind::Loop);
    EXPECT_GT(answer.price, 0.0);
  }
}

TEST(CollapseGuards, RefuseToCollapseANeckWhereTheTopologyStays) {
  EXPECT_EQ(answer_at_a_rim(false, true).refusal, Rejection::LinkCondition);
}

}  // namespace
}  // namespace curvdecim::test
