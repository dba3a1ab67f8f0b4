// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/small_quadric.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/metric/border_area.h"
#include "vcg_ext/metric/constraint_quadrics.h"
#include "vcg_ext/metric/least_cost.h"
#include "vcg_ext/metric/metric.h"
#include "vcg_ext/metric/pass_weight.h"
#include "vcg_ext/metric/placement.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// Quadric error @cite garland1997: the squared distances of the merged vertex to the planes around
/// both ends. Accumulated, a vertex carries the planes of all that was merged into it. Memoryless
/// @cite lindstrom1998, it carries those of the faces around it now, keeps the volume, and
/// remembers the input a little (docs/decisions/memoryless-quadrics.md).
class QuadricMetric {
 public:
  QuadricMetric(const WorkingMesh& mesh, const QuadricPlan& plan)
      : mesh_(mesh), plan_(plan), memoryless_(plan.quadrics == Quadrics::Memoryless) {}

  /// factors: by vertex, on the weight of planes; a face has the mean of its corners'. None: 1.
  void initialize(const Parallel& parallel, std::vector<float> factors = {}) {
    factor_ = std::move(factors);
    sum_.resize(mesh_.position.size());
    ConstraintQuadrics(mesh_, plan_).build(parallel, [&](int v, const Symmetric3& plane) {
      sum_[v].a += plane;
    });
    parallel.for_each(static_cast<int>(sum_.size()), [&](int v) {
      const Symmetric3 around = matrix_around(v), input = around + sum_[v].a * factor(v);
      sum_[v].a = memoryless_ ? input * memory + around + boundary(v) : input;
    });
  }

  // --- passes (passes/)
  // ---------------------------------------------------------------------------

  /// Whether they compute as this plan says.
  bool allows_passes() const {
    return memoryless_ && plan_.keeps_topology && plan_.placement == Placement::Optimal &&
           plan_.plane_weight == PlaneWeight::Area;
  }

  /// Instead of initialize(): what each vertex remembers of the input. resume() has to follow.
  std::vector<SmallQuadric> remember(const Parallel& parallel, std::vector<float> factors = {}) {
    factor_ = std::move(factors);
    std::vector<SmallQuadric> remembered(mesh_.position.size());
    ConstraintQuadrics(mesh_, plan_).build(parallel, [&](int v, const Symmetric3& plane) {
      remembered[v] = SmallQuadric({remembered[v].quadric().a + plane});
    });
    parallel.for_each(static_cast<int>(remembered.size()), [&](int v) {
      const Symmetric3 held = remembered[v].quadric().a * factor(v);
      remembered[v] = SmallQuadric({(matrix_around(v) + held) * memory});
    });
    return remembered;
  }

  /// By vertex. They are the passes' until resume().
  std::vector<PassWeight> take_weights(const Parallel&) const {
    return std::vector<PassWeight>(mesh_.position.size(), PassWeight{});
  }

  /// By vertex; none are left.
  std::vector<float> take_factors() { return std::exchange(factor_, {}); }

  /// The weight of a vertex that two have become.
  static PassWeight merged(const PassWeight&, const PassWeight&) { return {}; }

  /// On the mesh as it is now.
  void resume(const std::vector<SmallQuadric>& remembered, const std::vector<PassWeight>&,
              const Parallel& parallel) {
    resume(remembered, std::vector<float>(), parallel);
  }
  void resume(const std::vector<SmallQuadric>& remembered, std::vector<float> factors,
              const Parallel& parallel) {
    factor_ = std::move(factors);
    const int count = static_cast<int>(remembered.size());
    sum_.resize(count);
    parallel.for_each(count, [&](int v) {
      sum_[v] = Carried(remembered[v].quadric());
      sum_[v].a += matrix_around(v) + boundary(v);
    });
  }

  // --- costs
  // ----------------------------------------------------------------------------------------

  /// wings: sum of the area vectors of the faces at the edge.
  std::optional<Candidate> evaluate(Edge edge, Allowed allowed, const Vector3& wings) const {
    const Vector3 &a = mesh_.position[edge.a], &b = mesh_.position[edge.b];
    const Vector3 half = 0.5 * (b - a);
    const QuadricOfEdge q =
        sum_about_midpoint(sum_[edge.a].quadric(), sum_[edge.b].quadric(), half);
    const Placed placed =
        place(q, half, allowed, plan_.placement, keeping_plane(edge, half, allowed, wings));
    double cost = placed.value;
    if (cost <= rounding * rounding * half.squaredNorm() * q.sum.a.trace()) cost = 0.0;
    if (placed.offset == -half) return Candidate{cost, a, 0.0};  // not rounded: the vertex itself
    if (placed.offset == half) return Candidate{cost, b, 1.0};
    return Candidate{cost, a + (half + placed.offset), placed.t};
  }

