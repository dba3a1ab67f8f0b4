// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/queue/edge_queue.h"

#include <gtest/gtest.h>

namespace curvdecim::test {
namespace {

TEST(EdgeQueue, GivesTheCheapestEdgeOfAllVertices) {
  EdgeQueue queue(6);
  queue.set({0, 3}, {2.0}), queue.set({1, 5}, {1.0});
  EXPECT_EQ(queue.top().a, 1);
  EXPECT_EQ(queue.top().b, 5);
  EXPECT_EQ(queue.top_cost(), 1.0);
  EXPECT_EQ(queue.second_cost(), 2.0);
}

TEST(EdgeQueue, KeepsOneEdgeAVertex) {
  EdgeQueue queue(6);
  queue.set({0, 3}, {1.0}), queue.set({0, 4}, {2.0});
  EXPECT_EQ(queue.top().b, 4);
  queue.remove(0);
  EXPECT_TRUE(queue.empty());
}

TEST(EdgeQueue, TakesAnOfferOnlyIfItIsCheaper) {
  EdgeQueue queue(6);
  queue.set({0, 3}, {2.0});
  queue.offer({0, 4}, {3.0});
  EXPECT_EQ(queue.partner(0), 3);
  queue.offer({0, 4}, {1.0});
  EXPECT_EQ(queue.partner(0), 4);
}

TEST(EdgeQueue, TakesTheLowerPartnerAtEqualCost) {
  EdgeQueue queue(6);
  queue.set({0, 3}, {2.0});
  queue.offer({0, 4}, {2.0});
  EXPECT_EQ(queue.partner(0), 3);
  queue.offer({0, 2}, {2.0});
  EXPECT_EQ(queue.partner(0), 2);
}

TEST(EdgeQueue, PrefersTheShorterEdgeAtEqualCost) {
  EdgeQueue queue(6);
  queue.set({0, 3}, {2.0, 0.5f});
  queue.offer({0, 4}, {2.0, 0.1f});
  EXPECT_EQ(queue.partner(0), 4);
  queue.set({1, 5}, {2.0, 0.01f});
  EXPECT_EQ(queue.top().a, 1);
}

TEST(EdgeQueue, KnowsNoPartnerOfAVertexWithoutAnEdge) {
  EdgeQueue queue(6);
  EXPECT_EQ(queue.partner(0), EdgeQueue::none);
  queue.set({0, 3}, {2.0});
  queue.remove(0);
  EXPECT_EQ(queue.partner(0), EdgeQueue::none);
}

}  // namespace
}  // namespace curvdecim::test
