// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "vcg_ext/collapse/collapse_edges.h"
#include "vcg_ext/host_mesh/read_carried.h"
#include "vcg_ext/host_mesh/read_mesh.h"
#include "vcg_ext/host_mesh/write_back.h"
#include "vcg_ext/mesh/crossings.h"
#include "vcg_ext/passes/collapse_in_passes.h"
#include "vcg_ext/refine/refine.h"
#include "vcg_ext/run/conclude.h"
#include "vcg_ext/run/plan_collapse.h"
#include "vcg_ext/run/plan_reading.h"
#include "vcg_ext/run/run.h"

namespace curvdecim::detail {

/// Collapses edges in passes, on all cores, where they can compute as the metric does
/// (passes/pass_schedule.h), and the rest in rounds and in strict order
/// (collapse/collapse_edges.h). bound: nullptr without one. Throws CancelRequest, and InputError
/// where there are too many pairs.
template <class MetricType>
Tally collapse(WorkingMesh& mesh, MetricType& metric, const CollapsePlan& plan, Carried& carried,
               SurfaceBound* bound, const Parallel& parallel) {
  constexpr double reading = 0.6;  // part of the time of the preparation
  std::optional<PassSurface> surface;
  parallel.progress().along(reading, 1.0, [&] { surface = prepare(mesh, metric, plan, parallel); });
  plan.times.begin_steps("Collapsing edges", parallel.progress());
  Tally tally;
  const int next_number = surface ? collapse_in_passes(*std::move(surface), mesh, metric, plan,
                                                       carried.blended, bound, parallel, tally)
                                  : 0;
  collapse_edges(mesh, metric, plan, carried.collapse_observers(), next_number, bound, parallel,
                 tally);
  return tally;
}

/// The bound that the plan has, if there are faces to hold to it.
inline std::optional<SurfaceBound> bound_of(const WorkingMesh& mesh, const CollapseLimits& limits,
                                            const Parallel& parallel) {
  if (limits.max_error == 0.0 || mesh.connectivity.face_count() == 0) return std::nullopt;
  return std::optional<SurfaceBound>(std::in_place, mesh, limits.max_error,
                                     limits.max_error_one_sided, parallel);
}

/// Counts the faces that cross others.
inline void report_crossings(const WorkingMesh& result, const Run<DecimationReport>& run) {
  const auto pairs = crossing_pairs(result, result.connectivity.face_slots(), run.parallel);
  run.report.crossing = static_cast<std::int64_t>(faces_of(pairs).size());
  note_crossings(run.report);
}

/// The one way of every edge collapse: read, plan, collapse, refine, write. Nothing of the host's
/// mesh changes before the last step. Params: what plan_collapse takes. with_metric(mesh, plan,
/// use) calls use(metric) and returns what it returns. Throws InputError.
template <class MeshType, class Params, class WithMetric>
DecimationReport decimate_by_collapse(MeshType& mesh, const Params& params,
                                      const Progress& progress, WithMetric with_metric) {
  return reported<DecimationReport>(counts_of(mesh), params, progress, [&](const auto& run) {
    if (const auto ahead = plan_collapse(params, facts_ahead(counts_of(mesh))))
      ahead->times.begin_preparing(run.parallel.progress());
    const ReadingPlan reading = plan_reading(params);
    WorkingCopy copy = read_mesh(mesh, reading, run.parallel);
    const InputFacts facts = facts_of(mesh, copy, params.selected_only);
    const auto plan = plan_collapse(params, facts);
    auto traced = traced_input(mesh, copy, params.keep_map, run.parallel);
    if (!plan) return leave_alone(mesh, reached_target(params, facts), traced, run);
    run.parallel.progress().ask();
    Carried carried = read_carried(mesh, copy, reading, *plan, run.parallel, run.report);
    std::optional<InputCopy> input = keep_input(copy.mesh, *plan, run.parallel);
    std::optional<SurfaceBound> bound = bound_of(copy.mesh, plan->limits, run.parallel);
    SurfaceBound* const or_none = bound ? &*bound : nullptr;
    run.parallel.progress().ask();
    Tally tally = with_metric(copy.mesh, plan->metric, [&](auto metric) {
      return collapse(copy.mesh, metric, *plan, carried, or_none, run.parallel);
    });
    refine(copy.mesh, std::move(input), *plan, or_none, carried, run.parallel, tally);
    if (plan->limits.prevents_crossings) report_crossings(copy.mesh, run);
    write_back(mesh, copy, carried, std::move(traced), run.parallel, run.report);
    conclude(tally, *plan, copy.mesh, copy.box.diagonal, run.report);
  });
}

}  // namespace curvdecim::detail
