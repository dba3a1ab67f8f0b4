// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/collapse/edge_queue.h"

#include <gtest/gtest.h>

namespace curvdecim::test {

using namespace detail;

namespace {

TEST(EdgeQueue, GivesTheCheapestEdgeOfAllVertices) {
  EdgeQueue queue(6);
  queue.set(0, {{2.0, 0.0}, 3}), queue.set(1, {{1.0, 0.0}, 5});
  EXPECT_EQ(queue.top().a, 1);
  EXPECT_EQ(queue.top().b, 5);
  EXPECT_EQ(queue.top_priority().cost(), 1.0);
  EXPECT_EQ(queue.second_priority().cost(), 2.0);
}

TEST(EdgeQueue, KeepsOneEdgeAVertex) {
  EdgeQueue queue(6);
  queue.set(0, {{1.0, 0.0}, 3}), queue.set(0, {{2.0, 0.0}, 4});
  EXPECT_EQ(queue.top().b, 4);
  queue.remove(0);
  EXPECT_TRUE(queue.empty());
}

TEST(EdgeQueue, TakesAnOfferOnlyIfItIsCheaper) {
  EdgeQueue queue(6);
  queue.set(0, {{2.0, 0.0}, 3});
  queue.offer(0, {{3.0, 0.0}, 4});
  EXPECT_EQ(queue.of(0).partner, 3);
  queue.offer(0, {{1.0, 0.0}, 4});
  EXPECT_EQ(queue.of(0).partner, 4);
}

TEST(EdgeQueue, TakesTheLowerPartnerAtEqualCost) {
  EdgeQueue queue(6);
  queue.set(0, {{2.0, 0.0}, 3});
  queue.offer(0, {{2.0, 0.0}, 4});
  EXPECT_EQ(queue.of(0).partner, 3);
  queue.offer(0, {{2.0, 0.0}, 2});
  EXPECT_EQ(queue.of(0).partner, 2);
}

TEST(EdgeQueue, PrefersTheShorterEdgeAtEqualCost) {
  EdgeQueue queue(6);
  queue.set(0, {{2.0, 0.5}, 3});
  queue.offer(0, {{2.0, 0.1}, 4});
  EXPECT_EQ(queue.of(0).partner, 4);
  queue.set(1, {{2.0, 0.01}, 5});
  EXPECT_EQ(queue.top().a, 1);
}

TEST(EdgeQueue, KnowsNoPartnerOfAVertexWithoutAnEdge) {
  EdgeQueue queue(6);
  EXPECT_EQ(queue.of(0).partner, EdgeChoice::none);
  queue.set(0, {{2.0, 0.0}, 3});
  queue.remove(0);
  EXPECT_EQ(queue.of(0).partner, EdgeChoice::none);
}

}  // namespace
}  // namespace curvdecim::test
