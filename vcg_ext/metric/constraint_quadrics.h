// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "vcg_ext/geometry/symmetric3.h"
#include "vcg_ext/geometry/triangle.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/seams.h"
#include "vcg_ext/mesh/sharp_edges.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/metric/metric_plan.h"
#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/params.h"

namespace curvdecim::detail {

/// The plane of a face about any of its corners, which it passes through; factor: on its weight.
inline Symmetric3 plane_matrix(const FacePlane& plane, PlaneWeight weight, double factor = 1.0) {
  return Symmetric3::outer(plane.normal,
                           weight == PlaneWeight::Area ? factor * plane.area : factor);
}

/// Plane through an edge of face f, perpendicular to the face, about either end of the edge.
inline Symmetric3 edge_plane_matrix(const WorkingMesh& mesh, int f, int a, int b,
                                    PlaneWeight weight) {
  const Vector3 edge = mesh.position[b] - mesh.position[a];
  const Vector3 across = edge.cross(mesh.plane[f].normal);
  const double length = across.norm();
  if (!(length > 0.0)) return {};
  return Symmetric3::outer(across / length, weight == PlaneWeight::Area ? edge.squaredNorm() : 1.0);
}

/// On the plane through the edge ab of face f, as the mesh is now: of the boundary, or of a seam.
inline double edge_plane_weight(const WorkingMesh& mesh, const QuadricPlan& plan, int f, int a,
                                int b) {
  if (is_on_border(mesh, a, b)) return plan.boundary_weight;
  return is_seam_edge(mesh, f, a, b) ? plan.seam_weight : 0.0;
}

/// The same planes with their weights, summed over the edges at v.
inline Symmetric3 edge_planes_at(const WorkingMesh& mesh, const QuadricPlan& plan, int v) {
  Symmetric3 sum;
  for (int f : mesh.connectivity.faces_of(v))
    for (int u : mesh.connectivity.face(f))
      if (const double weight = u == v ? 0.0 : edge_plane_weight(mesh, plan, f, v, u); weight > 0.0)
        sum += edge_plane_matrix(mesh, f, v, u, plan.plane_weight) * weight;
  return sum;
}

/// Planes through the boundary, the feature edges and the seams of the input, perpendicular to the
/// faces there @cite garland1997, about each of the edge's two vertices, which they pass through.
class ConstraintQuadrics {
 public:
  ConstraintQuadrics(const WorkingMesh& mesh, const QuadricPlan& plan)
      : mesh_(mesh), plan_(plan), sharp_(mesh, plan.feature_angle) {}

  /// add(v, matrix) for both vertices of each such edge.
  template <class Add>
  void build(const Parallel& parallel, Add add) const {
    if (!(plan_.boundary_weight > 0.0) && mesh_.on_seam.empty()) return;
    std::vector<std::uint8_t> smooth(mesh_.connectivity.vertex_slots());  // by vertex
    parallel.for_each(mesh_.connectivity.vertex_slots(), [&](int v) { smooth[v] = is_smooth(v); });
    std::vector<std::uint8_t> held(mesh_.connectivity.face_slots());  // by face: a bit an edge
    parallel.for_each(mesh_.connectivity.face_slots(),
                      [&](int f) { held[f] = held_edges(f, smooth); });
    for (int f = 0; f < mesh_.connectivity.face_slots(); ++f)
      for (int i = 0; i < 3 && held[f] != 0; ++i)
        if (held[f] >> i & 1) add_plane(f, i, add);
  }

 private:
  /// Sure to have no such edge.
  bool is_smooth(int v) const { return is_inside_chart(mesh_, v) && sharp_.none_at(v); }

  std::uint8_t held_edges(int f, const std::vector<std::uint8_t>& smooth) const {
    const Face& face = mesh_.connectivity.face(f);
    unsigned held = 0;
    for (int i = 0; i < 3; ++i) {
      if (smooth[face[i]] || smooth[face[(i + 1) % 3]]) continue;
      if (weight_of(f, i) > 0.0) held |= 1u << i;
    }
    return static_cast<std::uint8_t>(held);
  }

  /// On the plane of edge i of face f.
  double weight_of(int f, int i) const {
    const Face& face = mesh_.connectivity.face(f);
    const int a = face[i], b = face[(i + 1) % 3];
    const int across = mesh_.connectivity.face_across(f, a, b);
    if (across < 0 || sharp_.between(f, across)) return plan_.boundary_weight;
    return is_seam_edge(mesh_, f, a, b) ? plan_.seam_weight : 0.0;
  }

  template <class Add>
  void add_plane(int f, int i, Add add) const {
    const Face& face = mesh_.connectivity.face(f);
    const int a = face[i], b = face[(i + 1) % 3];
    const Symmetric3 plane =
        edge_plane_matrix(mesh_, f, a, b, plan_.plane_weight) * weight_of(f, i);
    add(a, plane), add(b, plane);
  }

  const WorkingMesh& mesh_;
  const QuadricPlan& plan_;
  const SharpEdges sharp_;
};

}  // namespace curvdecim::detail
