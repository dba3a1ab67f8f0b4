// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/vertex_ring.h"
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

  /// factors: by vertex, on the weight of planes; a face has the mean of its corners'. None: 1.
  void initialize(const Parallel& parallel, std::vector<double> factors = {}) {
    factor_ = std::move(factors);
    const std::vector<Symmetric3> constraints =
        ConstraintQuadrics(mesh_, params_, params_.plane_weight).build(parallel);
    sum_.resize(mesh_.position.size());
    memory_.resize(memoryless_ ? sum_.size() : 0);
    parallel.for_each(static_cast<int>(sum_.size()), [&](int v) {
      Symmetric3& carried = memoryless_ ? memory_[v] : sum_[v].quadric.a;
      carried = planes_around(v);
      if (!constraints.empty()) carried += constraints[v] * factor(v);
      if (memoryless_) carried = carried * memory;
      if (memoryless_) recompute(v);
    });
  }

  /// wings: sum of the area vectors of the faces at the edge.
  std::optional<Candidate> evaluate(Edge edge, Allowed allowed, const Vector3& wings) const {
    const Vector3 &a = mesh_.position[edge.a], &b = mesh_.position[edge.b];
    const Vector3 half = 0.5 * (b - a);
    const QuadricOfEdge q = sum_about_midpoint(sum_[edge.a].quadric, sum_[edge.b].quadric, half);
    const Placed placed =
        place(q, half, allowed, params_.placement, volume_plane(edge, half, allowed, wings));
    double cost = placed.value;
    if (cost <= rounding * rounding * half.squaredNorm() * q.sum.a.trace()) cost = 0.0;
    if (placed.offset == -half) return Candidate{cost, a, 0.0};  // not rounded: the vertex itself
    if (placed.offset == half) return Candidate{cost, b, 1.0};
    return Candidate{cost, a + (half + placed.offset), placed.t};
  }

  double factor(int v) const { return factor_.empty() ? 1.0 : factor_[v]; }

  /// Between release and merge only: the faces around v are not counted then.
  void set_factor(int v, double factor) { factor_[v] = factor; }

  /// Before a collapse: the faces around the edge leave the vertices that will remain.
  void release(const EdgeNeighborhood& around) {
    if (!memoryless_) return;
    for (const auto* faces : {&around.wings(), &around.star()})
      for (int f : *faces) add_face(f, -1.0, around.edge());
  }

  /// After it: the faces that remain are back in their new shape. ring: around collapse.keep.
  void merge(const Collapse& collapse, const EdgeNeighborhood& around, const VertexRing& ring) {
    const auto [keep, gone, keep_was, gone_was, now, t] = collapse;
    if (!memoryless_) {
      sum_[keep].quadric = sum_[keep].quadric.with_origin_moved(now - keep_was) +
                           sum_[gone].quadric.with_origin_moved(now - gone_was);
      return;
    }
    sum_[keep] = {remembered(keep).with_origin_moved(now - keep_was) +
                  remembered(gone).with_origin_moved(now - gone_was)};
    memory_[keep] = sum_[keep].quadric.a;
    for (int f : around.star())
      if (mesh_.connectivity.alive(f)) add_face(f, 1.0, no_edge);
    if (mesh_.kind[keep] == VertexKind::Interior) return;
    recompute(keep);
    for (const RingVertex& u : ring)
      if (mesh_.kind[u.vertex] == VertexKind::Boundary) recompute(u.vertex);
  }

  void renumber(const Renumbering& numbers) {
    numbers.vertices(sum_), numbers.vertices(memory_);
    if (!factor_.empty()) numbers.vertices(factor_);
  }

 private:
  /// Distances below this part of the edge are rounding (of float coordinates; the sums are
  /// better): all edges in a plane cost exactly nothing.
  static constexpr double rounding = 1e-7;

  /// How much of the input's planes a memoryless vertex carries: enough that thin parts are not
  /// worn away collapse by collapse, too little to show elsewhere.
  static constexpr double memory = 0.1;

  /// What an evaluation reads of a vertex.
  struct Sum {
    Quadric quadric;  // about the vertex; memoryless: of the planes remembered and current
    Vector3 gradient = Vector3::Zero();  // memoryless: volume_gradient
  };

  /// To the sums of the corners that are not on the edge.
  void add_face(int f, double sign, Edge edge) {
    const Symmetric3 plane =
        plane_matrix_of_face(mesh_, f, params_.plane_weight) * (sign * factor_of_face(f));
    const Vector3 area_vector = sign * mesh_.plane[f].area_vector();
    for (int v : mesh_.connectivity.face(f)) {
      if (v == edge.a || v == edge.b) continue;
      sum_[v].quadric.a += plane;
      sum_[v].gradient += area_vector;
    }
  }

  double factor_of_face(int f) const {
    if (factor_.empty()) return 1.0;
    const Face& face = mesh_.connectivity.face(f);
    return (factor_[face[0]] + factor_[face[1]] + factor_[face[2]]) / 3.0;
  }

  Symmetric3 planes_around(int v) const {
    if (factor_.empty()) return plane_matrix(mesh_, v, params_.plane_weight);
    Symmetric3 sum;
    for (int f : mesh_.connectivity.faces_of(v))
      sum += plane_matrix_of_face(mesh_, f, params_.plane_weight) * factor_of_face(f);
    return sum;
  }

  /// All current planes pass through the vertex, so that they add to the matrix only.
  Quadric remembered(int v) const { return {memory_[v], sum_[v].quadric.b, sum_[v].quadric.c}; }

  void recompute(int v) {
    Symmetric3& sum = sum_[v].quadric.a;
    sum = memory_[v] + planes_around(v);
    if (mesh_.kind[v] == VertexKind::Boundary)
      sum += boundary_matrix(mesh_, v, params_.plane_weight) * params_.boundary_weight;
    sum_[v].gradient = volume_gradient(mesh_, v);
  }

  /// The two faces at the edge lie around both ends and count once. None where the volume is not
  /// defined: on boundaries and curves.
  std::optional<VolumePlane> volume_plane(Edge edge, const Vector3& half, Allowed allowed,
                                          const Vector3& wings) const {
    if (!memoryless_ || allowed != Allowed::Anywhere || params_.placement != Placement::Optimal ||
        mesh_.kind[edge.a] != VertexKind::Interior)
      return std::nullopt;
    const Vector3 &a = sum_[edge.a].gradient, &b = sum_[edge.b].gradient;
    return VolumePlane{a + b - wings, half.dot(b - a)};
  }

  const WorkingMesh& mesh_;
  const EdgeCollapseParams& params_;
  const bool memoryless_;
  std::vector<Sum> sum_;            // by vertex
  std::vector<Symmetric3> memory_;  // by vertex, memoryless: of the input's planes it has met
  std::vector<double> factor_;      // by vertex, or empty: on the weight of planes
};

}  // namespace curvdecim
