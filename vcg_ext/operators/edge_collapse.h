// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "vcg_ext/guard/collapse_guards.h"
#include "vcg_ext/guard/collapse_rule.h"
#include "vcg_ext/operators/collapse_observer.h"
#include "vcg_ext/operators/stop_criterion.h"
#include "vcg_ext/parallel.h"
#include "vcg_ext/params.h"
#include "vcg_ext/queue/edge_queue.h"
#include "vcg_ext/report.h"

namespace curvdecim {

/// Greedy edge collapse, cheapest edge first:
///
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
/// lowered are found when the edge is evaluated next. `Metric` has initialize(parallel),
/// evaluate(edge, allowed) -> optional<Candidate>, release(around) before a collapse and
/// merge(collapse, around, ring) after it.
template <class MetricType>
class EdgeCollapse {
 public:
  EdgeCollapse(WorkingMesh& mesh, MetricType& metric, const DecimationParams& params,
               Scheduler scheduler, const StopCriterion& stop)
      : mesh_(mesh),
        metric_(metric),
        params_(params),
        scheduler_(scheduler),
        stop_(stop),
        queue_(mesh.connectivity.vertex_slots()),
        around_(mesh.connectivity.vertex_slots()),
        marks_(mesh.connectivity.vertex_slots()),
        rule_(mesh, params),
        guards_(mesh, params),
        rest_(mesh.connectivity.vertex_slots(), 0) {}

  void add_observer(CollapseObserver& observer) { observers_.push_back(&observer); }

  /// Fills max_error (in the unit of the working mesh), cost_last, rejected and stopped_by.
  void run(const Parallel& parallel, const Progress& progress, DecimationReport& report) {
    report_ = &report;
    metric_.initialize(parallel);
    int before;
    do {  // a refused edge may have become possible since: ask all once more before giving up
      before = mesh_.connectivity.face_count();
      fill_queue(parallel);
      report.stopped_by = empty_queue(progress);
    } while (report.stopped_by == StopReason::NothingLeft &&
             mesh_.connectivity.face_count() < before);
    report.max_error = guards_.largest_error();
    if (report.stopped_by == StopReason::NothingLeft && rejected(Rejection::ErrorBound) > 0)
      report.stopped_by = StopReason::ErrorBound;
  }

 private:
  StopReason empty_queue(const Progress& progress) {
    const int start = mesh_.connectivity.face_count();
    for (int steps = 0; !stop_.reached(mesh_.connectivity); ++steps) {
      if (queue_.empty()) return StopReason::NothingLeft;
      if (steps % steps_per_progress == 0 && !report_progress(progress, start))
        return StopReason::Cancelled;
      const Edge edge = queue_.top();
      const auto candidate =
          mesh_.connectivity.has_edge(edge.a, edge.b) ? evaluate(edge) : std::nullopt;
      if (!candidate || candidate->cost > std::max(queue_.top_cost(), queue_.second_cost())) {
        requeue(edge.a);
        continue;
      }
      around_.gather(mesh_.connectivity, edge);
      if (const auto reason = guards_.refusal(around_, candidate->position)) {
        ++rejected(*reason);
        queue_next_best(edge.a);
        continue;
      }
      report_->cost_last = candidate->cost;
      reevaluate(collapse(*candidate));
    }
    return StopReason::Target;
  }

  // --- candidates -------------------------------------------------------------------------------

  std::optional<Candidate> evaluate(Edge edge) const {
    const std::optional<Allowed> allowed = rule_(edge);
    if (!allowed) return std::nullopt;
    std::optional<Candidate> candidate = metric_.evaluate(edge, *allowed);
    if (candidate && !mesh_.importance.empty())
      candidate->cost *= mesh_.importance[edge.a] + mesh_.importance[edge.b];
    return candidate;
  }

  Priority priority(Edge edge, double cost) const {
    return {cost,
            static_cast<float>((mesh_.position[edge.a] - mesh_.position[edge.b]).squaredNorm())};
  }

  struct Option {
    Priority priority;
    int partner;
    bool operator<(const Option& o) const {
      return std::tie(priority.cost, priority.length2, partner) <
             std::tie(o.priority.cost, o.priority.length2, o.partner);
    }
  };

  /// The edges that v owns (to neighbours with a higher index) with their costs.
  void gather_options(int v, VertexMarks& marks, std::vector<Option>& options) const {
    options.clear();
    for_each_neighbor(mesh_.connectivity, v, marks, [&](int u) {
      if (u < v) return;
      if (const auto candidate = evaluate({v, u}))
        options.push_back({priority({v, u}, candidate->cost), u});
    });
  }

  void fill_queue(const Parallel& parallel);

  void requeue(int v) {
    gather_options(v, marks_, options_);
    if (options_.empty()) return queue_.remove(v);
    const Option best = *std::min_element(options_.begin(), options_.end());
    queue_.set({v, best.partner}, best.priority);
  }