  /// Distances below this part of the edge are rounding (of float coordinates; the sums are
  /// better): all edges in a plane cost exactly nothing.
  static constexpr double rounding = 1e-7;

  /// The sum of both ends' quadrics about the edge's midpoint.
  Quadric of_edge(Edge edge) const {
    const Vector3 half = 0.5 * (mesh_.position[edge.b] - mesh_.position[edge.a]);
    return sum_about_midpoint(sum_[edge.a].quadric(), sum_[edge.b].quadric(), half).sum;
  }

  /// Sum of the weights of the vertex's planes.
  double weight(int v) const { return sum_[v].a.trace(); }

  double factor(int v) const { return factor_.empty() ? 1.0 : factor_[v]; }

  /// Between release and merge only: the faces around v are counted anew then.
  void set_factor(int v, double factor) { factor_[v] = static_cast<float>(factor); }

  /// Costs of the edges from v to the others, each of which may collapse to anywhere; without the
  /// volume, which moves a vertex along more than it lifts it.
  void estimate(int v, const std::vector<int>& others, std::vector<double>& costs) const {
    costs.resize(others.size());
    if (plan_.placement != Placement::Optimal) return estimate_one_by_one(v, others, costs);
    const Vector3& at = mesh_.position[v];
    const Quadric quadric = sum_[v].quadric();
    const VertexLanes<Pair> both = vertex_pair(at, quadric, at, quadric);
    for (std::size_t i = 0; i < others.size(); i += 2) {
      const int p = others[i], q = others[std::min(i + 1, others.size() - 1)];
      const VertexLanes<Pair> pair =
          vertex_pair(mesh_.position[p], sum_[p].quadric(), mesh_.position[q], sum_[q].quadric());
      const Pair cost =
          least_costs(both, pair, CostScale<double>{relative_pull, rounding * rounding});
      costs[i] = cost[0];
      if (i + 1 < costs.size()) costs[i + 1] = cost[1];
    }
  }

  /// Before a collapse: the vertices around the edge's ends lose the wings and see the star as it
  /// will be; the ends are left with what they remember. merged_factor: of the vertex that they
  /// become.
  void release(const EdgeNeighborhood& around, const std::vector<FacePlane>& after,
               double merged_factor = 1.0) {
    if (!memoryless_) return;
    const Edge edge = around.edge();
    if (!is_inside(edge.a) || !is_inside(edge.b)) return forget_current(around);
    for (int f : around.wings()) {
      const Symmetric3 lost = matrix(f);
      for (int v : mesh_.connectivity.face(f)) sum_[v].a -= lost;
    }
    for (std::size_t i = 0; i < after.size(); ++i) {
      const int f = around.star()[i];
      const Symmetric3 lost = matrix(f);
      const Symmetric3 won =
          plane_matrix(after[i], plan_.plane_weight, factor_after(f, edge, merged_factor));
      for (int v : mesh_.connectivity.face(f))
        sum_[v].a += v == edge.a || v == edge.b ? lost * -1.0 : won - lost;
    }
  }

  /// After it: the merged vertex gets what its ends remember and the faces around it.
  void merge(const VertexMerge& merge, const EdgeNeighborhood& around) {
    const auto [keep, gone, keep_was, gone_was, now, t] = merge;
    sum_[keep] = Carried(sum_[keep].quadric().with_origin_moved(now - keep_was) +
                         sum_[gone].quadric().with_origin_moved(now - gone_was));
    if (!memoryless_) return;
    if (!is_inside(keep)) return see_current(around);
    for (int f : around.star()) sum_[keep].a += matrix(f);
  }

  /// As on an input that has these faces: what was remembered belongs to faces that may be gone.
  void renew(int v, int source) {
    if (!factor_.empty()) factor_[v] = factor_[source];
    const Symmetric3 around = matrix_around(v), held = boundary(v);
    sum_[v] = {};
    sum_[v].a = memoryless_ ? (around + held) * memory + around + held : around * factor(v) + held;
  }

  void renumber(const Renumbering& numbers) {
    numbers.vertices(sum_);
    if (!factor_.empty()) numbers.vertices(factor_);
  }

 private:
  void estimate_one_by_one(int v, const std::vector<int>& others,
                           std::vector<double>& costs) const {
    for (std::size_t i = 0; i < others.size(); ++i)
      costs[i] = evaluate({v, others[i]}, Allowed::Anywhere, Vector3::Zero())->cost;
  }

