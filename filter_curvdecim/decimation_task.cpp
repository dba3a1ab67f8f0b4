// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/decimation_task.h"

#include <initializer_list>

#include "filter_curvdecim/filter_parameters.h"

namespace curvdecim {

std::string log_line(const Result& result) {
  struct Text {
    std::string operator()(std::int64_t number) const { return std::to_string(number); }
    std::string operator()(double number) const { return decimal(number); }
    std::string operator()(StopReason reason) const { return to_string(reason); }
  };
  return result.name + ": " + std::visit(Text(), result.value);
}

namespace {

/// What every decimation tells first.
Outcome counts_of(const DecimationReport& report) {
  return {{{"faces_before", report.faces_before},
           {"faces", report.faces},
           {"vertices_before", report.vertices_before},
           {"vertices", report.vertices},
           {"stopped_by", report.stopped_by}},
          report.notes,
          report.faces != report.faces_before || report.vertices != report.vertices_before};
}

void add_rejections(const DecimationReport& report, std::initializer_list<Rejection> reasons,
                    Outcome& outcome) {
  for (Rejection reason : reasons) {
    const auto i = static_cast<std::size_t>(reason);
    outcome.results.push_back({std::string("rejected_") + rejection_names[i], report.rejected[i]});
  }
}

}  // namespace

Outcome outcome_of(const DecimationReport& report, const DecimationParams& params,
                   double pair_distance) {
  Outcome outcome = counts_of(report);
  if (params.max_error > 0.0) outcome.results.push_back({"max_error", report.max_error});
  if (pair_distance > 0.0) outcome.results.push_back({"pairs_contracted", report.pairs_contracted});
  outcome.results.push_back({"cost_last", report.cost_last});
  add_rejections(report,
                 {Rejection::LinkCondition, Rejection::NormalFlip, Rejection::TriangleShape,
                  Rejection::ErrorBound, Rejection::HubAtRest},
                 outcome);
  outcome.results.push_back({"seconds", report.seconds});
  return outcome;
}

Outcome outcome_of_removal(const DecimationReport& report) {
  Outcome outcome = counts_of(report);
  outcome.results.push_back({"max_error", report.max_error});
  outcome.results.push_back({"cost_last", report.cost_last});
  add_rejections(report,
                 {Rejection::VertexClass, Rejection::LoopSplit, Rejection::LinkCondition,
                  Rejection::NormalFlip, Rejection::TriangleShape, Rejection::ErrorBound},
                 outcome);
  outcome.results.push_back({"seconds", report.seconds});
  return outcome;
}

vcg::Color4b color_of(VertexClass vertex_class) {
  switch (vertex_class) {
    case VertexClass::Simple: return {200, 200, 200, 255};
    case VertexClass::Complex: return {220, 50, 47, 255};
    case VertexClass::Boundary: return {38, 139, 210, 255};
    case VertexClass::InteriorEdge: return {133, 153, 0, 255};
    case VertexClass::Corner: return {203, 75, 22, 255};
  }
  return {0, 0, 0, 255};
}

Outcome outcome_of(const ClusteringReport& report) {
  Outcome outcome = counts_of(report);
  outcome.results.insert(outcome.results.end(), {{"cell_size", report.cell_size},
                                                 {"max_error", report.max_error},
                                                 {"cost_last", report.cost_last},
                                                 {"rejected_degenerate", report.degenerate},
                                                 {"rejected_duplicate", report.duplicate},
                                                 {"rejected_crowded_edge", report.crowded},
                                                 {"seconds", report.seconds}});
  outcome.mesh_changed = report.cell_size > 0.0;
  return outcome;
}

double percentile(const std::vector<double>& sorted, double fraction) {
  return sorted[static_cast<std::size_t>(fraction * static_cast<double>(sorted.size() - 1))];
}

}  // namespace curvdecim
