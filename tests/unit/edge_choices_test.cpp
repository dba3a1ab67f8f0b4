// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/collapse/edge_queue.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

namespace curvdecim::test {

using namespace detail;

namespace {

constexpr float smallest_float = 1.4e-45f;  // not 0, with one bit

// --- priority ------------------------------------------------------------------------------------

TEST(Priority, OrdersByCostThenByLength) {
  const Priority ascending[] = {
      {0.0, 0.0},     {0.0, 1e-9},    {0.0, 1.0},     {smallest_float, 0.0},
      {FLT_MIN, 1.0}, {1e-20, 0.0},   {1e-20, 0.5},   {0.9999999, 1.0},
      {1.0, 0.0},     {1.0, 1e-30},   {1.0000002, 0}, {1e30, 0.25},
      {FLT_MAX, 0.0}, {FLT_MAX, 1.0}, {HUGE_VAL, 0.0}};
  for (const Priority& a : ascending)
    for (const Priority& b : ascending) {
      EXPECT_EQ(a < b, &a < &b) << a.cost() << " and " << b.cost();
      EXPECT_EQ(a == b, &a == &b) << a.cost() << " and " << b.cost();
    }
}

TEST(Priority, OfNoEdgeComesLast) {
  EXPECT_TRUE(Priority(HUGE_VAL, HUGE_VAL) < Priority());
  EXPECT_FALSE(Priority() < Priority(HUGE_VAL, HUGE_VAL));
  EXPECT_TRUE(Priority() == Priority());
  EXPECT_FALSE(Priority() < Priority());
}

TEST(Priority, TakesCostsAsEqualThatAreOneFloat) {
  EXPECT_TRUE(Priority(1.0 + 1e-12, 0.5) == Priority(1.0, 0.5));
  EXPECT_TRUE(Priority(1.0 + 1e-12, 0.1) < Priority(1.0, 0.5));  // by length
  EXPECT_TRUE(Priority(1e-60, 0.5) == Priority(0.0, 0.5));
  EXPECT_TRUE(Priority(1e60, 0.5) == Priority(HUGE_VAL, 0.5));
  EXPECT_FALSE(Priority(1.0 + 1e-6, 0.5) == Priority(1.0, 0.5));
}

TEST(Priority, GivesTheCostBackAsAFloat) {
  for (float cost : {0.0f, smallest_float, FLT_MIN, 1e-20f, 0.1f, 1.0f, 3e8f, FLT_MAX})
    EXPECT_EQ(Priority(cost, 0.7).cost(), cost);
  EXPECT_EQ(Priority(0.1, 0.0).cost(), 0.1f);
}

// --- choice --------------------------------------------------------------------------------------

TEST(EdgeChoice, OfEqualPriorityGoesByTheLowerPartner) {
  const EdgeChoice low{{1.0, 0.5}, 3}, high{{1.0, 0.5}, 4}, cheap{{0.5, 0.5}, 9};
  EXPECT_TRUE(low < high);
  EXPECT_FALSE(high < low);
  EXPECT_FALSE(low < low);
  EXPECT_TRUE(cheap < low);
}

TEST(EdgeChoice, WithoutAnEdgeComesLast) {
  EXPECT_FALSE(EdgeChoice().exists());
  EXPECT_TRUE((EdgeChoice{{HUGE_VAL, HUGE_VAL}, 1} < EdgeChoice()));
}

// --- choices -------------------------------------------------------------------------------------

/// The choice of vertex 0 out of four, with the edge 0-2 of cost 2 and squared length 0.5.
EdgeChoices one_choice() {
  EdgeChoices choices(4);
  choices.set(0, {{2.0, 0.5}, 2});
  return choices;
}

TEST(EdgeChoices, AreNoneAtFirst) {
  const EdgeChoices choices(4);
  for (int v = 0; v < 4; ++v) {
    EXPECT_FALSE(choices.exists(v));
    EXPECT_FALSE(choices.of(v).exists());
    EXPECT_TRUE(choices.priority(v) == Priority());
  }
}

TEST(EdgeChoices, KeepWhatWasSetLast) {
  EdgeChoices choices = one_choice();
  EXPECT_TRUE(choices.exists(0));
  EXPECT_EQ(choices.of(0).partner, 2);
  EXPECT_TRUE(choices.priority(0) == Priority(2.0, 0.5));
  EXPECT_FALSE(choices.exists(1));
  choices.set(0, {{3.0, 0.5}, 3});  // costlier, and yet
  EXPECT_EQ(choices.of(0).partner, 3);
  choices.set(0, {});
  EXPECT_FALSE(choices.exists(0));
  EXPECT_TRUE(choices.priority(0) == Priority());
}

}  // namespace
}  // namespace curvdecim::test
