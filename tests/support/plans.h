// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/metric/built_in_metrics.h"
#include "vcg_ext/run/plan_collapse.h"

namespace curvdecim::test {

using namespace detail;

// Metrics as parameters ask for them, on a mesh whose own unit is that of its positions.

inline QuadricMetric quadric_metric(const WorkingMesh& mesh, const EdgeCollapseParams& params,
                                    bool keeps_links = true) {
  return {mesh, quadric_plan(params, params, keeps_links)};
}

inline CurvatureWeightedMetric weighted_metric(const WorkingMesh& mesh, EdgeCollapseParams params) {
  params.metric = Metric::CurvatureWeighted;
  return {mesh, std::get<CurvatureWeightedPlan>(metric_plan(params, true, 1.0))};
}

inline CurvatureAdditiveMetric additive_metric(const WorkingMesh& mesh, EdgeCollapseParams params) {
  params.metric = Metric::CurvatureAdditive;
  return {mesh, std::get<CurvatureAdditivePlan>(metric_plan(params, true, 1.0))};
}

/// The limits of a run, lengths in the unit of the positions. keeps_links: false as with pairs.
inline CollapseLimits limits_of(const DecimationParams& params, bool keeps_links = true,
                                bool gives_way = false) {
  return {{params.preserve_normal, params.normal_angle},
          keeps_links,
          params.preserve_boundary,
          gives_way,
          params.max_error,
          params.max_error_one_sided};
}

}  // namespace curvdecim::test
