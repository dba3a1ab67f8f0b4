// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <utility>

#include "vcg_ext/attributes/carried.h"
#include "vcg_ext/collapse/collapse_plan.h"
#include "vcg_ext/collapse/round_schedule.h"
#include "vcg_ext/collapse/strict_schedule.h"
#include "vcg_ext/passes/collapse_in_passes.h"

namespace curvdecim::detail {

/// The last part of the preparation.
template <class MetricType>
void initialize(MetricType& metric, const Parallel& parallel) {
  constexpr double reading = 0.6;  // part of the time
  parallel.progress().along(reading, 1.0, [&] { metric.initialize(parallel); });
}

/// Collapses edges of the mesh, the cheapest first, as far as the plan says:
///
///   collapse in passes, on all cores, where they can compute as the metric does
///                                                                    (passes/pass_schedule.h)
///   collapse in rounds, on all cores, while they are worth while     (round_schedule.h)
///   pair_distance? vertices that close are edges, too                (vertex_pairs.h)
///   collapse the rest in strict order                                (strict_schedule.h)
///
/// MetricType: metric/metric.h. Throws CancelRequest, and InputError where there are too many
/// pairs.
template <class MetricType>
Tally collapse_edges(WorkingMesh& mesh, MetricType& metric, const CollapsePlan& plan,
                     Carried& carried, const Parallel& parallel) {
  Tally tally;
  initialize(metric, parallel);
  plan.times.begin_steps("Collapsing edges", parallel.progress());
  int next_number = 0;
  if (carried.is_by_vertex())
    next_number = collapse_in_passes(mesh, metric, plan, carried.blended, parallel);
  CollapseOperator<MetricType> collapses(mesh, metric, plan.limits, {mesh, plan.cost_unit},
                                         carried.collapse_observers());
  HubRests<MetricType> rests(mesh, collapses);
  if (const double share = plan.schedule.round_share; share > 0.0)
    next_number =
        RoundSchedule(mesh, collapses, rests, plan.stop, share, next_number, parallel).run(tally);
  if (plan.pair_distance > 0.0)
    collapses.add_pairs(VertexPairs(mesh, plan.pair_distance, parallel));
  StrictSchedule(mesh, collapses, rests, plan.stop, plan.schedule.eager, next_number)
      .run(parallel, tally);
  assert((mesh.connectivity.validate(), true));
  return tally;
}

}  // namespace curvdecim::detail
