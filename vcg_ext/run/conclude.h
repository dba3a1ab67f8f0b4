// SPDX-License-Identifier: GPL-3.0-or-later
// The end of a run: what it came to, in the user's unit.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "vcg_ext/clustering/clustering_operator.h"
#include "vcg_ext/collapse/collapse_plan.h"
#include "vcg_ext/mesh/tally.h"
#include "vcg_ext/removal/removal_plan.h"
#include "vcg_ext/run/notes.h"
#include "vcg_ext/run/stop_reasons.h"

namespace curvdecim::detail {

/// diagonal: of the bounding box, in the mesh's unit.
inline void conclude(const Tally& tally, double diagonal, DecimationReport& report) {
  report.stopped_by = tally.stopped_by;
  report.max_error = diagonal * tally.largest_error;
  report.cost_last = tally.cost_last;
  report.rejected = tally.rejected;
}

/// mesh: after the run.
inline void conclude(const Tally& tally, const CollapsePlan& plan, const WorkingMesh& mesh,
                     double diagonal, DecimationReport& report) {
  report.pairs_contracted = tally.pairs_contracted;
  report.parts_removed = tally.parts_removed;
  report.holes_closed = tally.holes_closed;
  report.handles_cut = tally.handles_cut;
  report.junctions_parted = tally.junctions_parted;
  report.largest_removed = diagonal * tally.largest_removed;
  if (plan.pair_distance > 0.0) note_pairs(mesh, report);
  note_what_gave_way(report);
  conclude(tally, diagonal, report);
  if (report.max_error > 0.0) report.max_error += plan.rounding;
  note_stop(tally, plan, mesh, report);
}

/// mesh: after the run.
inline void conclude(const Tally& tally, const RemovalPlan& plan, const WorkingMesh& mesh,
                     double diagonal, DecimationReport& report) {
  conclude(tally, diagonal, report);
  note_stop(tally, plan, mesh, report);
}

/// Says so where the number of faces is not the target.
inline void judge_target(int target, int left, ClusteringReport& report) {
  constexpr double tolerance = 0.02;  // of the target
  if (target == 0 || std::abs(left - target) <= tolerance * target) return;
  report.stopped_by = StopReason::NothingLeft;
  report.notes.push_back("No size of the cells leaves a number of faces nearer to the target " +
                         std::to_string(target) + " than " + std::to_string(left) +
                         ": many come and go together.");
}

/// Says so where a size of the cells was given that joins nothing.
inline void judge_size(const ClusteringPlan& plan, const FlatMesh& mesh, const Clusters& clusters,
                       ClusteringReport& report) {
  if (plan.target > 0 || static_cast<int>(clusters.faces.size()) < mesh.face_count) return;
  report.stopped_by = StopReason::NothingLeft;
  report.notes.push_back("No edge has both ends in one cell: take larger cells, or a target.");
}

inline void conclude(const Clustering& clustering, const ClusteringPlan& plan, const FlatMesh& mesh,
                     ClusteringReport& report) {
  const Clusters& clusters = clustering.clusters;
  report.cell_size = clusters.diameter * mesh.box.diagonal;
  report.cost_last = clustering.representatives.largest_cost;
  report.degenerate = mesh.face_count - clusters.crossing;
  report.crowded = clusters.crowded;
  report.duplicate =
      clusters.crossing - clusters.crowded - static_cast<std::int64_t>(clusters.faces.size());
  if (plan.max_error > 0.0)
    report.max_error = clustering.distance * mesh.box.diagonal + plan.rounding;
  if (clustering.is_bounded) return void(report.stopped_by = StopReason::ErrorBound);
  judge_target(plan.target, static_cast<int>(clusters.faces.size()), report);
  judge_size(plan, mesh, clusters, report);
}

}  // namespace curvdecim::detail
