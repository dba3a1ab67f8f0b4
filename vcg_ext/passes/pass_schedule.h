// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "vcg_ext/collapse/collapse_plan.h"
#include "vcg_ext/passes/pass_collapses.h"

namespace curvdecim::detail {

/// Collapses edges in passes over flat arrays, on all cores:
///
///   while the surface has more faces than the goal, and passes are worth while:
///     fans  <- the faces around every vertex                                    (fan_lists.h)
///     ranks <- every vertex proposes an edge, at about what it costs            (pass_ranks.h)
///     limit <- a share of the ranks
///     collapse what costs no more, as the surface is then, and no guard refuses (fan_collapse.h),
///       in the last pass in order
///     close the gaps
///
/// Only vertices inside smooth places take part; the others are held. They would have collapsed as
/// well where they are cheap, so that passes end where too many are among the vertices.
template <class MetricType>
class PassSchedule {
 public:
  PassSchedule(PassSurface& surface, const MetricType& metric, const CollapsePlan& plan,
               const Parallel& parallel)
      : surface_(surface), metric_(metric), plan_(plan), parallel_(parallel) {}

  /// record: gets the steps. Throws CancelRequest.
  void run(BlendRecord& record) {
    while (step(record)) continue;
  }

  /// One pass, if one is to come; false: no other is worth while.
  bool step(BlendRecord& record) {
    if (faces_to_go() <= 0 || !surface_.is_mostly_free()) return false;
    const int before = surface_.face_count();
    const int expected = std::min(faces_to_go(), static_cast<int>(usual_share * before));
    parallel_.progress().along(plan_.stop.progress(before), plan_.stop.progress(before - expected),
                               [&] { pass(record); });
    return before - surface_.face_count() > least_share * before;
  }

  /// What the dearest collapse of the last pass cost.
  double largest_cost() const { return largest_cost_; }

 private:
  static constexpr double share = 0.7;         // of the proposals, to be asked about in a pass
  static constexpr double usual_share = 0.32;  // of the faces, that go then
  static constexpr double least_share = 0.02;  // of the faces: fewer are not worth a pass

  int faces_to_go() const { return surface_.face_count() - plan_.schedule.passes_goal; }

  void pass(BlendRecord& record) {
    ProgressMeter& progress = parallel_.progress();  // parts of the time of a pass
    progress.along(0.0, 0.25, [&] {
      const auto is_free = [&](int v) { return surface_.held[v] == 0; };
      fans_.build(surface_.faces, surface_.vertex_count(), parallel_, is_free);
    });
    progress.along(0.25, 0.6, [&] { ranks_.measure(surface_, fans_, parallel_); });
    progress.along(0.6, 1.0, [&] {
      const int needed = (faces_to_go() + 1) / 2;  // each takes two faces
      const bool is_last = faces_to_go() <= usual_share * surface_.face_count();
      const float limit = ranks_.choose(is_last ? surface_.vertex_count() : needed, share);
      PassCollapses collapses(surface_, fans_, ranks_, metric_, plan_.limits.faces, record);
      if (is_last)
        collapses.run_in_order(needed, limit, parallel_, record.first_steps());
      else
        collapses.run(limit, parallel_, record.first_steps());
      largest_cost_ = collapses.largest_cost();
      surface_.close_gaps(collapses.into(), parallel_);
    });
  }

  PassSurface& surface_;
  const MetricType& metric_;
  const CollapsePlan& plan_;
  const Parallel& parallel_;
  FanLists fans_;
  PassRanks ranks_;
  double largest_cost_ = 0.0;
};

}  // namespace curvdecim::detail
