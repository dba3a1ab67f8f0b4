// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <utility>

#include "vcg_ext/collapse/collapse_plan.h"
#include "vcg_ext/collapse/round_schedule.h"
#include "vcg_ext/collapse/strict_schedule.h"

namespace curvdecim::detail {

/// From now on the bound of the error is measured, if that is possible.
template <class MetricType>
void begin_measuring(SurfaceBound& bound, const WorkingMesh& mesh,
                     CollapseOperator<MetricType>& collapses, HubRests<MetricType>& rests,
                     const Parallel& parallel, Tally& tally) {
  if (!bound.has_begun()) {
    const Renumbering without_gaps(mesh.connectivity);
    collapses.renumber(without_gaps), rests.renumber(without_gaps);
    if (!bound.begin(mesh, mesh.connectivity.face_slots(), parallel))
      return collapses.bound().rely_on_sums();
    tally.note_error(bound.at_start());
  }
  collapses.bound().measure_with(bound);
}

/// Collapses edges of the mesh, the cheapest first, as far as the plan says:
///
///   collapse in rounds, on all cores, while they are worth while     (round_schedule.h)
///   pair_distance? vertices that close are edges, too                (vertex_pairs.h)
///   max_error? measure the distance from now on                      (guard/surface_bound.h)
///   collapse the rest in strict order                                (strict_schedule.h)
///
/// metric: initialized; MetricType: metric/metric.h. next_number: of the first collapse. bound:
/// nullptr without one; where it has begun there are no rounds. Throws CancelRequest, and
/// InputError where there are too many pairs.
template <class MetricType>
void collapse_edges(WorkingMesh& mesh, MetricType& metric, const CollapsePlan& plan,
                    CollapseObservers observers, int next_number, SurfaceBound* bound,
                    const Parallel& parallel, Tally& tally) {
  CollapseOperator<MetricType> collapses(mesh, metric, plan.limits, {mesh, plan.cost_unit},
                                         std::move(observers));
  if (plan.limits.prevents_crossings) collapses.prevent_crossings(parallel);
  HubRests<MetricType> rests(mesh, collapses);
  const double share = bound && bound->has_begun() ? 0.0 : plan.schedule.round_share;
  if (share > 0.0)
    next_number =
        RoundSchedule(mesh, collapses, rests, plan.stop, share, next_number, parallel).run(tally);
  if (plan.pair_distance > 0.0)
    collapses.add_pairs(VertexPairs(mesh, plan.pair_distance, parallel));
  if (bound && !plan.stop.reached(mesh.connectivity))
    begin_measuring(*bound, mesh, collapses, rests, parallel, tally);
  StrictSchedule(mesh, collapses, rests, plan.stop, plan.schedule.eager, next_number)
      .run(parallel, tally);
  assert((mesh.connectivity.validate(), true));
}

}  // namespace curvdecim::detail
