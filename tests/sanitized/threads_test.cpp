// SPDX-License-Identifier: GPL-3.0-or-later
// Every public function on several threads does what it does on one. Under a sanitizer these tests
// also look for races, for memory that is used wrongly and for what the language leaves undefined.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "sanitized/every_function.h"
#include "support/expectations.h"

namespace curvdecim::test {
namespace {

constexpr int several = 3;  // threads

// --- meshes, large enough that every stage runs on all threads -----------------------------------

struct Input {
  const char* name;
  void (*fill)(RichMesh&);
  bool weighted_half;  ///< only the selected half, with the quality as a weight
};

void PrintTo(const Input& input, std::ostream* out) { *out << input.name; }

void fill_hubs(RichMesh& mesh) {
  fill_with_attributes(mesh, scaled(rough_cones(70, 15), 1.0 / 30));
}

void fill_pages(RichMesh& mesh) { fill_with_attributes(mesh, scaled(book(3, 18), 0.5)); }

void fill_seams(RichMesh& mesh) {
  fill_with_attributes(mesh, translated(saddle(32), {0.5, 0.5, 0.5}));
  put_right_half_on_a_page(mesh);
}

void fill_half(RichMesh& mesh) {
  fill_with_attributes(mesh, unit_ball(4));
  select_faces(mesh, is_left);
}

const std::vector<Input> inputs{{"hubs", fill_hubs, false},
                                {"pages", fill_pages, false},
                                {"seams", fill_seams, false},
                                {"weighted_half", fill_half, true}};

CommonParams common(const Input& input, int threads) {
  CommonParams params;
  params.target_fraction = 0.5, params.threads = threads;
  params.selected_only = params.quality_weight = input.weighted_half;
  return params;
}

// --- calls ---------------------------------------------------------------------------------------

struct Result {
  std::string mesh;  // its bytes
  DecimationReport report;
  int asked = 0;  // how often it asked whether to go on
};

/// no_at: the question whether to go on that is answered with no; 0: none is.
Result result_of(const Call& call, const Input& input, int threads, int no_at = 0) {
  RichMesh mesh;
  input.fill(mesh);
  Result result;
  result.report = call.run(mesh, common(input, threads),
                           [&](int, const char*) { return ++result.asked != no_at; });
  result.mesh = bytes_of(mesh);
  return result;
}

void expect_same(const Result& found, const Result& expected) {
  EXPECT_TRUE(found.mesh == expected.mesh);
  const DecimationReport &f = found.report, &e = expected.report;
  EXPECT_EQ(f.faces, e.faces);
  EXPECT_EQ(f.vertices, e.vertices);
  EXPECT_EQ(f.stopped_by, e.stopped_by);
  EXPECT_EQ(f.max_error, e.max_error);
  EXPECT_EQ(f.cost_last, e.cost_last);
  EXPECT_EQ(f.rejected, e.rejected);
  EXPECT_EQ(f.pairs_contracted, e.pairs_contracted);
  EXPECT_EQ(f.notes, e.notes);
}

class EveryFunction : public testing::TestWithParam<std::tuple<Input, Call>> {
 protected:
  const Input& input_ = std::get<Input>(GetParam());
  const Call& call_ = std::get<Call>(GetParam());
};

TEST_P(EveryFunction, DoesOnThreadsWhatItDoesOnOne) {
  const Result expected = result_of(call_, input_, 1);
  EXPECT_LE(expected.report.faces, expected.report.faces_before);
  expect_same(result_of(call_, input_, several), expected);
}

std::string name_of(const testing::TestParamInfo<std::tuple<Input, Call>>& info) {
  return std::get<Call>(info.param).name + "_" + std::get<Input>(info.param).name;
}

INSTANTIATE_TEST_SUITE_P(Of, EveryFunction,
                         testing::Combine(testing::ValuesIn(inputs),
                                          testing::ValuesIn(every_call())),
                         name_of);

/// Without hubs that rest, the questions about them need no order.
TEST(Hubs, AreAtRestInTheseTests) {
  for (const Call& call : every_call())
    if (call.name == "Balanced") {
      EXPECT_GT(result_of(call, {"hubs", fill_hubs, false}, several)
                    .report.rejected[Rejection::HubAtRest],
                0);
    }
}

TEST(CancelledCalls, LeaveTheMeshAsItWas) {
  constexpr int early = 4;  // of the questions whether to go on
  const Input input{"seams", fill_seams, false};
  RichMesh before;
  input.fill(before);
  int cancelled = 0;
  for (const Call& call : every_call()) {
    const Result found = result_of(call, input, several, early);
    if (found.asked == 0) continue;
    EXPECT_EQ(found.asked, early) << call.name;
    EXPECT_EQ(found.report.stopped_by, StopReason::Cancelled) << call.name;
    EXPECT_TRUE(found.mesh == bytes_of(before)) << call.name;
    ++cancelled;
  }
  EXPECT_GT(cancelled, 0);
}

TEST(CallsAtTheSameTime, ShareNothing) {
  const auto fill_ball = [](RichMesh& mesh) { fill_with_attributes(mesh, unit_ball(3)); };
  const std::vector<Call> calls = every_call();
  std::array<std::vector<Result>, 2> results;
  const auto call_all = [&](int i) {
    for (const Call& call : calls)
      results[i].push_back(result_of(call, {"ball", fill_ball, false}, 1));
  };
  std::thread other(call_all, 1);
  call_all(0);
  other.join();
  for (std::size_t c = 0; c < calls.size(); ++c) {
    SCOPED_TRACE(calls[c].name);
    expect_same(results[0][c], results[1][c]);
  }
}

}  // namespace
}  // namespace curvdecim::test
