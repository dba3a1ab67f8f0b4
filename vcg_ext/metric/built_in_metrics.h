// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "vcg_ext/metric/anchored_sphere_metric.h"
#include "vcg_ext/metric/curvature_additive_metric.h"
#include "vcg_ext/metric/curvature_weighted_metric.h"
#include "vcg_ext/metric/interpolated_sphere_metric.h"
#include "vcg_ext/metric/metric.h"
#include "vcg_ext/metric/metric_plan.h"
#include "vcg_ext/metric/quadric_metric.h"

namespace curvdecim::detail {

inline QuadricMetric make_metric(const WorkingMesh& mesh, const QuadricPlan& plan) {
  return {mesh, plan};
}
inline CurvatureWeightedMetric make_metric(const WorkingMesh& mesh,
                                           const CurvatureWeightedPlan& plan) {
  return {mesh, plan};
}
inline CurvatureAdditiveMetric make_metric(const WorkingMesh& mesh,
                                           const CurvatureAdditivePlan& plan) {
  return {mesh, plan};
}
inline AnchoredSphereMetric make_metric(const WorkingMesh& mesh, const AnchoredSpherePlan& plan) {
  return {mesh, plan};
}
inline InterpolatedSphereMetric make_metric(const WorkingMesh& mesh,
                                            const InterpolatedSpherePlan& plan) {
  return {mesh, plan};
}

/// Calls use(metric) with the metric of the plan, and returns what it returns: the one place where
/// a choice at run time becomes a type. mesh and plan must outlive the call.
struct WithBuiltInMetric {
  template <class Use>
  auto operator()(const WorkingMesh& mesh, const MetricPlan& plan, Use use) const {
    return std::visit([&](const auto& chosen) { return use(make_metric(mesh, chosen)); }, plan);
  }
};

}  // namespace curvdecim::detail
