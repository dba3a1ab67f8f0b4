// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "vcg_ext/operators/edge_collapser.h"
#include "vcg_ext/operators/stop_criterion.h"
#include "vcg_ext/parallel.h"
#include "vcg_ext/progress_meter.h"
#include "vcg_ext/queue/round_selection.h"
#include "vcg_ext/report.h"

namespace curvdecim {

/// Edge collapse in rounds, on all cores, with the same result on any number of them:
///
///   every vertex chooses its cheapest edge                              (metric, placement)
///   while the target is not reached and the rounds are worth while:
///     pick edges apart from each other among the cheapest               (queue)
///     evaluate each again; dearer than the round's limit or refused?
///       its vertex chooses again                                        (guard)
///     more than the target needs? keep the cheapest
///     collapse them, merge the metric, tell observers
///     evaluate the new edges and offer them to their vertices
template <class MetricType>
class CollapseRounds {
 public:
  CollapseRounds(WorkingMesh& mesh, EdgeCollapser<MetricType>& collapser, const StopCriterion& stop,
                 const Parallel& parallel)
      : mesh_(mesh),
        collapser_(collapser),
        stop_(stop),
        parallel_(parallel),
        choices_(mesh.connectivity.vertex_slots()),
        selection_(mesh.connectivity),
        scratch_(parallel.threads()) {}

  /// The number of collapses done. Ends at the target, or where too few edges are apart from each
  /// other.
  int run(ProgressMeter& progress, DecimationReport& report) {
    int done = 0;
    if (is_large()) choose_all();
    while (is_large() && !stop_.reached(mesh_.connectivity) && pick()) {
      progress.set(stop_.progress(mesh_.connectivity));
      check_all();
      const int ready = settle(report);
      collapser_.make_room(done + ready);
      collapse_all(ready, done);
      for (int i = 0; i < ready; ++i) mesh_.connectivity.count(picks_[i].removed);
      done += ready;
      if (is_sparse()) compact();
    }
    return done;
  }

 private:
  using Scratch = typename EdgeCollapser<MetricType>::Scratch;

  /// On a smaller mesh single collapses show in the result, and a round is too little work for all
  /// cores: there, and at a large mesh's end, the strict order takes over.
  static constexpr int least_vertices = 512;
  /// One pick in so many candidates: fewer are apart from each other around a hub.
  static constexpr int least_share = 64;

  struct Pick {
    Edge edge;
    bool ready;
    GuardAnswer answer;
    Candidate candidate;
    Removed removed;  // expected, then true
  };

  bool is_large() const { return mesh_.connectivity.vertex_count() >= least_vertices; }

  void choose_all() {
    choose(mesh_.connectivity.vertex_slots(), [](int i) { return i; });
  }

  /// For the vertices vertex(i), i below count.
  template <class Vertex>
  void choose(int count, Vertex vertex) {
    const auto choose_range = [&](int begin, int end, int worker) {
      for (int i = begin; i < end; ++i)
        choices_.set(vertex(i), collapser_.cheapest(vertex(i), scratch_[worker]));
    };
    parallel_.for_ranges(count, choose_range, Parallel::heavy);
  }

  void choose(const std::vector<int>& vertices) {
    choose(static_cast<int>(vertices.size()), [&](int i) { return vertices[i]; });
  }

  /// A third of the vertices is gone since the last time, and the rest is more than a cache holds.
  bool is_sparse() const {
    constexpr int cached = 1 << 14;  // vertices: some megabytes
    const int places = mesh_.connectivity.vertex_slots();
    return places > cached && mesh_.connectivity.vertex_count() < places / 3 * 2;
  }

  void compact() {
    const Renumbering numbers(mesh_.connectivity);
    collapser_.renumber(numbers), choices_.renumber(numbers), selection_.renumber(numbers);
    std::vector<int> undecided;
    for (int v = 0; v < mesh_.connectivity.vertex_slots(); ++v)
      if (!choices_.exists(v)) undecided.push_back(v);
    choose(undecided);
  }

