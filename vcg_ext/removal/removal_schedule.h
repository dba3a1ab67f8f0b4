// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "vcg_ext/mesh/tally.h"
#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/queue/indexed_heap.h"
#include "vcg_ext/removal/removal_operator.h"

namespace curvdecim::detail {

/// Vertex removal @cite schroeder1992:
///
///   Heap:    estimate every vertex by the paper's distance, least first   (queue)
///            while the target is not reached:
///              vertex <- least
///              triangulate the loop around it; refused? let it rest       (guard)
///              further off than estimated, and no longer first? requeue
///              remove it, tell observers, estimate its neighbours
///   Passes:  while the target is not reached:
///              remove in turn every vertex within the threshold
///              none went? raise the threshold to the least distance above it, or to its double
class RemovalSchedule {
 public:
  RemovalSchedule(WorkingMesh& mesh, RemovalOperator& removals, const RemovalPlan& plan,
                  const Parallel& parallel)
      : mesh_(mesh),
        removals_(removals),
        plan_(plan),
        stop_(plan.stop),
        parallel_(parallel),
        scratch_(mesh, plan),
        queue_(mesh.position.size()),
        exact_(mesh.position.size(), 0),
        rest_(mesh.position.size(), 0) {}

  /// Throws CancelRequest.
  Tally run() {
    plan_.times.begin_steps("Removing vertices", parallel_.progress());
    tally_.end(plan_.criterion == RemovalCriterion::Passes ? run_passes() : run_heap());
    return tally_;
  }

 private:
  static constexpr int steps_per_progress = 1024;  // some milliseconds

  // --- Heap -------------------------------------------------------------------------------------

  StopReason run_heap() {
    StopReason reason;
    int before;
    do {  // a refused vertex may have become free since: ask all once more before giving up
      before = mesh_.connectivity.face_count();
      tally_.begin_look();
      fill_queue();
      reason = empty_queue();
    } while (reason == StopReason::NothingLeft && mesh_.connectivity.face_count() < before);
    return reason;
  }

  void fill_queue() {
    const int count = mesh_.connectivity.vertex_slots();
    std::vector<std::optional<RemovalOperator::Estimate>> estimates(count);
    parallel_.for_ranges(
        count,
        [&](int begin, int end, int) {
          VertexFan fan;
          for (int v = begin; v < end; ++v) estimates[v] = estimate(v, fan);
        },
        Parallel::heavy);
    std::fill(rest_.begin(), rest_.end(), 0);
    for (int v = 0; v < count; ++v) enqueue(v, estimates[v]);
  }

  std::optional<RemovalOperator::Estimate> estimate(int v, VertexFan& fan) const {
    if (mesh_.connectivity.faces_of(v).size() == 0) return std::nullopt;
    return removals_.estimate(v, fan);
  }

  /// Keeps a key that is larger already: it was right once, and what changed around v has rarely
  /// brought it nearer. That saves a quarter of the time for 2 % of the error.
  void enqueue(int v, const std::optional<RemovalOperator::Estimate>& estimate) {
    exact_[v] = 0;
    if (!estimate) return queue_.remove(v);
    if (rest_[v] > 0) return void(--rest_[v]);
    if (queue_.contains(v) && estimate->priority < queue_.entry(v).key) return;
    queue_.set(v, estimate->priority);
  }

  StopReason empty_queue() {
    for (int steps = 0; !stop_.reached(mesh_.connectivity); ++steps) {
      if (queue_.empty()) return StopReason::NothingLeft;
      if (steps % steps_per_progress == 0) show_progress();
      const int v = queue_.top().index;
      RemovalAnswer answer = removals_.evaluate(v, scratch_);
      if (!answer.refusal && is_behind(v, answer)) {
        exact_[v] = 1;
        continue;
      }
      removals_.settle(answer, scratch_);
      if (answer.refusal) {
        ++tally_.rejected[*answer.refusal];
        queue_.remove(v);
        rest_[v] = rest_after_refusal(v);
      } else {
        queue_.remove(v);
        remove(answer);
        for (int u : scratch_.fan.loop()) enqueue(u, estimate(u, neighbor_fan_));
      }
    }
    return StopReason::Target;
  }

  /// How often the neighbours of a refused vertex may change before it is asked again: a large loop
  /// takes long, and what stood in its way is rarely gone at once.
  std::uint8_t rest_after_refusal(int v) const {
    constexpr int short_loop = 16;
    const int valence = static_cast<int>(mesh_.connectivity.faces_of(v).size());
    return static_cast<std::uint8_t>(
        std::clamp(valence - short_loop, 0, static_cast<int>(VertexFan::longest)));
  }

  /// True if the vertex is further off than estimated, and no longer first; its key is right then.
  bool is_behind(int v, const RemovalAnswer& answer) {
    if (exact_[v]) return false;
    const Priority estimated = queue_.top().key;
    const Priority now = removals_.priority(v, answer);
    if (!(estimated < now) || !(queue_.second_key() < now)) return false;
    queue_.set(v, now);
    return true;
  }

  // --- Passes -----------------------------------------------------------------------------------

  StopReason run_passes() {
    double threshold = 0.0;
    for (;;) {
      const int before = mesh_.connectivity.face_count();
      tally_.begin_look();
      const double next = pass(threshold);
      if (stop_.reached(mesh_.connectivity)) return StopReason::Target;
      if (mesh_.connectivity.face_count() < before) continue;  // others may be free now
      if (next == std::numeric_limits<double>::infinity()) return StopReason::NothingLeft;
      threshold = std::max(next, raise * threshold);
    }
  }

  /// The least distance that was above the threshold.
  double pass(double threshold) {
    double least_above = std::numeric_limits<double>::infinity();
    for (int v = 0; v < mesh_.connectivity.vertex_slots(); ++v) {
      if (stop_.reached(mesh_.connectivity)) break;
      if (v % steps_per_progress == 0) show_progress();
      const auto about = estimate(v, neighbor_fan_);
      if (!about) continue;
      double distance = about->distance;
      if (distance <= threshold) {
        RemovalAnswer answer = removals_.evaluate(v, scratch_);
        removals_.settle(answer, scratch_);
        if (answer.refusal) {
          ++tally_.rejected[*answer.refusal];
          continue;
        }
        distance = removals_.importance(v) * answer.error;
        if (distance <= threshold) remove(answer);
      }
      if (distance > threshold) least_above = std::min(least_above, distance);
    }
    return least_above;
  }

  static constexpr double raise = 2.0;  // of the threshold from pass to pass

  // --- both -------------------------------------------------------------------------------------

  void remove(const RemovalAnswer& answer) {
    mesh_.connectivity.count(removals_.remove(answer, scratch_));
    tally_.count_step(answer.cost, answer.error);
  }

  void show_progress() const {
    parallel_.progress().set(stop_.progress(mesh_.connectivity));
    parallel_.progress().ask();
  }

  WorkingMesh& mesh_;
  RemovalOperator& removals_;
  const RemovalPlan& plan_;
  const StopCriterion& stop_;
  const Parallel& parallel_;
  RemovalOperator::Scratch scratch_;
  VertexFan neighbor_fan_;
  IndexedHeap<Priority> queue_;
  std::vector<char> exact_;         // by vertex: 1 if its key is what evaluate says
  std::vector<std::uint8_t> rest_;  // by vertex: changes around it still to be passed over
  Tally tally_;
};

}  // namespace curvdecim::detail
