// SPDX-License-Identifier: GPL-3.0-or-later
// The results of all filters: texts, names and their order.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "filter_curvdecim/filters/all_filters.h"

namespace {

using namespace curvdecim;
using namespace curvdecim::glue;
using Names = std::vector<std::string>;

const Names counts = {"faces_before", "faces", "vertices_before", "vertices", "stopped_by"};

template <class F>
Names names_after(const typename F::Report& report, const typename F::Params& params = {}) {
  Names names;
  for (const Result& result : results_of(F::results(), report, params))
    names.push_back(result.name);
  return names;
}

Names operator+(Names one, const Names& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

TEST(ResultTable, RowsHaveUniqueNamesAndMeanings) {
  for (const FilterTable& filter : AllFilters::tables()) {
    EXPECT_FALSE(filter.results.empty()) << filter.about.menu_name;
    std::set<std::string> names;
    for (const ResultText& result : filter.results) {
      EXPECT_FALSE(result.name.empty()) << filter.about.menu_name;
      EXPECT_FALSE(result.meaning.empty()) << result.name;
      EXPECT_TRUE(names.insert(result.name).second) << result.name;
    }
  }
}

const Names topology = {"parts_removed", "holes_closed", "handles_cut", "junctions_parted",
                        "largest_removed"};
const Names collapse_end = {"cost_last",
                            "rejected_link_condition",
                            "rejected_normal_flip",
                            "rejected_triangle_shape",
                            "rejected_error_bound",
                            "rejected_hub_at_rest",
                            "rejected_texture_flip",
                            "rejected_crossing",
                            "seconds"};

TEST(ResultTable, EdgeCollapseTellsItsBoundAndPairsWhereAsked) {
  EdgeCollapseParams params;
  EXPECT_EQ(names_after<EdgeCollapseFilter>({}, params), counts + topology + collapse_end);
  params.max_error = 0.1;
  EXPECT_EQ(names_after<EdgeCollapseFilter>({}, params),
            counts + Names{"max_error"} + collapse_end);
  params.max_error = 0.0;
  params.pair_distance = 0.1;
  EXPECT_EQ(names_after<EdgeCollapseFilter>({}, params),
            counts + Names{"pairs_contracted"} + topology + collapse_end);
}

TEST(ResultTable, EdgeCollapseTellsWhatCrossesWhereAsked) {
  EdgeCollapseParams params;
  params.prevent_intersections = true;
  EXPECT_EQ(names_after<EdgeCollapseFilter>({}, params),
            counts + topology + Names{"crossing"} + collapse_end);
}

TEST(ResultTable, AlgebraicSphereTellsItsBoundWhereAsked) {
  SphereParams params;
  EXPECT_EQ(names_after<AlgebraicSphereFilter>({}, params), counts + topology + collapse_end);
  params.max_error = 0.1;
  EXPECT_EQ(names_after<AlgebraicSphereFilter>({}, params),
            counts + Names{"max_error"} + collapse_end);
}

TEST(ResultTable, VertexRemovalTellsItsClassesWhereShown) {
  const Names removal = counts + Names{"max_error",
                                       "cost_last",
                                       "rejected_vertex_class",
                                       "rejected_loop_split",
                                       "rejected_link_condition",
                                       "rejected_normal_flip",
                                       "rejected_triangle_shape",
                                       "rejected_error_bound",
                                       "seconds"};
  RemovalReport report;
  EXPECT_EQ(names_after<VertexRemovalFilter>(report), removal);
  report.classes = ClassCounts{1, 2, 3, 4, 5};
  const Names classes = {"vertices_simple", "vertices_complex", "vertices_boundary",
                         "vertices_interior_edge", "vertices_corner"};
  EXPECT_EQ(names_after<VertexRemovalFilter>(report), removal + classes);
}

TEST(ResultTable, VertexClusteringTellsItsCells) {
  const Names cells = {
      "cell_size",          "largest_move",          "cost_last", "rejected_degenerate",
      "rejected_duplicate", "rejected_crowded_edge", "seconds"};
  EXPECT_EQ(names_after<VertexClusteringFilter>({}), counts + cells);
}

TEST(ResultTable, ImportanceTellsValuesOrThatItWasCancelled) {
  ImportanceReport report;
  EXPECT_EQ(names_after<CurvatureImportanceFilter>(report),
            (Names{"minimum", "median", "maximum"}));
  report.stopped_by = StopReason::Cancelled;
  EXPECT_EQ(names_after<CurvatureImportanceFilter>(report), Names{"stopped_by"});
}

bool has(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(ResultTable, ErrorTellsTextureAndToleranceWhereThereAreSuch) {
  LayerErrorReport report;
  LayerErrorParams params;
  Names names = names_after<SimplificationErrorFilter>(report, params);
  for (const char* name : {"rms", "mean", "max", "rms_salient", "normal_deviation_deg", "diagonal"})
    EXPECT_TRUE(has(names, name)) << name;
  for (const char* name : {"stopped_by", "texture_drift_rms", "beyond_tolerance"})
    EXPECT_FALSE(has(names, name)) << name;
  report.texture.emplace(), params.tolerance = 0.1;
  names = names_after<SimplificationErrorFilter>(report, params);
  for (const char* name : {"texture_drift_rms", "texture_lost", "beyond_tolerance"})
    EXPECT_TRUE(has(names, name)) << name;
  report = {};
  report.stopped_by = StopReason::Cancelled;
  EXPECT_EQ(names_after<SimplificationErrorFilter>(report), Names{"stopped_by"});
}

TEST(ResultTable, HistogramIsTheLegend) {
  ErrorHistogram histogram;
  histogram.end = 0.8;
  histogram.share[0] = 0.5, histogram.share[8] = 0.02;
  const Names lines = lines_of(histogram, " mm");
  ASSERT_EQ(lines.size(), 9u);
  EXPECT_EQ(lines[0], "red, up to 0.1 mm: 50 % of the area " + std::string(25, '#'));
  EXPECT_EQ(lines[1], "orange, up to 0.2 mm: 0 % of the area ");
  EXPECT_EQ(lines[8], "blue, beyond 0.8 mm: 2 % of the area #");
}

TEST(ResultTable, ValuesAreThoseOfTheReport) {
  RemovalReport report;
  report.faces = 7, report.cost_last = 0.1, report.stopped_by = StopReason::NothingLeft;
  report.rejected[Rejection::LoopSplit] = 3;
  report.classes = ClassCounts{1, 2, 30, 4, 5};
  const std::vector<std::string> lines =
      log_lines({"A sentence.",
                 {"A note."},
                 results_of(VertexRemovalFilter::results(), report, RemovalParams()),
                 {}});
  const std::set<std::string> found(lines.begin(), lines.end());
  EXPECT_EQ(lines[0], "A sentence.");
  EXPECT_EQ(lines[1], "A note.");
  for (const char* line : {"faces: 7", "cost_last: 0.1", "stopped_by: nothing left to collapse",
                           "rejected_loop_split: 3", "vertices_boundary: 30"})
    EXPECT_EQ(found.count(line), 1u) << line;
}

TEST(ResultTable, LogLeavesOutWhatIsZero) {
  DecimationReport report;
  report.faces = 7;
  const Outcome outcome{
      "A sentence.", {}, results_of(EdgeCollapseFilter::results(), report, {}), {}};
  EXPECT_EQ(log_lines(outcome),
            (std::vector<std::string>{"A sentence.", "faces: 7", "stopped_by: target"}));
}

TEST(ResultTable, LogOfARunThatDidNothingSaysWhyOnly) {
  DecimationReport report;
  report.faces = 7;
  Outcome outcome{
      "", {"Nothing to do."}, results_of(EdgeCollapseFilter::results(), report, {}), {}};
  EXPECT_EQ(log_lines(outcome), std::vector<std::string>{"Nothing to do."});
  report.stopped_by = StopReason::Cancelled;
  outcome.results = results_of(EdgeCollapseFilter::results(), report, {});
  EXPECT_EQ(log_lines(outcome),
            (std::vector<std::string>{"Nothing to do.", "stopped_by: cancelled"}));
}

TEST(ResultTable, HeadlineIsASentence) {
  DecimationReport report;
  report.faces_before = 1234567, report.faces = 1160, report.seconds = 0.01234;
  EXPECT_EQ(EdgeCollapseFilter::headline(report), "1,234,567 faces became 1,160 in 0.012 s.");
  report.seconds = 123.4;
  EXPECT_EQ(EdgeCollapseFilter::headline(report), "1,234,567 faces became 1,160 in 123 s.");
  report.faces = report.faces_before;
  EXPECT_EQ(EdgeCollapseFilter::headline(report), "");
}

TEST(ResultTable, KnowsWhatChanged) {
  DecimationReport stepwise;
  EXPECT_FALSE(EdgeCollapseFilter::changed(stepwise).shape);
  stepwise.faces_before = 2;
  EXPECT_TRUE(EdgeCollapseFilter::changed(stepwise).shape);
  ClusteringReport clustered;
  EXPECT_FALSE(VertexClusteringFilter::changed(clustered).shape);
  clustered.cell_size = 1.0;
  EXPECT_TRUE(VertexClusteringFilter::changed(clustered).shape);
  RemovalReport classes;
  EXPECT_FALSE(VertexRemovalFilter::changed(classes).quality_and_color);
  classes.classes.emplace();
  EXPECT_TRUE(VertexRemovalFilter::changed(classes).quality_and_color);
}

}  // namespace
