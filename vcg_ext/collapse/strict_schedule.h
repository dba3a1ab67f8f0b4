// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/collapse/collapse_operator.h"
#include "vcg_ext/collapse/edge_queue.h"
#include "vcg_ext/collapse/hub_rests.h"
#include "vcg_ext/mesh/tally.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// Collapses edges one by one, the cheapest first:
///
///   evaluate every edge, keep each vertex's cheapest in the queue
///   while the target is not reached:
///     edge <- cheapest                               (queue)
///     evaluate again; costlier than queued? requeue  (metric)
///     neighbourhood of the edge                      (mesh)
///     refused? queue the vertex's next best          (guard)
///     collapse, merge the metric, tell observers
///     evaluate the new edges
///
/// Costs that a collapse elsewhere raised are found when their entry comes up; costs that it
/// lowered are found when the edge is evaluated next.
template <class MetricType>
class StrictSchedule {
 public:
  /// eager: evaluate all edges around the merged vertex again, but for a hub's. next_number: of the
  /// next collapse.
  StrictSchedule(WorkingMesh& mesh, CollapseOperator<MetricType>& collapses,
                 HubRests<MetricType>& rests, const StopCriterion& stop, bool eager,
                 int next_number)
      : mesh_(mesh),
        collapses_(collapses),
        rests_(rests),
        parts_(collapses.parts()),
        stop_(stop),
        eager_(eager),
        is_sparing_(parts_ != nullptr),
        next_number_(next_number),
        queue_(mesh.connectivity.vertex_slots()),
        changed_(mesh.connectivity.vertex_slots(), 1) {}

  /// Collapses until the target is reached or nothing is left. Throws CancelRequest.
  void run(const Parallel& parallel, Tally& tally) {
    if (stop_.reached(mesh_.connectivity)) return tally.end(StopReason::Target);
    StopReason reason;
    int before;
    do {  // a refused edge may have become possible since: ask once more before giving up
      before = next_number_;
      tally.begin_look();
      rests_.end_all();
      spare();
      fill_queue(parallel);
      reason = empty_queue(parallel.progress(), tally);
    } while (reason == StopReason::NothingLeft && (next_number_ > before || spares_no_more()));
    tally.end(reason);
  }

 private:
  using Scratch = typename CollapseOperator<MetricType>::Scratch;

  static constexpr int steps_per_progress = 1024;  // a few milliseconds

  /// False if edges of many faces were not held back.
  bool spares_no_more() {
    if (!std::exchange(is_sparing_, false)) return false;
    std::fill(changed_.begin(), changed_.end(), 1);
    return true;
  }

  /// The answer about an edge depends on what is up to three edges away. Pairs and crossings reach
  /// further, and edges of a hub at rest were not asked about.
  void find_changed(const Parallel& parallel) {
    constexpr int reach = 3;
    const int count = mesh_.connectivity.vertex_slots();
    for (int i = 0; i < reach; ++i) {
      const std::vector<std::uint8_t> near = changed_;
      parallel.in_order(count, [&](int v) {
        if (near[v])
          for (int f : mesh_.connectivity.faces_of(v))
            for (int u : mesh_.connectivity.face(f)) changed_[u] = 1;
      });
    }
    parallel.for_each(count, [&](int v) {
      if (collapses_.has_pairs() || collapses_.crossing_guard() || rests_.near(v)) changed_[v] = 1;
    });
  }

  /// With all that was not asked about since it changed.
  void fill_queue(const Parallel& parallel) {
    find_changed(parallel);
    const int count = mesh_.connectivity.vertex_slots();
    std::vector<EdgeChoice> choices(count);
    parallel.for_ranges(
        count,
        [&](int begin, int end, int) {
          Scratch scratch;
          for (int v = begin; v < end; ++v)
            if (changed_[v]) choices[v] = collapses_.cheapest(v, scratch);
        },
        Parallel::heavy);
    for (int v = 0; v < count; ++v) queue_.set(v, choices[v]);
    std::fill(changed_.begin(), changed_.end(), 0);
    if (parts_) parts_->offer_all();
    filled_ = queue_.size();
    progress_at_fill_ = std::max(progress_at_fill_, stop_.progress(mesh_.connectivity));
  }

