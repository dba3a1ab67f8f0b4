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
/// curvature at both ends, with ModelUnits at one end and none at the other. Throws InputError.
template <class MeshType>
void curvature_importance(MeshType& mesh, const ImportanceParams& params) {
  using namespace detail;
  validate(params);
  const Parallel parallel(0);
  const WorkingCopy copy = read_mesh(mesh, false, parallel);
  write_quality(mesh, copy.vertex_of,
                importance_of(copy.mesh, params, copy.box.diagonal, parallel));
}

}  // namespace curvdecim