  bool pick() {
    selection_.pick(choices_);
    const int count = static_cast<int>(selection_.edges().size());
    if (count <= selection_.candidates() / least_share) return false;
    picks_.resize(count);
    for (int i = 0; i < count; ++i) {
      picks_[i].edge = selection_.edges()[i];
      mesh_.connectivity.make_room(picks_[i].edge.a, picks_[i].edge.b);
    }
    const auto by_owner = [](const Pick& a, const Pick& b) { return a.edge.a < b.edge.a; };
    std::sort(picks_.begin(), picks_.end(), by_owner);  // near in memory, near in time
    return true;
  }

  void check_all() {
    const auto check_pick = [&](int begin, int end, int worker) {
      for (int i = begin; i < end; ++i) check(picks_[i], scratch_[worker]);
    };
    parallel_.for_ranges(static_cast<int>(picks_.size()), check_pick, Parallel::heavy);
    choose(selection_.outdated());
  }

  void check(Pick& pick, Scratch& scratch) {
    const int owner = pick.edge.a;
    const std::optional<Candidate> candidate = collapser_.evaluate(pick.edge);
    pick.ready =
        candidate && !(selection_.limit() < collapser_.priority(pick.edge, candidate->cost));
    pick.answer = {};
    if (!pick.ready) return choices_.set(owner, collapser_.cheapest(owner, scratch));
    pick.candidate = *candidate;
    pick.answer = collapser_.ask(pick.edge, candidate->position, scratch);
    pick.ready = !pick.answer.refusal;
    pick.removed = {static_cast<int>(scratch.around.wings().size()), 1};
    if (!pick.ready) choices_.set(owner, collapser_.cheapest_possible(owner, scratch));
  }

  /// Puts those to be done in front; their number.
  int settle(DecimationReport& report) {
    for (const Pick& pick : picks_)
      if (pick.answer.refusal) ++report.rejected_by(*pick.answer.refusal);
    const auto end = std::stable_partition(picks_.begin(), picks_.end(),
                                           [](const Pick& pick) { return pick.ready; });
    const int ready = needed(static_cast<int>(end - picks_.begin()));
    for (int i = 0; i < ready; ++i) {
      report.max_error = std::max(report.max_error, picks_[i].answer.error_bound);
      report.cost_last =
          i == 0 ? picks_[i].candidate.cost : std::max(report.cost_last, picks_[i].candidate.cost);
    }
    return ready;
  }

  /// Of the first `ready` picks those that the target needs, the cheapest in front.
  int needed(int ready) {
    Removed all;
    for (int i = 0; i < ready; ++i) all += picks_[i].removed;
    if (!stop_.reached(mesh_.connectivity, all)) return ready;
    std::stable_sort(picks_.begin(), picks_.begin() + ready, [](const Pick& a, const Pick& b) {
      return a.candidate.cost < b.candidate.cost;
    });
    Removed removed;
    int count = 0;
    while (!stop_.reached(mesh_.connectivity, removed)) removed += picks_[count++].removed;
    return count;
  }

  void collapse_all(int ready, int first_number) {
    const auto collapse_pick = [&](int begin, int end, int worker) {
      for (int i = begin; i < end; ++i) collapse(picks_[i], first_number + i, scratch_[worker]);
    };
    parallel_.for_ranges(ready, collapse_pick, Parallel::heavy);
  }

  void collapse(Pick& pick, int number, Scratch& scratch) {
    scratch.around.gather(mesh_.connectivity, pick.edge);
    const auto done = collapser_.collapse(pick.candidate, pick.answer.error_bound, number, scratch);
    pick.removed = done.removed;
    choices_.remove(done.keep), choices_.remove(done.gone);
    for (const RingVertex& u : scratch.ring)
      choices_.offer(std::min(u.vertex, done.keep), collapser_.choice(done.keep, u));
  }

  WorkingMesh& mesh_;
  EdgeCollapser<MetricType>& collapser_;
  const StopCriterion& stop_;
  const Parallel& parallel_;
  EdgeChoices choices_;
  RoundSelection selection_;
  std::vector<Scratch> scratch_;  // by worker
  std::vector<Pick> picks_;
};

}  // namespace curvdecim
