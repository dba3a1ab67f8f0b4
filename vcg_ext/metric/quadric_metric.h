// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/vertex_ring.h"
#include "vcg_ext/metric/candidate.h"
#include "vcg_ext/metric/constraint_quadrics.h"
#include "vcg_ext/metric/least_cost.h"
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
      carried = matrix_around(v);
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

  /// Between release and merge only: the faces around v are counted anew then.
  void set_factor(int v, double factor) { factor_[v] = factor; }

  /// Costs of the edges from v to the others, each of which may collapse to anywhere; without the
  /// volume, which moves a vertex along more than it lifts it.
  void estimate(int v, const std::vector<int>& others, std::vector<double>& costs) const {
    costs.resize(others.size());
    if (params_.placement != Placement::Optimal) return estimate_one_by_one(v, others, costs);
    const Vector3& at = mesh_.position[v];
    const Quadric& quadric = sum_[v].quadric;
    const VertexPair both(at, quadric, at, quadric);
    for (std::size_t i = 0; i < others.size(); i += 2) {
      const int p = others[i], q = others[std::min(i + 1, others.size() - 1)];
      const VertexPair pair(mesh_.position[p], sum_[p].quadric, mesh_.position[q], sum_[q].quadric);
      const Pair cost = least_costs(both, pair, {relative_pull, rounding * rounding});
      costs[i] = cost[0];
      if (i + 1 < costs.size()) costs[i + 1] = cost[1];
    }
  }

  /// Before a collapse: the vertices around the edge's ends lose the wings and see the star as it
  /// will be. merged_factor: of the vertex that it leaves.
  void release(const EdgeNeighborhood& around, const std::vector<FacePlane>& after,
               double merged_factor = 1.0) {
    if (!memoryless_) return;
    for (int f : around.wings())
      add_to_ring(f, around.edge(), matrix(f) * -1.0, -mesh_.plane[f].area_vector());
    for (std::size_t i = 0; i < after.size(); ++i) {
      const int f = around.star()[i];
      const double factor = factor_after(f, around.edge(), merged_factor);
      add_to_ring(f, around.edge(),
                  plane_matrix(after[i], params_.plane_weight) * factor - matrix(f),
                  after[i].area_vector() - mesh_.plane[f].area_vector());
    }
  }

  /// After it: the merged vertex gets what its ends remember and the faces around it. ring:
  /// scratch.
  void merge(const Collapse& collapse, const EdgeNeighborhood& around, VertexRing& ring) {
    const auto [keep, gone, keep_was, gone_was, now, t] = collapse;
    if (!memoryless_) {
      sum_[keep].quadric = sum_[keep].quadric.with_origin_moved(now - keep_was) +
                           sum_[gone].quadric.with_origin_moved(now - gone_was);
      return;
    }
    sum_[keep] = {remembered(keep).with_origin_moved(now - keep_was) +
                  remembered(gone).with_origin_moved(now - gone_was)};
    memory_[keep] = sum_[keep].quadric.a;
    bool doubled = false;  // faces that fell onto others are gone again
    for (int f : around.star()) {
      if (!mesh_.connectivity.alive(f)) {
        doubled = true;
        continue;
      }
      sum_[keep].quadric.a += matrix(f);
      sum_[keep].gradient += mesh_.plane[f].area_vector();
    }
    if (mesh_.kind[keep] == VertexKind::Interior && !doubled) return;
    recompute(keep);
    gather_ring(mesh_, keep, ring);
    for (const RingVertex& u : ring)
      if (doubled || mesh_.kind[u.vertex] == VertexKind::Boundary) recompute(u.vertex);
  }

  void renumber(const Renumbering& numbers) {
    numbers.vertices(sum_), numbers.vertices(memory_);
    if (!factor_.empty()) numbers.vertices(factor_);
  }

 private:
  void estimate_one_by_one(int v, const std::vector<int>& others,
                           std::vector<double>& costs) const {
    for (std::size_t i = 0; i < others.size(); ++i)
      costs[i] = evaluate({v, others[i]}, Allowed::Anywhere, Vector3::Zero())->cost;
  }

  /// Distances below this part of the edge are rounding (of float coordinates; the sums are
  /// better): all edges in a plane cost exactly nothing.
  static constexpr double rounding = 1e-7;

  /// How much of the input's planes a memoryless vertex carries: enough that thin parts are not
  /// worn away collapse by collapse, too little to show elsewhere.
  static constexpr double memory = 0.1;

  /// What an evaluation reads of a vertex.
  struct Sum {
    Quadric quadric;  // about the vertex; memoryless: of the planes remembered and current
    Vector3 gradient = Vector3::Zero();  // memoryless: area_vector_around
  };

  /// Of the plane of face f, about any of its corners.
  Symmetric3 matrix(int f) const {
    const Symmetric3 plane = plane_matrix(mesh_.plane[f], params_.plane_weight);
    return factor_.empty() ? plane : plane * factor_after(f, no_edge, 0.0);
  }

  /// The mean of the factors of face f's corners, if the edge's ends became one vertex.
  double factor_after(int f, Edge edge, double merged_factor) const {
    if (factor_.empty()) return 1.0;
    double sum = 0.0;
    for (int v : mesh_.connectivity.face(f))
      sum += v == edge.a || v == edge.b ? merged_factor : factor_[v];
    return sum / 3.0;
  }

  /// To the sums of the corners that are not on the edge.
  void add_to_ring(int f, Edge edge, const Symmetric3& matrix, const Vector3& area_vector) {
    for (int v : mesh_.connectivity.face(f)) {
      if (v == edge.a || v == edge.b) continue;
      sum_[v].quadric.a += matrix;
      sum_[v].gradient += area_vector;
    }
  }

  Symmetric3 matrix_around(int v) const {
    Symmetric3 sum;
    for (int f : mesh_.connectivity.faces_of(v)) sum += matrix(f);
    return sum;
  }

  /// All current planes pass through the vertex, so that they add to the matrix only.
  Quadric remembered(int v) const { return {memory_[v], sum_[v].quadric.b, sum_[v].quadric.c}; }

  void recompute(int v) {
    Symmetric3& sum = sum_[v].quadric.a;
    sum = memory_[v] + matrix_around(v);
    if (mesh_.kind[v] == VertexKind::Boundary)
      sum += boundary_matrix(mesh_, v, params_.plane_weight) * params_.boundary_weight;
    sum_[v].gradient = area_vector_around(mesh_, v);
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
