// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <thread>

namespace curvdecim::test {
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
  Parallel(4).for_each(100000, [&](int) {
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(threads.size(), 4u);
}

}  // namespace
}  // namespace curvdecim::test