  /// How much of the input's planes a memoryless vertex carries: enough that thin parts are not
  /// worn away collapse by collapse, too little to show elsewhere.
  static constexpr double memory = 0.1;

  /// A quadric in a cache line. About the vertex that carries it, which is near its minimum, b and
  /// c are small: their rounding to single precision is to their own size.
  struct Carried {
    Symmetric3 a;
    std::array<float, 3> b{};
    float c = 0.0f;

    Carried() = default;
    explicit Carried(const Quadric& q)
        : a(q.a), b{float(q.b.x()), float(q.b.y()), float(q.b.z())}, c(float(q.c)) {}

    Quadric quadric() const { return {a, {b[0], b[1], b[2]}, c}; }
  };

  /// The matrix of the plane of face f, about any of its corners.
  Symmetric3 matrix(int f) const {
    return plane_matrix(mesh_.plane[f], plan_.plane_weight, factor_after(f, no_edge, 0.0));
  }

  /// The mean of the factors of face f's corners, if the edge's ends became one vertex.
  double factor_after(int f, Edge edge, double merged_factor) const {
    if (factor_.empty()) return 1.0;
    double sum = 0.0;
    for (int v : mesh_.connectivity.face(f))
      sum += v == edge.a || v == edge.b ? merged_factor : factor_[v];
    return sum / 3.0;
  }

  Symmetric3 matrix_around(int v) const {
    Symmetric3 sum;
    for (int f : mesh_.connectivity.faces_of(v)) sum += matrix(f);
    return sum;
  }

  Symmetric3 boundary(int v) const {
    if (is_inside_chart(mesh_, v)) return {};
    return edge_planes_at(mesh_, plan_, v);
  }

  /// Around it a collapse changes no boundary and no seam, and no face falls onto another.
  bool is_inside(int v) const { return plan_.keeps_topology && is_inside_chart(mesh_, v); }

  void forget_current(const EdgeNeighborhood& around) {
    for (const std::vector<int>* faces : {&around.wings(), &around.star()})
      for (int f : *faces) add_current(f, -1.0);
  }

  void see_current(const EdgeNeighborhood& around) {
    for (int f : around.star())
      if (mesh_.connectivity.alive(f)) add_current(f, 1.0);
  }

  /// What the corners of face f have for the mesh as it is, its plane and those of its border, with
  /// this sign. All planes pass through the corners, so that they add to their matrices only.
  void add_current(int f, double sign) {
    const Symmetric3 plane = matrix(f) * sign;
    const Face& face = mesh_.connectivity.face(f);
    for (int i = 0; i < 3; ++i) {
      const int a = face[i], b = face[(i + 1) % 3];
      sum_[a].a += plane;
      const double weight = edge_plane_weight(mesh_, plan_, f, a, b);
      if (!(weight > 0.0)) continue;
      const Symmetric3 held =
          edge_plane_matrix(mesh_, f, a, b, plan_.plane_weight) * (sign * weight);
      sum_[a].a += held, sum_[b].a += held;
    }
  }

  /// None where neither volume nor area is defined: on curves, and between two borders. None at a
  /// hub, whose volume all of its faces would tell for each of its edges.
  std::optional<KeepingPlane> keeping_plane(Edge edge, const Vector3& half, Allowed allowed,
                                            const Vector3& wings) const {
    if (!memoryless_ || allowed != Allowed::Anywhere || plan_.placement != Placement::Optimal)
      return std::nullopt;
    const VertexKind a = mesh_.kind[edge.a], b = mesh_.kind[edge.b];
    if (mesh_.connectivity.is_hub(edge.a) || mesh_.connectivity.is_hub(edge.b)) return std::nullopt;
    if (a == VertexKind::Interior && b == a) return volume_plane(edge, half, wings);
    if (a == VertexKind::Boundary && b == a) return border_area_plane(mesh_, edge, half, wings);
    return std::nullopt;
  }

  /// The two faces at the edge lie around both ends and count once.
  KeepingPlane volume_plane(Edge edge, const Vector3& half, const Vector3& wings) const {
    const Vector3 a = area_vector_around(mesh_, edge.a), b = area_vector_around(mesh_, edge.b);
    return {a + b - wings, half.dot(b - a)};
  }

  const WorkingMesh& mesh_;
  const QuadricPlan plan_;
  const bool memoryless_;
  std::vector<Carried> sum_;   // by vertex, about it; memoryless: of planes remembered and current
  std::vector<float> factor_;  // by vertex, or empty: on the weight of planes
};

}  // namespace curvdecim::detail
