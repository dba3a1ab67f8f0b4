// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/quadric.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/params.h"

namespace curvdecim {

/// The plane of a face about any of its corners, which it passes through.
inline Symmetric3 plane_matrix(const FacePlane& plane, PlaneWeight weight) {
  return Symmetric3::outer(plane.normal, weight == PlaneWeight::Area ? plane.area : 1.0);
}

/// Sum of the area vectors of the faces around v: how the volume below the faces grows with v.
inline Vector3 volume_gradient(const WorkingMesh& mesh, int v) {
  Vector3 sum = Vector3::Zero();
  for (int f : mesh.connectivity.faces_of(v)) sum += mesh.plane[f].area_vector();
  return sum;
}

}  // namespace curvdecim
