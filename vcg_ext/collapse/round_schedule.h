// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "vcg_ext/collapse/collapse_operator.h"
#include "vcg_ext/collapse/hub_rests.h"
#include "vcg_ext/collapse/round_crossings.h"
#include "vcg_ext/collapse/round_selection.h"
#include "vcg_ext/mesh/tally.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// Collapses edges in rounds, on all cores, with the same result on any number of them:
///
///   while the target is not reached and the rounds are worth while:
///     every vertex chooses its cheapest edge                            (metric)
///     the cheapest of these are candidates                              (selection)
///     while there are candidates that lie apart from each other:
///       pick them, evaluate each again
///       costlier than the round's limit, or refused? drop it            (guard)
///       more than the target needs? keep the cheapest
///       two would make faces cross? keep the first           (round_crossings.h)
///       collapse them, merge the metric, tell observers
template <class MetricType>
class RoundSchedule {
 public:
  /// largest_share: of the vertices' choices that may be candidates, 0..1. Fewer take more rounds
  /// and follow the greedy order more closely. next_number: of the next collapse.
  RoundSchedule(WorkingMesh& mesh, CollapseOperator<MetricType>& collapses,
                HubRests<MetricType>& rests, const StopCriterion& stop, double largest_share,
                int next_number, const Parallel& parallel)
      : mesh_(mesh),
        collapses_(collapses),
        rests_(rests),
        parts_(collapses.parts()),
        stop_(stop),
        parallel_(parallel),
        largest_share_(largest_share),
        outdated_(mesh.connectivity.vertex_slots(), 1),
        refused_(mesh.connectivity.vertex_slots(), 0),
        choices_(mesh.connectivity.vertex_slots()),
        selection_(mesh.connectivity, choices_),
        scratch_(parallel.threads()),
        near_hub_(parallel.threads()),
        next_number_(next_number) {}

  /// Collapses until the target is reached, or few candidates are left that lie apart. Returns the
  /// number of the next collapse.
  int run(Tally& tally) {
    if (parts_) parts_->offer_all();
    bool worth_while = stop_.collapses_left(mesh_.connectivity) >= least_collapses;
    while (worth_while && is_large() && !stop_.reached(mesh_.connectivity)) {
      choose_with_progress();
      selection_.begin(share(), parallel_);
      worth_while = collapse_candidates(tally);
      if (parts_) remove_parts(tally);
      if (is_sparse()) compact();
    }
    return next_number_;
  }

 private:
  using Operator = CollapseOperator<MetricType>;
  using Scratch = typename Operator::Scratch;

  /// On a smaller mesh single collapses show in the result, and a round is too little work for all
  /// cores: there, and at a large mesh's end, the strict order takes over.
  static constexpr int least_vertices = 512;
  static constexpr int least_collapses = 64;  // fewer are better chosen one by one
  /// One pick in so many candidates: fewer are apart from each other around a hub.
  static constexpr int least_share = 64;

  struct Pick {
    Edge edge{};
    bool ready = false;
    bool clears = false;  // an obstacle, instead
    GuardAnswer answer;
    Candidate candidate{};
    Removed removed;  // expected, then true
  };

  /// To choose takes about half of a round. Of the candidates a third lies too near to others.
  void choose_with_progress() {
    constexpr double half = 0.5, collapsed = 0.7;
    const int faces = mesh_.connectivity.face_count();
    const double round = collapsed * share() * mesh_.connectivity.vertex_count();
    const double now = stop_.progress(faces),
                 then = stop_.progress(faces - static_cast<int>(2.0 * round));
    parallel_.progress().along(now, now + half * (then - now), [&] { choose(); });
  }

  bool is_large() const { return mesh_.connectivity.vertex_count() >= least_vertices; }

  /// The vertices with a new edge or neighbour choose again, and so do those whose choice was not
  /// good: one whose choice was refused asks the guards itself. Near a hub that is done in the
  /// order of the vertices, since every question may change how long the hub rests.
  void choose() {
    const auto choose_range = [&](int begin, int end, int worker) {
      for (int v = begin; v < end; ++v)
        if (outdated_[v]) outdated_[v] = 0, choose_for(v, worker);
    };
    parallel_.for_ranges(mesh_.connectivity.vertex_slots(), choose_range, Parallel::heavy);
    std::vector<int> waiting;
    for (std::vector<int>& vertices : near_hub_) {
      waiting.insert(waiting.end(), vertices.begin(), vertices.end());
      vertices.clear();
    }
    std::sort(waiting.begin(), waiting.end());
    for (int v : waiting) choices_.set(v, rests_.cheapest_possible(v, scratch_[0]));
  }

