// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/decimate_by_collapse.h"
#include "vcg_ext/metric/metric.h"
#include "vcg_ext/params.h"
#include "vcg_ext/report.h"

namespace curvdecim {

/// Decimates a vcg triangle mesh by edge collapse, in place, by a metric of your own.
///
/// make_metric(mesh) gives the metric, whose contract is in vcg_ext/metric/metric.h; mesh is the
/// metric_api::WorkingMesh of the run, in a box of diagonal 1, and outlives the metric. The
/// built-in ones in vcg_ext/metric/ can be parts of it. examples/own_metric.cpp is a whole one.
///
/// What the mesh needs and when it is left as it was: decimate_edge_collapse.
template <class MeshType, class MakeMetric>
DecimationReport decimate_by_metric(MeshType& mesh, const DecimationParams& params,
                                    MakeMetric make_metric, const Progress& progress = {}) {
  return detail::decimate_by_collapse(
      mesh, params, progress,
      [&](const detail::WorkingMesh& working, const detail::MetricPlan&, auto use) {
        return use(make_metric(working));
      });
}

}  // namespace curvdecim
