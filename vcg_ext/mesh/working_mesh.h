// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/geometry/texture_triangle.h"
#include "vcg_ext/geometry/triangle.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/merge_record.h"
#include "vcg_ext/mesh/renumbering.h"
#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/mesh/vertex_kind.h"
#include "vcg_ext/mesh/wedges.h"
#include "vcg_ext/parallel/array.h"

namespace curvdecim::detail {

/// The mesh while it is decimated: index arrays in a box of diagonal 1 around the origin.
struct WorkingMesh {
  std::vector<Vector3> position;     // by vertex
  std::vector<VertexKind> kind;      // by vertex
  std::vector<std::uint8_t> locked;  // by vertex: 1 must stay where it is
  Array<FacePlane> plane;            // by face
  std::vector<double> importance;    // by vertex: factor on the cost; empty: 1 everywhere
  TriangleConnectivity connectivity;
  Wedges wedges;                      // where corners at a vertex are to be told apart
  std::vector<std::uint8_t> on_seam;  // by vertex: 1 if it is an end of a seam edge; empty: no seam
  std::vector<Vector2> texture;       // by wedge: its coordinates; empty: there are none
  std::vector<Vector3> color;         // by wedge, 0..1 a channel; empty: they do not count
  double texture_scale2 = 0.0;        // squared: lengths on the input over those in its texture
  double color_scale2 = 0.0;          // the same of colours: mesh/attribute_scale.h
  std::vector<int> vertex_origin;     // by vertex: its number at the start, or a later one
  std::vector<int> face_origin;  // by face: its number in the mesh it was taken from, or a later
  MergeRecord merges;            // by the numbers of vertex_origin
  int vertex_origins = 0;        // numbers that were given
  int face_origins = 0;          // the same, those of the mesh that it was taken from included

  Triangle triangle(int f) const {
    const Face& face = connectivity.face(f);
    return {position[face[0]], position[face[1]], position[face[2]]};
  }

  /// There are coordinates.
  TextureTriangle texture_triangle(int f) const {
    const Face& of_face = wedges.of_face(f);
    return {texture[of_face[0]], texture[of_face[1]], texture[of_face[2]]};
  }

  /// There are colours.
  AtCorners<Vector3> color_triangle(int f) const {
    const Face& of_face = wedges.of_face(f);
    return {color[of_face[0]], color[of_face[1]], color[of_face[2]]};
  }

  /// Beside their error, what corners carry counts.
  bool weighs_attributes() const { return !texture.empty() || !color.empty(); }

  void note_merge(int gone, int keep) { merges.note(vertex_origin[gone], vertex_origin[keep]); }

  void update_plane(int f) { plane[f] = face_plane(triangle(f)); }

  /// Those of all faces, none of which is dead.
  void update_planes(const Parallel& parallel) {
    plane.resize(connectivity.face_slots());
    parallel.for_each(connectivity.face_slots(), [&](int f) { update_plane(f); });
  }

  void renumber(const Renumbering& numbers) {
    numbers.vertices(position), numbers.vertices(kind), numbers.vertices(locked);
    numbers.vertices(importance), numbers.vertices(vertex_origin, vertex_origins);
    merges.make_room(vertex_origins);
    const std::size_t planes = plane.size();
    numbers.faces(plane), numbers.faces(face_origin, face_origins);
    // Those of dead faces, which an Array would leave without a value.
    if (plane.size() > planes) std::fill(plane.begin() + planes, plane.end(), FacePlane{});
    numbers.vertices(on_seam), wedges.renumber(numbers);
    numbers.apply(connectivity);
  }
};

/// True for an edge of one face. The kinds of its ends rule out most others.
inline bool is_on_border(const WorkingMesh& mesh, int a, int b) {
  return mesh.kind[a] != VertexKind::Interior && mesh.kind[b] != VertexKind::Interior &&
         is_boundary_edge(mesh.connectivity, a, b);
}

/// Sum of the area vectors of the faces around v: the direction they face together, and how the
/// volume below them grows with v.
inline Vector3 area_vector_around(const WorkingMesh& mesh, int v) {
  Vector3 sum = Vector3::Zero();
  for (int f : mesh.connectivity.faces_of(v)) sum += mesh.plane[f].area_vector();
  return sum;
}

/// Six times the volume between a face and a point, above 0 where the face looks away from it.
inline double volume_below(const WorkingMesh& mesh, int f, const Vector3& point) {
  const Triangle t = mesh.triangle(f);
  return (t[0] - point).dot((t[1] - point).cross(t[2] - point));
}

/// Face f with its corner at a or b moved to x.
inline Triangle triangle_after(const WorkingMesh& mesh, int f, Edge edge, const Vector3& x) {
  const Face& face = mesh.connectivity.face(f);
  const auto corner = [&](int v) -> const Vector3& {
    return v == edge.a || v == edge.b ? x : mesh.position[v];
  };
  return {corner(face[0]), corner(face[1]), corner(face[2])};
}

}  // namespace curvdecim::detail