  StopReason empty_queue(ProgressMeter& progress, Tally& tally) {
    for (int steps = 0; !stop_.reached(mesh_.connectivity); ++steps) {
      if (steps % steps_per_progress == 0) show(progress);
      spare();
      if (parts_ && remove_part(tally)) continue;
      if (queue_.empty()) return StopReason::NothingLeft;
      const Edge edge = queue_.top();
      const auto candidate = collapses_.exists(edge) ? collapses_.evaluate(edge) : std::nullopt;
      if (!candidate || is_behind(edge, candidate->cost)) {
        queue_.set(edge.a, collapses_.cheapest(edge.a, scratch_));
        continue;
      }
      const GuardAnswer answer = ask_settled(edge, *candidate);
      if (answer.refusal == Rejection::ErrorBound && collapse_onto_end(edge, tally)) continue;
      if (answer.refusal || is_behind(edge, candidate->cost + answer.price)) {
        if (answer.refusal) ++tally.rejected[*answer.refusal];
        queue_.set(edge.a, rests_.cheapest_possible(edge.a, scratch_));
        continue;
      }
      if (answer.obstacle.exists())
        clear(edge, answer.obstacle, tally);
      else
        collapse(*candidate, answer.error_bound, tally);
    }
    return StopReason::Target;
  }

  /// An edge where many sheets meet takes many faces at once. Where these are more than are to go,
  /// it waits until no other edge is left; not where the topology stays, which the others may bring
  /// to where none of them is possible any more.
  void spare() {
    const int most = stop_.most_faces(mesh_.connectivity);
    collapses_.set_most_faces(is_sparing_ ? most : mesh_.connectivity.face_count());
  }

  /// Takes the cheapest part away where no edge is cheaper. A part that has more faces than are to
  /// go stays, unless no edge is left.
  bool remove_part(Tally& tally) {
    const Priority limit = queue_.empty() ? Priority() : queue_.top_priority();
    const int most = stop_.most_faces(mesh_.connectivity);
    std::optional<Part> part = parts_->take(limit, most);
    if (!part && queue_.empty() && parts_->widen())
      part = parts_->take(limit, most + 2);  // four closed faces where a pair is to go
    if (!part) return false;
    collapses_.remove(*part, tally);
    for (int v : part->vertices) queue_.remove(v);
    return true;
  }

  /// What gives way takes numbers of vertices and faces that are gone. Where too few are, as at the
  /// start, there will be more.
  void make_room(const Obstacle& obstacle) {
    constexpr int cut = 3, part = 50;  // vertices or faces of a cut; one in so many is added
    const bool is_junction = obstacle.kind == Obstacle::Kind::Junction;
    const int copies = is_junction ? collapses_.valence(obstacle.vertex) : cut;
    const TriangleConnectivity& all = mesh_.connectivity;
    if (all.vertex_slots() - all.vertex_count() >= copies &&
        all.face_slots() - all.face_count() >= cut)
      return;
    const Renumbering numbers(all, copies + all.vertex_slots() / part,
                              cut + all.face_slots() / part);
    collapses_.renumber(numbers), rests_.renumber(numbers);
    queue_.extend(all.vertex_slots());
    changed_.resize(all.vertex_slots(), 1);
    parts_->offer_all();
  }

  void clear(Edge edge, const Obstacle& obstacle, Tally& tally) {
    make_room(obstacle);
    const std::vector<int> touched = collapses_.clear(edge, obstacle, next_number_, tally);
    if (touched.empty()) {
      ++tally.rejected[Rejection::LinkCondition];
      return queue_.remove(edge.a);
    }
    for (int v : touched) {
      changed_[v] = 1;
      queue_.set(v, collapses_.cheapest(v, scratch_));
      collapses_.gather_mates(v, ring_);
      for (const RingVertex& u : ring_)
        queue_.set(u.vertex, collapses_.cheapest(u.vertex, scratch_));
      parts_->offer(v);
    }
  }

