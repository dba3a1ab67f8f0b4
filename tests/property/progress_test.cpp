// SPDX-License-Identifier: GPL-3.0-or-later
// The bar of every function: one, from 0 towards 100, in small steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/clustering.h"
#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/expectations.h"
#include "support/removal.h"
#include "vcg_ext/curvature_importance.h"

namespace curvdecim::test {
namespace {

struct Bar {
  std::vector<int> percents;
  std::vector<std::string> stages;  // in the order in which they began

  bool show(int percent, const char* stage) {
    percents.push_back(percent);
    if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
    return true;
  }

  int largest_step() const {
    int largest = percents.front();
    for (std::size_t i = 1; i < percents.size(); ++i)
      largest = std::max(largest, percents[i] - percents[i - 1]);
    return largest;
  }
};

template <class Run>
Bar bar_of(Run run) {
  Bar bar;
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(5));
  run(mesh, [&](int percent, const char* stage) { return bar.show(percent, stage); });
  return bar;
}

/// largest_step: of a hundred.
void expect_one_bar(const Bar& bar, const std::vector<std::string>& stages, int largest_step) {
  ASSERT_FALSE(bar.percents.empty());
  EXPECT_EQ(bar.percents.front(), 0);
  EXPECT_TRUE(std::is_sorted(bar.percents.begin(), bar.percents.end()));
  EXPECT_GE(bar.percents.back(), 60);
  EXPECT_LE(bar.percents.back(), 100);
  EXPECT_LE(bar.largest_step(), largest_step);
  EXPECT_EQ(bar.stages, stages);
}

TEST(Progress, OfPresets) {
  for (Preset preset : {Preset::Fast, Preset::Balanced, Preset::Best}) {
    EdgeCollapseParams params = to_faces(1000);
    params.preset = preset;
    const Bar bar =
        bar_of([&](RichMesh& mesh, const Progress& show) { decimate(mesh, params, show); });
    std::vector<std::string> stages{"Preparing", "Collapsing edges"};
    if (preset == Preset::Best) stages.emplace_back("Refining");
    expect_one_bar(bar, stages, 20);
  }
}

TEST(Progress, OfAStrictOrder) {
  EdgeCollapseParams params = to_faces(1000);
  params.preset = Preset::Custom;
  params.scheduler = Scheduler::Lazy;
  const Bar bar =
      bar_of([&](RichMesh& mesh, const Progress& show) { decimate(mesh, params, show); });
  expect_one_bar(bar, {"Preparing", "Collapsing edges"}, 20);
}

TEST(Progress, OfABoundThatStopsTheRunEarly) {
  EdgeCollapseParams params;
  params.max_error = 1e-3;
  const Bar bar =
      bar_of([&](RichMesh& mesh, const Progress& show) { decimate(mesh, params, show); });
  expect_one_bar(bar, {"Preparing", "Collapsing edges"}, 20);
}

TEST(Progress, OfSpheres) {
  SphereParams params;
  params.target_faces = 1000;
  const Bar bar =
      bar_of([&](RichMesh& mesh, const Progress& show) { decimate(mesh, params, show); });
  expect_one_bar(bar, {"Preparing", "Collapsing edges"}, 20);
}

TEST(Progress, OfVertexRemoval) {
  VertexRemovalParams params;
  params.target_faces = 1000;
  const Bar bar = bar_of([&](RichMesh& mesh, const Progress& show) { remove(mesh, params, show); });
  expect_one_bar(bar, {"Preparing", "Removing vertices"}, 20);
}

TEST(Progress, OfClustering) {
  ClusteringParams params;
  params.target_faces = 1000;
  const Bar bar =
      bar_of([&](RichMesh& mesh, const Progress& show) { cluster(mesh, params, show); });
  expect_one_bar(bar, {"Preparing", "Clustering vertices"}, 60);
}

TEST(Progress, OfCurvatureImportance) {
  const Bar bar = bar_of([](RichMesh& mesh, const Progress& show) {
    EXPECT_TRUE(curvature_importance(mesh, ImportanceParams(), show));
  });
  expect_one_bar(bar, {"Preparing", "Computing curvature"}, 60);
}

TEST(Progress, CurvatureImportanceIsCancelledAtAnyCall) {
  for (int last = 1;; ++last) {
    RichMesh mesh;
    fill_with_attributes(mesh, unit_ball(3));
    const std::string before = bytes_of(mesh);
    int call = 0;
    if (curvature_importance(mesh, ImportanceParams(),
                             [&](int, const char*) { return ++call < last; })) {
      EXPECT_GT(last, 5);
      break;
    }
    EXPECT_EQ(call, last);
    EXPECT_TRUE(bytes_of(mesh) == before) << "cancelled at call " << last;
  }
}

}  // namespace
}  // namespace curvdecim::test
