// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "vcg_ext/metric/anchored_sphere_metric.h"
#include "vcg_ext/metric/curvature_additive_metric.h"
#include "vcg_ext/metric/curvature_weighted_metric.h"
#include "vcg_ext/metric/interpolated_sphere_metric.h"
#include "vcg_ext/metric/quadric_metric.h"

namespace curvdecim {

/// Calls use(metric) with the metric that the parameters name.
template <class Use>
void with_metric(const WorkingMesh& mesh, const EdgeCollapseParams& params, double diagonal,
                 Use use) {
  switch (params.metric) {
    case Metric::Quadric: return use(QuadricMetric(mesh, params));
    case Metric::CurvatureWeighted: return use(CurvatureWeightedMetric(mesh, params, diagonal));
    case Metric::CurvatureAdditive: return use(CurvatureAdditiveMetric(mesh, params));
  }
}

template <class Use>
void with_metric(const WorkingMesh& mesh, const SphereParams& params, double, Use use) {
  switch (params.placement) {
    case SpherePlacement::Free3D: return use(AnchoredSphereMetric(mesh, params));
    case SpherePlacement::OnSphereAlongEdge: return use(InterpolatedSphereMetric(mesh, params));
  }
}

inline Scheduler scheduler_of(const EdgeCollapseParams& params) { return params.scheduler; }

/// Interpolated spheres have no estimate that is cheaper than the cost itself.
inline Scheduler scheduler_of(const SphereParams& params) {
  return params.placement == SpherePlacement::Free3D ? Scheduler::Rounds : Scheduler::Lazy;
}

inline double pair_distance_of(const EdgeCollapseParams& params) { return params.pair_distance; }
inline double pair_distance_of(const SphereParams&) { return 0.0; }

/// More take off half a per cent of the error.
inline constexpr int best_refine_sweeps = 3;

/// The named settings; Custom leaves all as it is.
inline EdgeCollapseParams with_preset(EdgeCollapseParams params) {
  if (params.preset == Preset::Custom) return params;
  params.quadrics = Quadrics::Memoryless;
  params.plane_weight = PlaneWeight::Area;
  params.placement = Placement::Optimal;
  params.scheduler = params.preset == Preset::Fast ? Scheduler::FewRounds : Scheduler::Rounds;
  params.refine_sweeps = params.preset == Preset::Best ? best_refine_sweeps : 0;
  return params;
}

}  // namespace curvdecim
