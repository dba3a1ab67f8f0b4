// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numeric>

#include "support/shape.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

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
  mesh.vertex_origins = shape.vertex_count(), mesh.face_origins = shape.face_count();
  mesh.vertex_origin.resize(mesh.vertex_origins), mesh.face_origin.resize(mesh.face_origins);
  std::iota(mesh.vertex_origin.begin(), mesh.vertex_origin.end(), 0);
  std::iota(mesh.face_origin.begin(), mesh.face_origin.end(), 0);
  return mesh;
}

/// Collapses b of an edge into a, which goes to x, as the operator does; release(around) before,
/// merge(done, around) after.
template <class Release, class Merge>
void collapse_edge(WorkingMesh& mesh, Edge edge, const Vector3& x, Release release, Merge merge) {
  EdgeNeighborhood around;
  around.gather(mesh.connectivity, edge);
  const VertexMerge done{edge.a, edge.b, mesh.position[edge.a], mesh.position[edge.b], x, 0.5};
  std::vector<FacePlane> after;
  for (int f : around.star()) after.push_back(face_plane(triangle_after(mesh, f, edge, x)));
  release(around, after);
  mesh.position[edge.a] = x;
  mesh.connectivity.count(mesh.connectivity.collapse(edge.a, edge.b));
  mesh.connectivity.validate();
  for (int f : around.star()) mesh.update_plane(f);
  merge(done, around);
}

inline Shape shape_of(const WorkingMesh& mesh) {
  Shape shape{mesh.position, {}};
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f)
    if (mesh.connectivity.alive(f)) shape.faces.push_back(mesh.connectivity.face(f));
  return shape;
}

}  // namespace curvdecim::test
