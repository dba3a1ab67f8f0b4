// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/decimate_by_collapse.h"
#include "vcg_ext/metric/built_in_metrics.h"
#include "vcg_ext/params.h"
#include "vcg_ext/report.h"

namespace curvdecim {

/// Decimates a vcg triangle mesh by edge collapse, in place.
///
/// The mesh needs faces with vertex references and selection flags; no adjacency. Whatever vertex
/// attributes it has are carried. It is left exactly as it was when the parameters or the mesh
/// cannot be used (throws InputError), when it is already small enough, and when `progress` asks to
/// stop (the report says Cancelled). It may stop short of the target; the report says why.
///
/// Worst case: time O(n log n) for bounded valence, 310 bytes of memory a vertex.
template <class MeshType>
DecimationReport decimate_edge_collapse(MeshType& mesh, const EdgeCollapseParams& params,
                                        const Progress& progress = {}) {
  return detail::decimate_by_collapse(mesh, params, progress, detail::WithBuiltInMetric());
}

}  // namespace curvdecim
