// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <variant>

#include "vcg_ext/collapse/collapse_plan.h"
#include "vcg_ext/run/target.h"

namespace curvdecim::detail {

/// More sweeps take off half a per cent of the error.
inline constexpr int best_refine_sweeps = 3;

/// The parameters with the named settings of their preset; Custom leaves all as it is.
inline EdgeCollapseParams with_preset(EdgeCollapseParams params) {
  if (params.preset == Preset::Custom) return params;
  static_cast<QuadricParams&>(params) = QuadricParams();
  params.scheduler = params.preset == Preset::Fast ? Scheduler::FewRounds : Scheduler::Rounds;
  params.refine_sweeps = params.preset == Preset::Best ? best_refine_sweeps : 0;
  return params;
}

/// Without the link condition a collapse may remove more faces than a round counts on: no rounds.
inline Schedule schedule_of(Scheduler scheduler, bool keeps_topology) {
  constexpr double few_candidates = 0.3, many_candidates = 0.8;  // docs/decisions/rounds.md
  Schedule schedule;
  schedule.eager = scheduler == Scheduler::Eager;
  if (keeps_topology && scheduler == Scheduler::Rounds) schedule.round_share = few_candidates;
  if (keeps_topology && scheduler == Scheduler::FewRounds) schedule.round_share = many_candidates;
  return schedule;
}

/// At the end of a run single collapses count, and what passes hold has its turn; the less of it,
/// the faster (docs/decisions/passes.md).
inline int passes_goal(Scheduler scheduler, const StopCriterion& stop, bool is_bounded) {
  struct Goal {
    double least;  // faces: on smaller meshes single collapses count
    double times_target;
  };
  constexpr Goal fast{1000.0, 1.1}, others{10000.0, 1.25};
  if (scheduler != Scheduler::Rounds && scheduler != Scheduler::FewRounds) return no_passes;
  const Goal goal = scheduler == Scheduler::FewRounds || is_bounded ? fast : others;
  const double target = stop.start - stop.faces_to_go();
  return static_cast<int>(std::max(goal.least, goal.times_target * target));
}

inline QuadricPlan quadric_plan(const DecimationParams& params, const QuadricParams& quadrics,
                                bool keeps_topology) {
  constexpr double seam_share = 0.2;  // of a boundary's weight (docs/decisions/seams.md)
  return {quadrics, params.boundary_weight, params.feature_angle, keeps_topology,
          seam_share * params.boundary_weight};
}

inline MetricPlan metric_plan(const EdgeCollapseParams& params, bool keeps_topology,
                              double diagonal) {
  const QuadricPlan quadrics = quadric_plan(params, params, keeps_topology);
  switch (params.metric) {
    case Metric::CurvatureWeighted: return CurvatureWeightedPlan{quadrics, params, diagonal};
    case Metric::CurvatureAdditive:
      return CurvatureAdditivePlan{quadrics, params.lambda, params.curvature_term};
    case Metric::Quadric: break;
  }
  return quadrics;
}

inline MetricPlan metric_plan(const SphereParams& params) {
  const SpherePlan spheres{quadric_plan(params, QuadricParams(), true), params, params.energy};
  if (params.placement == SpherePlacement::Free3D) return AnchoredSpherePlan{spheres};
  return InterpolatedSpherePlan{spheres};
}

/// The rest of the plan is made.
inline Timetable collapse_times(const CollapsePlan& plan) {
  const bool has_spheres = std::holds_alternative<AnchoredSpherePlan>(plan.metric) ||
                           std::holds_alternative<InterpolatedSpherePlan>(plan.metric);
  const double faces = plan.stop.start, gone = plan.stop.faces_to_go();
  const double in_passes = std::clamp(faces - plan.schedule.passes_goal, 0.0, gone);
  const double sweep = 500.0 * faces + 3800.0 * (faces - gone);
  return {(has_spheres ? 780.0 : 330.0) * faces, 350.0 * in_passes + 1600.0 * (gone - in_passes),
          sweep * plan.refine_sweeps, 140.0 * faces};
}

/// What every run of collapses has, whatever its metric; nullopt: the mesh is small enough.
inline std::optional<CollapsePlan> plan_collapse(const DecimationParams& params,
                                                 const InputFacts& input) {
  const std::optional<StopCriterion> stop = stop_criterion(params, input);
  if (!stop) return std::nullopt;
  CollapsePlan plan;
  plan.stop = *stop;
  plan.limits.faces = {params.preserve_normal, params.normal_angle};
  plan.limits.keeps_boundary = params.preserve_boundary;
  plan.limits.topology_gives_way = !params.preserve_topology && !(params.max_error > 0.0);
  plan.limits.max_error = bound_in_box(params.max_error, input.rounding, input.diagonal);
  plan.limits.max_error_one_sided = params.max_error_one_sided;
  plan.limits.prevents_crossings = params.prevent_intersections;
  plan.rounding = input.rounding;
  plan.limits.attribute_weight = params.attribute_weight;
  plan.metric = quadric_plan(params, QuadricParams(), true);
  plan.schedule = schedule_of(Scheduler::Rounds, true);
  plan.boundary_weight = params.boundary_weight;
  plan.times = collapse_times(plan);
  return plan;
}

inline std::optional<CollapsePlan> plan_collapse(const EdgeCollapseParams& requested,
                                                 const InputFacts& input) {
  const EdgeCollapseParams params = with_preset(requested);
  const bool keeps_links = !(params.pair_distance > 0.0);  // pairs join parts
  std::optional<CollapsePlan> plan =
      plan_collapse(static_cast<const DecimationParams&>(params), input);
  if (!plan) return plan;
  plan->metric = metric_plan(params, keeps_links, input.diagonal);
  plan->schedule = schedule_of(params.scheduler, keeps_links);
  plan->limits.keeps_topology = keeps_links;
  plan->limits.topology_gives_way = plan->limits.topology_gives_way && keeps_links;
  if (params.plane_weight == PlaneWeight::Unit) plan->cost_unit = CostUnit::SquaredLength;
  plan->pair_distance = params.pair_distance / input.diagonal;
  if (keeps_links)
    plan->schedule.passes_goal = passes_goal(params.scheduler, plan->stop, params.max_error > 0.0);
  if (params.placement != Placement::HalfEdge) plan->refine_sweeps = params.refine_sweeps;
  plan->times = collapse_times(*plan);
  return plan;
}

/// Interpolated spheres have no estimate that is cheaper than the cost itself: no rounds.
inline std::optional<CollapsePlan> plan_collapse(const SphereParams& params,
                                                 const InputFacts& input) {
  std::optional<CollapsePlan> plan =
      plan_collapse(static_cast<const DecimationParams&>(params), input);
  if (!plan) return plan;
  plan->metric = metric_plan(params);
  if (params.energy == SphereEnergy::Poster) plan->cost_unit = CostUnit::AreaTimesLength;
  if (params.placement != SpherePlacement::Free3D) plan->schedule = {};
  plan->refine_sweeps = params.refine_sweeps;
  plan->times = collapse_times(*plan);
  return plan;
}

}  // namespace curvdecim::detail
