// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/guard/collapse_rule.h"

#include <gtest/gtest.h>

#include "support/plans.h"

namespace curvdecim::test {

using namespace detail;

namespace {

using Answer = std::optional<Allowed>;
using K = VertexKind;
const Answer stays = std::nullopt;

/// For an edge 0-1 between vertices of these kinds.
Answer answer(K a, K b, const DecimationParams& params = {}, bool lock_a = false,
              bool lock_b = false, bool keeps_links = true) {
  WorkingMesh mesh;
  mesh.kind = {a, b};
  mesh.locked = {lock_a, lock_b};
  return CollapseRule(mesh, limits_of(params, keeps_links))({0, 1});
}

TEST(CollapseRule, IsTheTableInTheHeader) {
  EXPECT_EQ(answer(K::Interior, K::Interior), Allowed::Anywhere);
  EXPECT_EQ(answer(K::Interior, K::Boundary), Allowed::OntoB);
  EXPECT_EQ(answer(K::Interior, K::Curve), Allowed::OntoB);
  EXPECT_EQ(answer(K::Interior, K::Junction), Allowed::OntoB);
  EXPECT_EQ(answer(K::Boundary, K::Boundary), Allowed::Anywhere);
  EXPECT_EQ(answer(K::Boundary, K::Curve), stays);
  EXPECT_EQ(answer(K::Boundary, K::Junction), Allowed::OntoB);
  EXPECT_EQ(answer(K::Curve, K::Curve), Allowed::Anywhere);
  EXPECT_EQ(answer(K::Curve, K::Junction), Allowed::OntoB);
  EXPECT_EQ(answer(K::Junction, K::Junction), stays);
}

TEST(CollapseRule, IsSymmetric) {
  const auto mirrored = [](Answer given) {
    return given == Allowed::OntoA   ? Allowed::OntoB
           : given == Allowed::OntoB ? Answer(Allowed::OntoA)
                                     : given;
  };
  for (K a : {K::Interior, K::Boundary, K::Curve, K::Junction})
    for (K b : {K::Interior, K::Boundary, K::Curve, K::Junction})
      EXPECT_EQ(answer(a, b), mirrored(answer(b, a)));
}

TEST(CollapseRule, LeavesALockedVertexWhereItIs) {
  EXPECT_EQ(answer(K::Interior, K::Interior, {}, true, false), Allowed::OntoA);
  EXPECT_EQ(answer(K::Interior, K::Interior, {}, false, true), Allowed::OntoB);
  EXPECT_EQ(answer(K::Interior, K::Interior, {}, true, true), stays);
  EXPECT_EQ(answer(K::Boundary, K::Interior, {}, false, true), stays);
}

TEST(CollapseRule, FreesTheBoundaryWhenItNeedNotBePreserved) {
  DecimationParams params;
  params.preserve_boundary = false;
  EXPECT_EQ(answer(K::Interior, K::Boundary, params), Allowed::Anywhere);
  EXPECT_EQ(answer(K::Interior, K::Curve, params), Allowed::OntoB);
}

TEST(CollapseRule, FreesAllButTheLockedWithoutTopology) {
  EXPECT_EQ(answer(K::Junction, K::Junction, {}, false, false, false), Allowed::Anywhere);
  EXPECT_EQ(answer(K::Boundary, K::Curve, {}, false, false, false), Allowed::Anywhere);
  EXPECT_EQ(answer(K::Interior, K::Interior, {}, true, true, false), stays);
}

TEST(CollapseRule, LetsSheetsPartWhereTheTopologyGivesWay) {
  WorkingMesh mesh;
  mesh.kind = {K::Junction, K::Junction, K::Boundary, K::Curve};
  mesh.locked = {0, 0, 0, 0};
  const CollapseRule rule(mesh, limits_of({}, true, true));
  EXPECT_EQ(rule({0, 1}), Allowed::Anywhere);
  EXPECT_EQ(rule.of_kinds({0, 1}), stays);
  EXPECT_EQ(rule({2, 3}), Allowed::Anywhere);
  EXPECT_EQ(rule({0, 3}), Allowed::OntoA);
  mesh.locked[1] = mesh.locked[2] = 1;
  EXPECT_EQ(rule({0, 1}), stays);
  EXPECT_EQ(rule({2, 3}), stays);
}

}  // namespace
}  // namespace curvdecim::test
