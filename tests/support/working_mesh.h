// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/shape.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::test {

inline TriangleConnectivity connectivity_of(const Shape& shape) {
  return {shape.faces, shape.vertex_count()};
}

/// The shape as the operators see it, without the way to the unit box: in its own unit.
inline WorkingMesh working_mesh(const Shape& shape) {
  WorkingMesh mesh;
  mesh.position = shape.vertices;
  mesh.connectivity = connectivity_of(shape);
  mesh.kind = classify_vertices(mesh.connectivity, Parallel(1));
  mesh.locked.assign(shape.vertices.size(), false);
  mesh.plane.resize(shape.faces.size());
  for (int f = 0; f < shape.face_count(); ++f) mesh.update_plane(f);
  return mesh;
}

inline Shape shape_of(const WorkingMesh& mesh) {
  Shape shape{mesh.position, {}};
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f)
    if (mesh.connectivity.alive(f)) shape.faces.push_back(mesh.connectivity.face(f));
  return shape;
}

}  // namespace curvdecim::test
