// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "vcg_ext/metric/candidate.h"
#include "vcg_ext/metric/constraint_quadrics.h"
#include "vcg_ext/metric/plane_quadrics.h"
#include "vcg_ext/parallel.h"
#include "vcg_ext/placement/place.h"

namespace curvdecim {

/// Quadric error @cite garland1997: the squared distances of the merged vertex to the planes around
/// both ends. Accumulated, a vertex carries the planes of all that was merged into it. Memoryless
/// @cite lindstrom1998, it carries those of the faces around it now, keeps the volume, and
/// remembers the input a little (docs/decisions/memoryless-quadrics.md).
class QuadricMetric {
 public:
  QuadricMetric(const WorkingMesh& mesh, const EdgeCollapseParams& params)
      : mesh_(mesh), params_(params), memoryless_(params.quadrics == Quadrics::Memoryless) {}

  void initialize(const Parallel& parallel) {
    const std::vector<Symmetric3> constraints =
        ConstraintQuadrics(mesh_, params_, params_.plane_weight).build();
    carried_.resize(mesh_.position.size());
    quadric_.resize(memoryless_ ? carried_.size() : 0);
    gradient_.resize(quadric_.size());
    parallel.for_each(static_cast<int>(carried_.size()), [&](int v) {
      carried_[v].a = plane_matrix(mesh_, v, params_.plane_weight);
      if (!constraints.empty()) carried_[v].a += constraints[v];
      if (memoryless_) carried_[v].a = carried_[v].a * memory;
      if (memoryless_) recompute(v);
    });
  }

  std::optional<Candidate> evaluate(Edge edge, Allowed allowed) const {
    const Vector3 &a = mesh_.position[edge.a], &b = mesh_.position[edge.b];
    const Vector3 half = 0.5 * (b - a);
    const std::vector<Quadric>& quadrics = memoryless_ ? quadric_ : carried_;
    const Quadric q = sum_about_midpoint(quadrics[edge.a], quadrics[edge.b], half);
    const Placed placed =
        place(q, half, allowed, params_.placement, volume_plane(edge, half, allowed));
    double cost = placed.value;
    if (cost <= rounding * rounding * half.squaredNorm() * q.a.trace()) cost = 0.0;
    if (placed.offset == -half) return Candidate{cost, a, 0.0};  // not rounded: the vertex itself
    if (placed.offset == half) return Candidate{cost, b, 1.0};
    return Candidate{cost, a + (half + placed.offset), placed.t};
  }

  /// Before a collapse: the faces around the edge leave the vertices that will remain.
  void release(const EdgeNeighborhood& around) {
    if (!memoryless_) return;
    for (const auto* faces : {&around.wings(), &around.star()})
      for (int f : *faces) add_face(f, -1.0, around.edge());
  }

  /// After it: the faces that remain are back in their new shape. ring: the neighbours of
  /// collapse.keep.
  void merge(const Collapse& collapse, const EdgeNeighborhood& around,
             const std::vector<int>& ring) {
    const auto [keep, gone, keep_was, gone_was, now, t] = collapse;
    carried_[keep] = carried_[keep].with_origin_moved(now - keep_was) +
                     carried_[gone].with_origin_moved(now - gone_was);
    if (!memoryless_) return;
    quadric_[keep] = carried_[keep];
    gradient_[keep] = Vector3::Zero();
    for (int f : around.star())
      if (mesh_.connectivity.alive(f)) add_face(f, 1.0, no_edge);
    if (mesh_.kind[keep] == VertexKind::Interior) return;
    recompute(keep);
    for (int v : ring)
      if (mesh_.kind[v] == VertexKind::Boundary) recompute(v);
  }

 private:
  /// Distances below this part of the edge are rounding (of float coordinates; the sums are
  /// better): all edges in a plane cost exactly nothing.
  static constexpr double rounding = 1e-7;

  /// How much of the input's planes a memoryless vertex carries: enough that thin parts are not
  /// worn away collapse by collapse, too little to show elsewhere.
  static constexpr double memory = 0.1;

  /// To the sums of the corners that are not on the edge.
  void add_face(int f, double sign, Edge edge) {
    const Symmetric3 plane = plane_matrix_of_face(mesh_, f, params_.plane_weight) * sign;
    const Vector3 area_vector = (sign * mesh_.plane[f].area) * mesh_.plane[f].normal;
    for (int v : mesh_.connectivity.face(f)) {
      if (v == edge.a || v == edge.b) continue;
      quadric_[v].a += plane;
      gradient_[v] += area_vector;
    }
  }

  void recompute(int v) {
    quadric_[v] = carried_[v];
    quadric_[v].a += plane_matrix(mesh_, v, params_.plane_weight);
    if (mesh_.kind[v] == VertexKind::Boundary)
      quadric_[v].a += boundary_matrix(mesh_, v, params_.plane_weight) * params_.boundary_weight;
    gradient_[v] = volume_gradient(mesh_, v);
  }

  /// The two faces at the edge lie around both ends and count once. None where the volume is not
  /// defined: on boundaries and curves.
  std::optional<VolumePlane> volume_plane(Edge edge, const Vector3& half, Allowed allowed) const {
    if (!memoryless_ || allowed != Allowed::Anywhere || params_.placement != Placement::Optimal ||
        mesh_.kind[edge.a] != VertexKind::Interior)
      return std::nullopt;
    Vector3 gradient = gradient_[edge.a] + gradient_[edge.b];
    for (int f : mesh_.connectivity.faces_of(edge.a))
      if (mesh_.connectivity.face_has(f, edge.b))
        gradient -= mesh_.plane[f].area * mesh_.plane[f].normal;
    return VolumePlane{gradient, half.dot(gradient_[edge.b] - gradient_[edge.a])};
  }

  const WorkingMesh& mesh_;
  const EdgeCollapseParams& params_;
  const bool memoryless_;
  std::vector<Quadric> carried_;   // by vertex, about the vertex: summed along the collapses
  std::vector<Quadric> quadric_;   // by vertex, about the vertex: carried_ and the current faces
  std::vector<Vector3> gradient_;  // by vertex: volume_gradient
};

}  // namespace curvdecim