  void choose_for(int v, int worker) {
    if (!refused_[v])
      choices_.set(v, collapses_.about_cheapest(v, scratch_[worker]));
    else if (rests_.near(v))
      near_hub_[worker].push_back(v);
    else
      choices_.set(v, rests_.cheapest_possible(v, scratch_[worker]));
  }

  /// Share of the choices that are candidates: no more than the target may need.
  double share() const {
    constexpr double ample = 1.5;  // some are refused or lie too near
    const double needed = stop_.collapses_left(mesh_.connectivity);
    return std::min(largest_share_, ample * needed / mesh_.connectivity.vertex_count());
  }

  /// False if too few of them could be collapsed.
  bool collapse_candidates(Tally& tally) {
    const int few = selection_.candidates() / least_share;
    const int before = mesh_.connectivity.vertex_count();
    while (!stop_.reached(mesh_.connectivity) && pick() > few) {
      collapse_picks(tally);
      parallel_.progress().set(stop_.progress(mesh_.connectivity));
    }
    return before - mesh_.connectivity.vertex_count() > few;
  }

  /// Picks candidates that lie apart, and returns their number.
  int pick() {
    selection_.pick(parallel_);
    const std::vector<Edge>& edges = selection_.edges();
    const int count = static_cast<int>(edges.size());
    picks_.resize(count);
    parallel_.for_each(count, [&](int i) {
      Pick& pick = picks_[i];
      pick.edge = edges[i], pick.ready = pick.clears = false, pick.answer = {};
      pick.removed = {mesh_.connectivity.edge_valence(pick.edge.a, pick.edge.b), 1};
    });
    for (const Pick& pick : picks_)
      mesh_.connectivity.make_room(pick.edge.a, pick.edge.b, pick.removed.faces);
    return count;
  }

  void collapse_picks(Tally& tally) {
    collapses_.make_room(next_number_ + static_cast<int>(picks_.size()));
    if (const CrossingGuard* guard = collapses_.crossing_guard(); guard || may_reach_target()) {
      if (guard) crossings_.begin(static_cast<int>(picks_.size()));
      for_picks([&](int i, Scratch& scratch) {
        check(picks_[i], scratch);
        if (guard && picks_[i].ready) crossings_.keep(i, scratch.crossing);
      });
      drop_needless();
      if (guard) drop_crossing(*guard);
      for_picks([&](int i, Scratch& scratch) {
        if (picks_[i].ready)
          collapses_.ask_around(picks_[i].edge, picks_[i].candidate, scratch);  // for the scratch
        collapse(i, scratch);
      });
    } else {
      for_picks([&](int i, Scratch& scratch) {
        check(picks_[i], scratch);
        collapse(i, scratch);
      });
    }
    count_picks(tally);
    if (parts_) give_way(tally);
  }

  template <class Work>
  void for_picks(Work work) {
    const auto do_range = [&](int begin, int end, int worker) {
      for (int i = begin; i < end; ++i) work(i, scratch_[worker]);
    };
    parallel_.for_ranges(static_cast<int>(picks_.size()), do_range, Parallel::heavy);
  }

  bool may_reach_target() const {
    Removed all;
    for (const Pick& pick : picks_) all += pick.removed;
    return stop_.reached(mesh_.connectivity, all);
  }

  void check(Pick& pick, Scratch& scratch) {
    outdated_[pick.edge.a] = 1;
    const std::optional<Candidate> candidate = collapses_.evaluate(pick.edge);
    pick.ready =
        candidate && !(selection_.limit() < collapses_.priority(pick.edge, candidate->cost));
    if (!pick.ready) return;
    pick.candidate = *candidate;
    pick.answer = rests_.ask(pick.edge, *candidate, selection_.limit(), scratch);
    const Priority price = collapses_.priority(pick.edge, candidate->cost + pick.answer.price);
    const bool affordable = !pick.answer.refusal && !(selection_.limit() < price);
    pick.clears = affordable && pick.answer.obstacle.exists();
    pick.ready = affordable && !pick.clears;
    refused_[pick.edge.a] = !affordable;
  }

  /// Drops picks that are ready but that the target does not need, the costliest first.
  void drop_needless() {
    std::vector<Pick*> ready;
    for (Pick& pick : picks_)
      if (pick.ready) ready.push_back(&pick);
    std::stable_sort(ready.begin(), ready.end(), [](const Pick* a, const Pick* b) {
      return a->candidate.cost < b->candidate.cost;
    });
    Removed removed;
    for (Pick* pick : ready) {
      pick->ready = !stop_.reached(mesh_.connectivity, removed) &&
                    pick->removed.faces <= stop_.most_faces(mesh_.connectivity, removed);
      if (pick->ready) removed += pick->removed;
    }
  }