  /// The cheapest edge of v that no guard refuses. A hub rests after some tries: each costs it as
  /// much as it has faces.
  void queue_next_best(int v) {
    gather_options(v, marks_, options_);
    std::sort(options_.begin(), options_.end());
    if (options_.size() > hub) {
      options_.resize(hub);
      rest_[v] = mesh_.connectivity.faces_of(v).size() / hub_rest;
    }
    for (const Option& option : options_) {
      around_.gather(mesh_.connectivity, {v, option.partner});
      if (!guards_.refusal(around_, evaluate(around_.edge())->position))
        return queue_.set(around_.edge(), option.priority);
    }
    queue_.remove(v);
  }

  std::int64_t& rejected(Rejection reason) {
    return report_->rejected[static_cast<std::size_t>(reason)];
  }

  // --- collapse ---------------------------------------------------------------------------------

  /// The vertex that does not move stays, if there is one, so that it keeps its bits.
  Collapse collapse(const Candidate& candidate) {
    const auto [a, b] = around_.edge();
    const bool keep_b = candidate.position == mesh_.position[b];
    const int keep = keep_b ? b : a, gone = keep_b ? a : b;
    const Collapse done{keep,
                        gone,
                        mesh_.position[keep],
                        mesh_.position[gone],
                        candidate.position,
                        keep_b ? 1.0 - candidate.t : candidate.t};
    guards_.accept(around_);
    metric_.release(around_);
    for (CollapseObserver* observer : observers_) observer->before(mesh_, around_, done);
    mesh_.position[keep] = candidate.position;
    mesh_.connectivity.collapse(keep, gone);
    if (!params_.preserve_topology) remove_duplicates();
    mesh_.kind[keep] = std::max(mesh_.kind[keep], mesh_.kind[gone]);
    if (!mesh_.importance.empty())
      mesh_.importance[keep] += done.t * (mesh_.importance[gone] - mesh_.importance[keep]);
    for (int f : around_.star())
      if (mesh_.connectivity.alive(f)) mesh_.update_plane(f);
    return done;
  }

  /// Where the link condition was not asked for, faces may have fallen onto each other.
  void remove_duplicates() {
    for (int f : around_.star()) {
      if (!mesh_.connectivity.alive(f)) continue;
      const Face& face = mesh_.connectivity.face(f);
      for (int g : around_.star())
        if (g > f && mesh_.connectivity.alive(g) && mesh_.connectivity.face_has(g, face[0]) &&
            mesh_.connectivity.face_has(g, face[1]) && mesh_.connectivity.face_has(g, face[2]))
          mesh_.connectivity.remove_face(g);
    }
  }

  void reevaluate(const Collapse& done) {
    ring_.clear();
    for_each_neighbor(mesh_.connectivity, done.keep, marks_, [this](int u) { ring_.push_back(u); });
    metric_.merge(done, around_, ring_);
    queue_.remove(done.gone);
    queue_.remove(done.keep);
    if (scheduler_ == Scheduler::Eager) {
      requeue(done.keep);
      for (int u : ring_)
        if (!passed_over(u)) requeue(u);
    } else {
      for (int u : ring_) offer({std::min(u, done.keep), std::max(u, done.keep)});
    }
  }

  void offer(Edge edge) {
    if (passed_over(edge.a)) return;
    if (const auto candidate = evaluate(edge)) queue_.offer(edge, priority(edge, candidate->cost));
  }

  /// A hub at rest lets new edges go by.
  bool passed_over(int owner) {
    if (rest_[owner] == 0 || queue_.partner(owner) != EdgeQueue::none) return false;
    --rest_[owner];
    return true;
  }

  bool report_progress(const Progress& progress, int start) const {
    if (!progress) return true;
    const int done = start - mesh_.connectivity.face_count(),
              all = std::max(1, start - stop_.faces);
    return progress(static_cast<int>(std::min(100.0, 100.0 * done / all)), "Collapsing edges");
  }

  static constexpr int steps_per_progress = 1024;  // a few milliseconds
  static constexpr int hub = 64;      // a valence well above those of meshes made for any purpose
  static constexpr int hub_rest = 8;  // a refused hub is asked again after an eighth has changed

  WorkingMesh& mesh_;
  MetricType& metric_;
  const DecimationParams& params_;
  const Scheduler scheduler_;
  const StopCriterion& stop_;
  EdgeQueue queue_;
  EdgeNeighborhood around_;
  VertexMarks marks_;
  const CollapseRule rule_;
  CollapseGuards guards_;
  std::vector<int> rest_;  // by vertex: new edges still to be passed over
  std::vector<int> ring_;
  std::vector<Option> options_;
  std::vector<CollapseObserver*> observers_;
  DecimationReport* report_ = nullptr;
};

template <class MetricType>
void EdgeCollapse<MetricType>::fill_queue(const Parallel& parallel) {
  const int count = mesh_.connectivity.vertex_slots();
  std::vector<Option> best(count, Option{{0.0}, EdgeQueue::none});
  parallel.for_ranges(count, [&](int begin, int end) {
    VertexMarks marks(count);
    std::vector<Option> options;
    for (int v = begin; v < end; ++v) {
      gather_options(v, marks, options);
      if (!options.empty()) best[v] = *std::min_element(options.begin(), options.end());
    }
  });
  for (int v = 0; v < count; ++v)
    if (best[v].partner != EdgeQueue::none) queue_.set({v, best[v].partner}, best[v].priority);
}

}  // namespace curvdecim
