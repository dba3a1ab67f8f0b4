// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/parallel/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "vcg_ext/parallel/pieces.h"

namespace curvdecim::test {

using namespace detail;

namespace {

class ParallelWith : public testing::TestWithParam<int> {};

TEST_P(ParallelWith, VisitsEveryIndexOnce) {
  for (int count : {0, 1, 5, 100003}) {
    std::vector<std::atomic<int>> visits(count);
    Parallel(GetParam()).for_each(count, [&](int i) { ++visits[i]; });
    EXPECT_TRUE(std::all_of(visits.begin(), visits.end(), [](const auto& n) { return n == 1; }));
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, ParallelWith, testing::Values(0, 1, 2, 3, 64));

TEST(Parallel, UsesTheThreadsItIsGiven) {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  const Parallel parallel(4);
  std::atomic<int> together{0};
  parallel.for_ranges(
      4,
      [&](int, int, int) {  // none ends before all have begun
        {
          const std::lock_guard lock(mutex);
          threads.insert(std::this_thread::get_id());
        }
        for (++together; together < 4;) std::this_thread::yield();
      },
      Grain{1, 4});
  EXPECT_EQ(threads.size(), 4u);
}

TEST(Parallel, AsksBetweenBlocksOnTheCallingThread) {
  constexpr int count = 1000000;
  int asked = 0;
  std::atomic<int> visited{0};
  const auto caller = std::this_thread::get_id();
  const Parallel parallel(4, [&](int, const char*) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    return ++asked > 0;
  });
  parallel.for_each(count, [&](int) { ++visited; });
  EXPECT_EQ(visited, count);
  EXPECT_GT(asked, 1);
}

TEST(Parallel, EndsWhenItIsAskedTo) {
  std::atomic<int> visited{0};
  int asked = 0;
  const Parallel parallel(2, [&](int, const char*) { return ++asked < 2; });
  EXPECT_THROW(parallel.for_each(1000000, [&](int) { ++visited; }), CancelRequest);
  EXPECT_GT(visited, 0);
  EXPECT_LT(visited, 1000000);
}

TEST(Pieces, CoverAllOnceAndInOrder) {
  for (int threads : {1, 2, 3})
    for (int count : {0, 1, 5, 1000, 5000}) {
      const Parallel parallel(threads);
      const int pieces = pieces_of(count, parallel);
      std::vector<int> seen(count, 0), piece_of(count, 0);
      for_pieces(count, pieces, parallel, [&](int piece, int begin, int end) {
        for (int i = begin; i < end; ++i) ++seen[i], piece_of[i] = piece;
      });
      EXPECT_EQ(seen, std::vector<int>(count, 1));
      EXPECT_TRUE(std::is_sorted(piece_of.begin(), piece_of.end()));
    }
}

}  // namespace
}  // namespace curvdecim::test
