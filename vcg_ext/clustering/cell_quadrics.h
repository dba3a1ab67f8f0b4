// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/clustering/boundary_edges.h"
#include "vcg_ext/clustering/cell_sums.h"

namespace curvdecim::detail {

/// The planes of the input, about the centres of its cells @cite lindstrom2000.
class CellQuadrics {
 public:
  /// importance: by vertex, a factor on the planes of its faces; empty: 1.
  CellQuadrics(const FlatMesh& mesh, const Clusters& clusters, const std::vector<Vector3>& centers,
               const std::vector<double>& importance)
      : mesh_(mesh),
        clusters_(clusters),
        centers_(centers),
        importance_(importance),
        at_boundary_(clusters.cells(), false) {}

  /// Every cell gets the planes of the faces that have a corner in it, each with the whole area of
  /// its face, and the planes that stand on the boundary edges.
  CellSums<Quadric> build(double boundary_weight, const Parallel& parallel) {
    auto sums = sum_over<Quadric>(static_cast<int>(mesh_.faces.size()), clusters_.cells(), parallel,
                                  [&](CellSums<Quadric>& into, int f) { add_face(into, f); });
    if (boundary_weight > 0.0)
      for (const BoundaryEdge& edge : boundary_edges(mesh_, parallel))
        add_edge(sums, edge, boundary_weight);
    return sums;
  }

  /// Whether a boundary edge has an end in the cell, after build().
  bool at_boundary(int cell) const { return at_boundary_[cell]; }

 private:
  void add_face(CellSums<Quadric>& sums, int f) const {
    const Face& face = mesh_.faces[f];
    if (!FlatMesh::is_face(face)) return;
    const FacePlane plane = face_plane(mesh_.triangle(f));
    if (!(plane.area > 0.0)) return;
    const double weight = plane.area * importance(face);
    for_different(clusters_.cells_of(face), [&](int cell) {
      add_plane(sums[cell], cell, plane.normal, mesh_.position[face[0]], weight);
    });
  }

  double importance(const Face& face) const {
    if (importance_.empty()) return 1.0;
    return (importance_[face[0]] + importance_[face[1]] + importance_[face[2]]) / 3.0;
  }

  void add_plane(Quadric& sum, int cell, const Vector3& normal, const Vector3& point,
                 double weight) const {
    sum += Quadric::plane(normal, normal.dot(point - centers_[cell]), weight);
  }

  /// Weight: the area of a strip along the edge as wide as a cell, so that it is one unit with the
  /// faces and does not depend on how finely the boundary is cut up.
  void add_edge(CellSums<Quadric>& sums, const BoundaryEdge& edge, double boundary_weight) {
    const Vector3 &a = mesh_.position[edge.a], &b = mesh_.position[edge.b];
    const FacePlane face = face_plane(mesh_.triangle(edge.face));
    const Vector3 across = (b - a).cross(face.normal);
    const double length = across.norm();
    if (!(length > 0.0)) return;
    const double weight = boundary_weight * length * clusters_.grid.side();
    const int at_a = clusters_.cell_of[edge.a], at_b = clusters_.cell_of[edge.b];
    at_boundary_[at_a] = at_boundary_[at_b] = true;
    add_plane(sums[at_a], at_a, across / length, a, weight);
    if (at_b != at_a) add_plane(sums[at_b], at_b, across / length, a, weight);
  }

  const FlatMesh& mesh_;
  const Clusters& clusters_;
  const std::vector<Vector3>& centers_;    // by cell
  const std::vector<double>& importance_;  // by vertex
  std::vector<bool> at_boundary_;          // by cell
};

}  // namespace curvdecim::detail