  /// An edge that was queued with a price was asked about before. It is asked again though its hub
  /// may rest: turned away unseen it would be queued with its price forever.
  GuardAnswer ask(Edge edge, const Candidate& candidate) {
    const Priority any;  // one that is too dear by now may be refused: the tally has the reason
    return queue_.top_has_price() ? collapses_.ask(edge, candidate, any, scratch_)
                                  : rests_.ask(edge, candidate, any, scratch_);
  }

  /// The bound is asked last, and only where the collapse would be done.
  GuardAnswer ask_settled(Edge edge, const Candidate& candidate) {
    GuardAnswer answer = ask(edge, candidate);
    if (!is_behind(edge, candidate.cost + answer.price)) rests_.settle(edge, answer);
    return answer;
  }

  /// Where it would leave the bound at its best place, it may be within it at an end.
  bool collapse_onto_end(Edge edge, Tally& tally) {
    for (const Candidate& end : collapses_.onto_ends(edge)) {
      GuardAnswer answer = collapses_.ask(edge, end, Priority(), scratch_);
      rests_.settle(edge, answer);
      if (answer.refusal || answer.obstacle.exists()) continue;
      collapse(end, answer.error_bound, tally);
      return true;
    }
    return false;
  }

  /// True if the edge became costlier since it was queued, and is no longer the cheapest.
  bool is_behind(Edge edge, double cost) const {
    const Priority now = collapses_.priority(edge, cost);
    return queue_.top_priority() < now && queue_.second_priority() < now;
  }

  void collapse(const Candidate& candidate, double error_bound, Tally& tally) {
    collapses_.make_room(++next_number_);
    const auto done = collapses_.collapse(candidate, error_bound, next_number_ - 1, scratch_);
    mesh_.connectivity.count(done.removed);
    collapses_.update_around(done.keep);
    tally.pairs_contracted += scratch_.around.wings().empty();
    tally.count_step(candidate.cost, error_bound);
    queue_.remove(done.gone);
    queue_.remove(done.keep);
    changed_[done.keep] = 1;
    collapses_.gather_mates(done.keep, ring_);
    eager_ ? requeue_ring(done.keep) : offer_ring(done.keep);
    if (parts_) parts_->offer(done.keep);
  }

  /// A hub has too many edges to evaluate them all at every collapse beside it: it is offered the
  /// new one.
  void requeue_ring(int v) {
    if (!collapses_.is_hub(v)) queue_.set(v, collapses_.cheapest(v, scratch_));
    for (const RingVertex& u : ring_) {
      if (collapses_.is_hub(v) || collapses_.is_hub(u.vertex))
        offer(v, u);
      else if (!is_passed_over(u.vertex))
        queue_.set(u.vertex, collapses_.cheapest(u.vertex, scratch_));
    }
  }

  void offer_ring(int v) {
    for (const RingVertex& u : ring_) offer(v, u);
  }

  void offer(int v, const RingVertex& neighbor) {
    if (const int owner = std::min(neighbor.vertex, v); !is_passed_over(owner))
      queue_.offer(owner, collapses_.choice(v, neighbor));
  }

  /// A hub at rest lets new edges go by.
  bool is_passed_over(int owner) { return !queue_.contains(owner) && rests_.passes_over(owner); }

  /// Nothing but refusals is progress, too: the queue becomes empty.
  void show(ProgressMeter& progress) const {
    const double asked = 1.0 - static_cast<double>(queue_.size()) / std::max(1, filled_);
    progress.set(std::max(stop_.progress(mesh_.connectivity),
                          progress_at_fill_ + (1.0 - progress_at_fill_) * asked));
    progress.ask();
  }

  WorkingMesh& mesh_;
  CollapseOperator<MetricType>& collapses_;
  HubRests<MetricType>& rests_;
  Parts* const parts_;  // that may vanish; nullptr: none may
  const StopCriterion& stop_;
  const bool eager_;
  bool is_sparing_;
  int next_number_;  // of the next collapse
  EdgeQueue queue_;
  std::vector<std::uint8_t> changed_;  // by vertex: 1 if it was merged since the queue was filled
  int filled_ = 0;                     // entries of the queue when it was filled last
  double progress_at_fill_ = 0.0;
  Scratch scratch_;
  VertexRing ring_;  // of the vertex merged last, with its partners
};

}  // namespace curvdecim::detail
