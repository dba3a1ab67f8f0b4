// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "vcg_ext/removal/removal_plan.h"
#include "vcg_ext/run/target.h"

namespace curvdecim::detail {

/// The smaller of both bounds on the accumulated error; 0: there is none.
inline double tighter_bound(const VertexRemovalParams& params) {
  const auto [low, high] = std::minmax(params.max_error, params.distance_bound);
  return low > 0.0 ? low : high;
}

/// The plan without a target. diagonal: of the bounding box, in the mesh's unit.
inline RemovalPlan plan_without_target(const VertexRemovalParams& params, double diagonal) {
  RemovalPlan plan;
  plan.faces = {params.preserve_normal, params.normal_angle};
  plan.criterion = params.criterion;
  plan.max_error = tighter_bound(params) / diagonal;
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
