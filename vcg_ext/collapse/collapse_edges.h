// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <utility>

#include "vcg_ext/collapse/collapse_plan.h"
#include "vcg_ext/collapse/round_schedule.h"
#include "vcg_ext/collapse/strict_schedule.h"

namespace curvdecim::detail {

/// Collapses edges of the mesh, the cheapest first, as far as the plan says:
///
///   collapse in rounds, on all cores, while they are worth while     (round_schedule.h)
///   pair_distance? vertices that close are edges, too                (vertex_pairs.h)
///   collapse the rest in strict order                                (strict_schedule.h)
///
/// metric: initialized; MetricType: metric/metric.h. next_number: of the first collapse. Throws
/// CancelRequest, and InputError where there are too many pairs.
template <class MetricType>
void collapse_edges(WorkingMesh& mesh, MetricType& metric, const CollapsePlan& plan,
                    CollapseObservers observers, int next_number, const Parallel& parallel,
                    Tally& tally) {
  CollapseOperator<MetricType> collapses(mesh, metric, plan.limits, {mesh, plan.cost_unit},
                                         std::move(observers));
  HubRests<MetricType> rests(mesh, collapses);
  if (const double share = plan.schedule.round_share; share > 0.0)
    next_number =
        RoundSchedule(mesh, collapses, rests, plan.stop, share, next_number, parallel).run(tally);
  if (plan.pair_distance > 0.0)
    collapses.add_pairs(VertexPairs(mesh, plan.pair_distance, parallel));
  StrictSchedule(mesh, collapses, rests, plan.stop, plan.schedule.eager, next_number)
      .run(parallel, tally);
  assert((mesh.connectivity.validate(), true));
}

}  // namespace curvdecim::detail
