// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "vcg_ext/removal/removal_plan.h"
#include "vcg_ext/run/target.h"

namespace curvdecim::detail {

/// The plan without a target. diagonal: of the bounding box, in the mesh's unit.
inline RemovalPlan plan_without_target(const VertexRemovalParams& params, double diagonal) {
  RemovalPlan plan;
  plan.faces = {params.preserve_normal, params.normal_angle};
  plan.criterion = params.criterion;
  plan.max_sum = params.distance_bound / diagonal;
  plan.max_error = params.max_error / diagonal;  // what stays does not move, nor is it rounded
  plan.max_error_one_sided = params.max_error_one_sided;
  plan.aspect_ratio_min = params.aspect_ratio_min;
  plan.feature_angle = params.feature_angle;
  plan.preserve_features = params.preserve_features;
  plan.preserve_boundary = params.preserve_boundary;
  plan.boundary_weight = params.boundary_weight;
  return plan;
}

/// nullopt: the mesh is small enough as it is.
inline std::optional<RemovalPlan> plan_removal(const VertexRemovalParams& params,
                                               const InputFacts& input) {
  const std::optional<StopCriterion> stop = stop_criterion(params, input);
  if (!stop) return std::nullopt;
  RemovalPlan plan = plan_without_target(params, input.diagonal);
  plan.stop = *stop;
  plan.times = {200.0 * stop->start, 6700.0 * stop->faces_to_go(), 0.0, 110.0 * stop->start};
  return plan;
}

}  // namespace curvdecim::detail