  /// Drops picks that were asked about as the surface was, and may not be done with the others.
  void drop_crossing(const CrossingGuard& guard) {
    std::vector<int> ready;
    for (std::size_t i = 0; i < picks_.size(); ++i)
      if (picks_[i].ready) ready.push_back(static_cast<int>(i));
    for (int i : crossings_.to_drop(ready, guard, parallel_)) {
      picks_[i].ready = false;
      picks_[i].answer = {Rejection::Crossing};
    }
  }

  /// Collapses the pick if it is ready. Its neighbourhood is in the scratch.
  void collapse(int i, Scratch& scratch) {
    Pick& pick = picks_[i];
    if (!pick.ready) return;
    pick.removed =
        collapses_.collapse(pick.candidate, pick.answer.error_bound, next_number_ + i, scratch)
            .removed;
    outdated_[pick.edge.b] = 1;
    for (int f : scratch.around.star())
      if (mesh_.connectivity.alive(f))
        for (int u : mesh_.connectivity.face(f)) outdated_[u] = 1;
  }

  void count_picks(Tally& tally) {
    tally.cost_last = 0.0;
    for (const Pick& pick : picks_) {
      if (pick.answer.refusal) ++tally.rejected[*pick.answer.refusal];
      if (!pick.ready) continue;
      mesh_.connectivity.count(pick.removed);
      collapses_.update_around(pick.edge.a), collapses_.update_around(pick.edge.b);
      selection_.set_merged(pick.edge);
      tally.count_step(std::max(tally.cost_last, pick.candidate.cost), pick.answer.error_bound);
    }
    next_number_ += static_cast<int>(picks_.size());
  }

  /// What the picks that were collapsed have left small may vanish, and what the others met is
  /// cleared.
  void give_way(Tally& tally) {
    for (const Pick& pick : picks_)
      if (pick.ready) parts_->offer(pick.edge.a), parts_->offer(pick.edge.b);
    for (const Pick& pick : picks_)
      if (pick.clears) clear(pick.edge, tally);
  }

  /// One by one, and each looked at again: a cut reaches further than a collapse.
  void clear(Edge edge, Tally& tally) {
    const std::optional<Candidate> candidate =
        collapses_.exists(edge) ? collapses_.evaluate(edge) : std::nullopt;
    if (!candidate) return;
    const GuardAnswer answer = collapses_.ask(edge, *candidate, {}, scratch_[0]);
    if (answer.refusal || !answer.obstacle.exists()) return;
    const std::vector<int> touched = collapses_.clear(edge, answer.obstacle, next_number_, tally);
    refused_[edge.a] = touched.empty();
    for (int v : touched) {
      selection_.set_merged({v, v});
      parts_->offer(v);
      for (int f : mesh_.connectivity.faces_of(v))
        for (int u : mesh_.connectivity.face(f)) outdated_[u] = 1, refused_[u] = 0;
    }
  }

  /// Those that cost no more than the round's edges, and have no more faces than are to go.
  void remove_parts(Tally& tally) {
    while (!stop_.reached(mesh_.connectivity)) {
      const auto part =
          parts_->take(selection_.limit(), mesh_.connectivity.face_count() - stop_.faces);
      if (!part) break;
      collapses_.remove(*part, tally);
      for (int v : part->vertices) outdated_[v] = 1;
    }
  }

  /// A third of the vertices is gone since the last time, and the rest is more than a cache holds.
  bool is_sparse() const {
    constexpr int cached = 1 << 14;  // vertices: some megabytes
    const int places = mesh_.connectivity.vertex_slots();
    return places > cached && mesh_.connectivity.vertex_count() < places / 3 * 2;
  }

  void compact() {
    const Renumbering numbers(mesh_.connectivity);
    parallel_.progress().ask();
    collapses_.renumber(numbers), rests_.renumber(numbers);
    parallel_.progress().ask();
    choices_.renumber(numbers), selection_.renumber(numbers);
    numbers.vertices(outdated_), numbers.vertices(refused_);
    if (parts_) parts_->offer_all();
  }

  WorkingMesh& mesh_;
  Operator& collapses_;
  HubRests<MetricType>& rests_;
  Parts* const parts_;  // that may vanish; nullptr: none may
  const StopCriterion& stop_;
  const Parallel& parallel_;
  const double largest_share_;
  std::vector<std::uint8_t> outdated_;  // by vertex: 1 if it has to choose again
  std::vector<std::uint8_t> refused_;   // by vertex: 1 if its last pick was refused
  EdgeChoices choices_;
  RoundSelection selection_;
  std::vector<Scratch> scratch_;            // by worker
  std::vector<std::vector<int>> near_hub_;  // by worker: vertices that still have to choose
  std::vector<Pick> picks_;
  RoundCrossings crossings_;  // of the picks
  int next_number_;  // of the next collapse; numbers of picks that were dropped stay unused
};

}  // namespace curvdecim::detail
