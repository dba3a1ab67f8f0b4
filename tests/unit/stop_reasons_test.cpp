// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/run/stop_reasons.h"

#include <gtest/gtest.h>

#include <string>

#include "support/plans.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// All that an edge collapse, and a vertex removal, may be refused for.
constexpr Rejection of_collapse[] = {Rejection::LinkCondition, Rejection::NormalFlip,
                                     Rejection::TriangleShape, Rejection::ErrorBound,
                                     Rejection::HubAtRest,     Rejection::Crossing};
constexpr Rejection of_removal[] = {Rejection::LinkCondition, Rejection::NormalFlip,
                                    Rejection::TriangleShape, Rejection::ErrorBound,
                                    Rejection::VertexClass,   Rejection::LoopSplit};

CollapseLimits keeping_topology() { return limits_of({}); }

bool has(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(StopReasons, AreAllInWords) {
  for (Rejection reason : of_collapse)
    EXPECT_STRNE(words_of(reason, keeping_topology()).because, "") << label_of(reason);
  for (Rejection reason : of_removal)
    EXPECT_STRNE(words_of(reason, RemovalPlan()).because, "") << label_of(reason);
}

TEST(StopReasons, AreNoIdentifiers) {
  Rejections all;
  all.count.fill(7);
  for (const std::string& told :
       {told_reasons(all, keeping_topology()), told_reasons(all, RemovalPlan())})
    EXPECT_FALSE(has(told, "_")) << told;
}

TEST(StopReasons, AreToldByFrequencyAndThreeAtMost) {
  Rejections rejected;
  rejected[Rejection::TriangleShape] = 5;
  rejected[Rejection::LoopSplit] = 40;
  rejected[Rejection::NormalFlip] = 300;
  rejected[Rejection::VertexClass] = 1;
  const std::string told = told_reasons(rejected, RemovalPlan());
  EXPECT_TRUE(has(told,
                  "300 steps were refused because a face would turn too far, 40 because no "
                  "line parts the loop around the vertex, 5 because"))
      << told;
  EXPECT_FALSE(has(told, "corner")) << told;
}

TEST(StopReasons, OfOneStepAreInTheSingular) {
  Rejections rejected;
  rejected[Rejection::NormalFlip] = 1;
  EXPECT_TRUE(has(told_reasons(rejected, keeping_topology()), "1 step was refused"));
}

TEST(StopReasons, AreNotToldWhereNothingWasRefused) {
  EXPECT_EQ(told_reasons(Rejections(), keeping_topology()), "");
}

TEST(StopReasons, TellWhatToChangeAboutTheFirst) {
  Rejections rejected;
  rejected[Rejection::LinkCondition] = 2;
  rejected[Rejection::ErrorBound] = 3;
  const std::string told = told_reasons(rejected, keeping_topology());
  EXPECT_TRUE(has(told, "raise Maximum error")) << told;
  EXPECT_FALSE(has(told, "Preserve topology")) << told;
}

/// A hub waits for what else was refused at it.
TEST(StopReasons, TellWhatToChangeAboutTheNextWhereTheFirstIsNoneOfTheUsers) {
  Rejections rejected;
  rejected[Rejection::HubAtRest] = 9;
  rejected[Rejection::NormalFlip] = 2;
  const std::string told = told_reasons(rejected, keeping_topology());
  EXPECT_TRUE(has(told, "9 steps were refused because a vertex of very many faces waits")) << told;
  EXPECT_TRUE(has(told, "switch off Preserve normal")) << told;
}

TEST(StopReasons, OfTheTopologyNameTheSwitchThatIsOn) {
  CollapseLimits limits = keeping_topology();
  EXPECT_TRUE(has(topology_advice(limits), "switch off Preserve topology"));
  EXPECT_FALSE(has(topology_advice(limits), "Maximum error"));
  limits.max_error = 0.1;
  EXPECT_TRUE(has(topology_advice(limits), "Maximum error keeps the topology"));
  EXPECT_TRUE(has(topology_advice(limits_of({}, true, true)), "is off already"));
}

TEST(StopReasons, AreThoseOfTheLastLook) {
  Tally tally;
  tally.rejected[Rejection::NormalFlip] = 100;
  tally.begin_look();
  tally.rejected[Rejection::LinkCondition] = 4;
  EXPECT_EQ(tally.last_look()[Rejection::NormalFlip], 0);
  EXPECT_EQ(tally.last_look()[Rejection::LinkCondition], 4);
}

TEST(StopReasons, OfABoundCountOnlyWhereThereIsATarget) {
  Tally tally;
  tally.stopped_by = StopReason::ErrorBound;
  StopCriterion stop;
  stop.faces = stop.staying = 10;
  EXPECT_FALSE(ended_above(stop, tally));
  stop.faces = 11;
  EXPECT_TRUE(ended_above(stop, tally));
  tally.stopped_by = StopReason::Target;
  EXPECT_FALSE(ended_above(stop, tally));
}

}  // namespace
}  // namespace curvdecim::test
