// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "vcg_ext/operators/collapse_rounds.h"
#include "vcg_ext/operators/edge_collapser.h"
#include "vcg_ext/operators/stop_criterion.h"
#include "vcg_ext/parallel.h"
#include "vcg_ext/params.h"
#include "vcg_ext/progress_meter.h"
#include "vcg_ext/queue/edge_queue.h"
#include "vcg_ext/report.h"

namespace curvdecim {

/// Greedy edge collapse, cheapest edge first:
///
///   Rounds? collapse in rounds while they are worth while
///   PairDistance? vertices that close are edges, too (queue)
///   evaluate every edge, keep each vertex's cheapest in the queue
///   while the target is not reached:
///     edge <- cheapest                            (queue)
///     evaluate again; dearer than queued? requeue (metric, placement)
///     neighbourhood of the edge                   (connectivity)
///     refused? queue the vertex's next best       (guard)
///     collapse, merge the metric, tell observers
///     evaluate the new edges
///
/// Costs that a collapse elsewhere raised are found when their entry comes up; costs that it
/// lowered are found when the edge is evaluated next.
template <class MetricType>
class EdgeCollapse {
 public:
  /// params: lengths in the unit of the working mesh; so is pair_distance.
  EdgeCollapse(WorkingMesh& mesh, MetricType& metric, const DecimationParams& params,
               Scheduler scheduler, double pair_distance, const StopCriterion& stop)
      : mesh_(mesh),
        metric_(metric),
        scheduler_(params.preserve_topology ? scheduler : one_by_one(scheduler)),
        pair_distance_(pair_distance),
        stop_(stop),
        collapser_(mesh, metric, params),
        queue_(0) {}

  void add_observer(CollapseObserver& observer) { collapser_.add_observer(observer); }

  /// Fills max_error (in the unit of the working mesh), cost_last, rejected and stopped_by. Throws
  /// CancelRequest.
  void run(const Parallel& parallel, ProgressMeter& progress, DecimationReport& report) {
    report_ = &report;
    metric_.initialize(parallel);
    progress.begin("Collapsing edges");
    if (const double share = share_of_round(); share > 0.0)
      collapses_ = CollapseRounds(mesh_, collapser_, stop_, share, parallel).run(progress, report);
    if (pair_distance_ > 0.0)
      collapser_.add_pairs(VertexPairs(mesh_, pair_distance_, parallel, progress));
    queue_ = EdgeQueue(mesh_.connectivity.vertex_slots());
    int before;
    do {  // a refused edge may have become possible since: ask all once more before giving up
      before = collapses_;
      collapser_.end_all_rests();
      fill_queue(parallel);
      report.stopped_by = empty_queue(progress);
    } while (report.stopped_by == StopReason::NothingLeft && collapses_ > before);
    if (report.stopped_by == StopReason::NothingLeft &&
        report.rejected_by(Rejection::ErrorBound) > 0)
      report.stopped_by = StopReason::ErrorBound;
  }

 private:
  /// Without the link condition a collapse may remove more faces than a round counts on.
  static Scheduler one_by_one(Scheduler scheduler) {
    return scheduler == Scheduler::Rounds || scheduler == Scheduler::FewRounds ? Scheduler::Lazy
                                                                               : scheduler;
  }

  /// Of the choices, for CollapseRounds; 0: no rounds (docs/decisions/rounds.md).
  double share_of_round() const {
    if (scheduler_ == Scheduler::Rounds) return 0.3;
    return scheduler_ == Scheduler::FewRounds ? 0.8 : 0.0;
  }

  StopReason empty_queue(ProgressMeter& progress) {
    for (int steps = 0; !stop_.reached(mesh_.connectivity); ++steps) {
      if (queue_.empty()) return StopReason::NothingLeft;
      if (steps % steps_per_progress == 0) show(progress);
      const Edge edge = queue_.top();
      const auto candidate = collapser_.exists(edge) ? collapser_.evaluate(edge) : std::nullopt;
      if (!candidate || is_behind(edge, candidate->cost)) {
        queue_.set(edge.a, collapser_.cheapest(edge.a, scratch_));
        continue;
      }
      const GuardAnswer answer = collapser_.ask(edge, candidate->position, scratch_);
      if (answer.refusal) {
        ++report_->rejected_by(*answer.refusal);
        queue_.set(edge.a, collapser_.cheapest_possible(edge.a, scratch_));
        continue;
      }
      collapse(*candidate, answer.error_bound);
    }
    return StopReason::Target;
  }

  /// True if the edge became dearer since it was queued, and is no longer the cheapest.
  bool is_behind(Edge edge, double cost) const {
    const Priority now = collapser_.priority(edge, cost);
    return queue_.top_priority() < now && queue_.second_priority() < now;
  }

  void fill_queue(const Parallel& parallel) {
    const int count = mesh_.connectivity.vertex_slots();
    std::vector<EdgeChoice> choices(count);
    parallel.for_ranges(
        count,
        [&](int begin, int end, int) {
          Scratch scratch;
          for (int v = begin; v < end; ++v) choices[v] = collapser_.cheapest(v, scratch);
        },
        Parallel::heavy);
    for (int v = 0; v < count; ++v) queue_.set(v, choices[v]);
  }

  void collapse(const Candidate& candidate, double error_bound) {
    collapser_.make_room(++collapses_);
    const auto done = collapser_.collapse(candidate, error_bound, collapses_ - 1, scratch_);
    mesh_.connectivity.count(done.removed);
    report_->pairs_contracted += scratch_.around.wings().empty();
    report_->cost_last = candidate.cost;
    report_->max_error = std::max(report_->max_error, error_bound);
    queue_.remove(done.gone);
    queue_.remove(done.keep);
    collapser_.gather_mates(done.keep, ring_);
    scheduler_ == Scheduler::Eager ? requeue_ring(done.keep) : offer_ring(done.keep);
  }

  void requeue_ring(int v) {
    queue_.set(v, collapser_.cheapest(v, scratch_));
    for (const RingVertex& u : ring_)
      if (!passed_over(u.vertex)) queue_.set(u.vertex, collapser_.cheapest(u.vertex, scratch_));
  }

  void offer_ring(int v) {
    for (const RingVertex& u : ring_)
      if (const int owner = std::min(u.vertex, v); !passed_over(owner))
        queue_.offer(owner, collapser_.choice(v, u));
  }

  /// A hub at rest lets new edges go by.
  bool passed_over(int owner) { return !queue_.contains(owner) && collapser_.rests(owner); }

  void show(ProgressMeter& progress) const {
    progress.set(stop_.progress(mesh_.connectivity));
    progress.ask();
  }

  using Scratch = typename EdgeCollapser<MetricType>::Scratch;

  static constexpr int steps_per_progress = 1024;  // a few milliseconds

  WorkingMesh& mesh_;
  MetricType& metric_;
  const Scheduler scheduler_;
  const double pair_distance_;
  const StopCriterion& stop_;
  EdgeCollapser<MetricType> collapser_;
  EdgeQueue queue_;
  Scratch scratch_;
  VertexRing ring_;  // of the vertex merged last, with its partners
  int collapses_ = 0;
  DecimationReport* report_ = nullptr;
};

}  // namespace curvdecim
