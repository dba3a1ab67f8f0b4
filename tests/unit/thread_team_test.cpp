// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/parallel/thread_team.h"

#include <gtest/gtest.h>

#include <chrono>
#include <numeric>
#include <stdexcept>

namespace curvdecim::test {

using namespace detail;

namespace {

class ThreadTeamOf : public testing::TestWithParam<int> {};

TEST_P(ThreadTeamOf, RunsEveryWorkerOnceAJob) {
  ThreadTeam team(GetParam());
  std::vector<std::atomic<int>> runs(GetParam());
  for (int job = 1; job <= 3; ++job) {
    team.run([&](int worker) { ++runs.at(worker); });
    for (const auto& count : runs) EXPECT_EQ(count, job);
  }
}

TEST_P(ThreadTeamOf, HandsOnWhatEveryJobWrote) {
  ThreadTeam team(GetParam());
  std::vector<int> of_worker(GetParam(), 0);
  int total = 0;
  for (int job = 1; job <= 1000; ++job) {
    team.run([&](int worker) { of_worker[worker] = total + 1; });
    total = std::accumulate(of_worker.begin(), of_worker.end(), 0) / GetParam();
    ASSERT_EQ(total, job);
  }
}

TEST_P(ThreadTeamOf, RunsWorkerZeroOnTheCallingThreadAndTheOthersElsewhere) {
  ThreadTeam team(GetParam());
  std::vector<std::thread::id> threads(GetParam());
  team.run([&](int worker) { threads[worker] = std::this_thread::get_id(); });
  for (int worker = 0; worker < GetParam(); ++worker)
    EXPECT_EQ(threads[worker] == std::this_thread::get_id(), worker == 0);
}

TEST_P(ThreadTeamOf, PassesOnWhatAWorkerThrewOnceAllAreDone) {
  ThreadTeam team(GetParam());
  for (int thrower = 0; thrower < GetParam(); ++thrower) {
    std::atomic<int> runs{0};
    const auto job = [&](int worker) {
      ++runs;
      if (worker == thrower) throw std::out_of_range("worker " + std::to_string(worker));
    };
    try {
      team.run(job);
      FAIL() << "worker " << thrower << " threw";
    } catch (const std::out_of_range& error) {
      EXPECT_EQ(error.what(), "worker " + std::to_string(thrower));
    }
    EXPECT_EQ(runs, GetParam());
  }
}

TEST_P(ThreadTeamOf, WorksOnAfterAnException) {
  ThreadTeam team(GetParam());
  EXPECT_THROW(team.run([](int) { throw std::runtime_error("all of them"); }), std::runtime_error);
  std::atomic<int> runs{0};
  EXPECT_NO_THROW(team.run([&](int) { ++runs; }));
  EXPECT_EQ(runs, GetParam());
}

TEST_P(ThreadTeamOf, EndsWithoutAJob) { EXPECT_EQ(ThreadTeam(GetParam()).size(), GetParam()); }

/// After so long a wait every thread has gone to sleep.
TEST_P(ThreadTeamOf, WakesForAJobAfterAPause) {
  constexpr auto pause = std::chrono::milliseconds(5);
  ThreadTeam team(GetParam());
  std::atomic<int> runs{0};
  for (int job = 1; job <= 4; ++job) {
    std::this_thread::sleep_for(pause);
    team.run([&](int worker) {
      if (worker == GetParam() - 1) std::this_thread::sleep_for(pause);  // the others wait for it
      ++runs;
    });
    EXPECT_EQ(runs, job * GetParam());
  }
}

INSTANTIATE_TEST_SUITE_P(Size, ThreadTeamOf, testing::Values(1, 2, 3, 16));

}  // namespace
}  // namespace curvdecim::test
