// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "vcg_ext/curvature/curvature_field.h"
#include "vcg_ext/curvature/curvature_weight.h"
#include "vcg_ext/metric/metric_plan.h"

namespace curvdecim::detail {

/// By vertex: how much an error there counts with the plan's metric, but for its importance.
inline std::vector<double> error_weights(const WorkingMesh& mesh, const MetricPlan& plan,
                                         const Parallel& parallel) {
  std::vector<double> weights(mesh.position.size(), 1.0);
  const auto* weighted = std::get_if<CurvatureWeightedPlan>(&plan);
  if (!weighted) return weights;
  const CurvatureField field = curvature_field(mesh, weighted->curvature, parallel);
  const CurvatureWeight weight = curvature_weight(weighted->curvature, field, weighted->diagonal);
  for (std::size_t v = 0; v < weights.size(); ++v) {
    const double saturation = weight.saturation(field.value[v]);
    weights[v] = weight.of_edge(saturation, saturation);
  }
  return weights;
}

}  // namespace curvdecim::detail
