// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/decimate_by_collapse.h"
#include "vcg_ext/metric/built_in_metrics.h"
#include "vcg_ext/params.h"
#include "vcg_ext/report.h"

namespace curvdecim {

/// Decimates a vcg triangle mesh by edge collapse, in place, by how far it is from algebraic
/// spheres
/// @cite michaud2017.
///
/// What the mesh needs and when it is left as it was: decimate_edge_collapse.
///
/// Worst case: time O(n log n) for bounded valence, 500 bytes of memory a vertex.
template <class MeshType>
DecimationReport decimate_algebraic_sphere(MeshType& mesh, const SphereParams& params,
                                           const Progress& progress = {}) {
  return detail::decimate_by_collapse(mesh, params, progress, detail::WithBuiltInMetric());
}

}  // namespace curvdecim
