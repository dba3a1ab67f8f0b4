// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/parallel/progress_meter.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/parallel/timetable.h"

namespace curvdecim::test {

using namespace detail;

namespace {

using Shown = std::vector<std::pair<int, std::string>>;

class Bar : public testing::Test {
 protected:
  int percent() {
    meter_.ask();
    return shown_.back().first;
  }

  Shown shown_;
  ProgressMeter meter_{[this](int percent, const char* stage) {
    shown_.emplace_back(percent, stage);
    return true;
  }};
};

TEST_F(Bar, GivesEveryStageItsShareOfTheTime) {
  const Timetable times{100.0, 500.0, 300.0, 100.0};
  times.begin_preparing(meter_), meter_.set(1.0);
  EXPECT_EQ(percent(), 10);
  times.begin_steps("Steps", meter_), meter_.set(0.5);
  EXPECT_EQ(percent(), 35);
  EXPECT_EQ(shown_.back().second, "Steps");
  times.begin_refining(meter_);
  EXPECT_EQ(percent(), 35) << "the steps ended early: what is left is for the others";
  meter_.set(1.0);
  EXPECT_EQ(percent(), 83);
}

TEST_F(Bar, NeverGoesBack) {
  meter_.begin("One", 1.0, 1.0), meter_.set(0.8);
  const int before = percent();
  meter_.set(0.2);
  EXPECT_EQ(percent(), before);
  meter_.begin("Two", 1.0, 0.0), meter_.set(-1.0);
  EXPECT_EQ(percent(), before);
  meter_.set(2.0);
  EXPECT_EQ(percent(), 100);
}

TEST_F(Bar, IsMovedByLoopsAlongTheirStretchOnly) {
  meter_.begin("All", 1.0, 0.0);
  meter_.in_loop(1.0);
  EXPECT_EQ(shown_.back().first, 0) << "a loop without a stretch";
  meter_.along(0.2, 0.6, [&] {
    meter_.in_loop(0.5);
    EXPECT_EQ(shown_.back().first, 40);
    meter_.along(0.5, 1.0, [&] { meter_.in_loop(0.5); });
    EXPECT_EQ(shown_.back().first, 50) << "half of the second half of the stretch";
  });
  meter_.in_loop(1.0);
  EXPECT_EQ(shown_.back().first, 60) << "at the stretch's end, and again a loop without one";
}

TEST(Parallel, MovesTheBarFromBlockToBlock) {
  std::vector<int> percents;
  const Parallel parallel(2, [&](int percent, const char*) {
    percents.push_back(percent);
    return true;
  });
  parallel.progress().begin("All", 1.0, 0.0);
  const Grain quarter{1, 25};
  parallel.progress().along(0.0, 0.4, [&] {
    parallel.for_each(
        100, [](int) {}, quarter);
  });
  parallel.progress().along(0.4, 0.8, [&] {
    parallel.in_order(
        100, [](int) {}, quarter);
  });
  EXPECT_EQ(percents, (std::vector<int>{0, 10, 20, 30, 40, 50, 60, 70}));
}

TEST(Parallel, CountsInOrder) {
  std::vector<int> visited;
  Parallel(2).in_order(5, [&](int i) { visited.push_back(i); });
  EXPECT_EQ(visited, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(Parallel, IsCancelledInOrder) {
  int asked = 0, visited = 0;
  const Parallel parallel(1, [&](int, const char*) { return ++asked < 3; });
  EXPECT_THROW(parallel.in_order(
                   100, [&](int) { ++visited; }, Grain{1, 10}),
               CancelRequest);
  EXPECT_EQ(visited, 20);
}

TEST(ProgressMeter, AsksNoMoreOnceItHasFallenSilent) {
  int asked = 0;
  ProgressMeter meter([&](int, const char*) {
    ++asked;
    return false;
  });
  EXPECT_THROW(meter.ask(), CancelRequest);
  meter.fall_silent();
  meter.in_loop(0.5);
  EXPECT_EQ(asked, 1);
}

}  // namespace
}  // namespace curvdecim::test
