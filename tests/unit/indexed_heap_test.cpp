// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/queue/indexed_heap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace curvdecim::test {

using namespace detail;

namespace {

using Heap = IndexedHeap<double>;

std::vector<int> drained(Heap heap) {
  std::vector<int> order;
  for (; !heap.empty(); heap.remove(heap.top().index)) order.push_back(heap.top().index);
  return order;
}

TEST(IndexedHeap, IsEmptyAtFirst) {
  const Heap heap(3);
  EXPECT_TRUE(heap.empty());
  EXPECT_FALSE(heap.contains(2));
}

TEST(IndexedHeap, GivesTheSmallestKeyFirst) {
  Heap heap(4);
  heap.set(0, 3.0), heap.set(1, 1.0), heap.set(2, 4.0), heap.set(3, 2.0);
  EXPECT_EQ(drained(heap), (std::vector<int>{1, 3, 0, 2}));
}

TEST(IndexedHeap, BreaksTiesByIndexWhateverTheHistory) {
  Heap up(40), down(40);
  std::vector<int> expected;
  for (int i = 0; i < 40; ++i) up.set(i, 1.0), down.set(39 - i, 1.0), expected.push_back(i);
  EXPECT_EQ(drained(up), expected);
  EXPECT_EQ(drained(down), expected);
}

TEST(IndexedHeap, KnowsTheSecondKey) {
  std::mt19937 random(3);
  Heap heap(30);
  EXPECT_EQ(Heap(2).second_key(), Heap::Entry().key);
  heap.set(0, 7.0);
  EXPECT_EQ(heap.second_key(), Heap::Entry().key);
  std::multiset<double> keys{7.0};
  for (int i = 1; i < 30; ++i) {
    const double key = static_cast<double>(random() % 12);
    heap.set(i, key);
    keys.insert(key);
    EXPECT_EQ(heap.second_key(), *std::next(keys.begin()));
  }
}

TEST(IndexedHeap, ChangesAKeyInBothDirections) {
  Heap heap(3);
  heap.set(0, 1.0), heap.set(1, 2.0), heap.set(2, 3.0);
  heap.set(0, 9.0);
  EXPECT_EQ(heap.top().index, 1);
  heap.set(2, 0.5);
  EXPECT_EQ(heap.top().index, 2);
  EXPECT_EQ(heap.size(), 3u);
  EXPECT_EQ(heap.entry(0).key, 9.0);
}

TEST(IndexedHeap, RemovesFromTheMiddleAndIgnoresTheAbsent) {
  Heap heap(9);
  for (int i = 0; i < 9; ++i) heap.set(i, 9.0 - i);
  heap.remove(4), heap.remove(4), heap.remove(0);
  EXPECT_EQ(drained(heap), (std::vector<int>{8, 7, 6, 5, 3, 2, 1}));
}

TEST(IndexedHeap, AgreesWithASortedSet) {
  std::mt19937 random(7);
  Heap heap(50);
  std::map<int, double> keys;
  std::set<std::pair<double, int>> sorted;
  for (int step = 0; step < 5000; ++step) {
    const int index = static_cast<int>(random() % 50);
    if (keys.count(index)) sorted.erase({keys[index], index});
    keys.erase(index);
    if (random() % 3 == 0) {
      heap.remove(index);
    } else {
      const double key = static_cast<double>(random() % 20);
      heap.set(index, key);
      keys[index] = key;
      sorted.insert({key, index});
    }
    ASSERT_EQ(heap.size(), sorted.size());
    ASSERT_EQ(heap.empty() ? -1 : heap.top().index, sorted.empty() ? -1 : sorted.begin()->second)
        << "step " << step;
  }
}

}  // namespace
}  // namespace curvdecim::test
