// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/host_mesh/attributes.h"
#include "vcg_ext/host_mesh/read_mesh.h"
#include "vcg_ext/params.h"
#include "vcg_ext/run/importance.h"
#include "vcg_ext/run/validation.h"

namespace curvdecim {

/// Writes to the quality of every vertex of a face the curvature that CurvatureWeighted sees, in
/// the mesh's unit, or the factor that it makes of it: with ScaleFree that of an edge with this
/// curvature at both ends, with ModelUnits at one end and none at the other. False where `progress`
/// asked to stop: the mesh is as it was. Throws InputError.
template <class MeshType>
bool curvature_importance(MeshType& mesh, const ImportanceParams& params,
                          const Progress& progress = {}) {
  using namespace detail;
  validate(params);
  try {
    const Parallel parallel(0, progress);
    importance_times.begin_preparing(parallel.progress());
    const WorkingCopy copy = read_mesh(mesh, false, parallel);
    importance_times.begin_steps("Computing curvature", parallel.progress());
    const auto values = importance_of(copy.mesh, params, copy.box.diagonal, parallel);
    parallel.progress().ask();
    write_quality(mesh, copy.vertex_of, values);
    return true;
  } catch (const CancelRequest&) {
    return false;
  }
}

}  // namespace curvdecim
