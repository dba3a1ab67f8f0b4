// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "vcg_ext/curvature/vertex_spheres.h"
#include "vcg_ext/metric/constraint_quadrics.h"
#include "vcg_ext/metric/metric.h"
#include "vcg_ext/metric/quadric_metric.h"
#include "vcg_ext/metric/sphere_ring.h"

namespace curvdecim::detail {

/// Algebraic spheres as printed @cite michaud2017: those of both ends are interpolated along the
/// edge, the merged vertex lies on the sphere between, at the parameter where the new faces are
/// nearest to it, and keeps that sphere. Nothing is fitted again, so that the input is forgotten
/// step by step. Boundaries and sharp edges, which the paper does not speak of, are held by their
/// quadrics.
class InterpolatedSphereMetric {
 public:
  InterpolatedSphereMetric(const WorkingMesh& mesh, const SpherePlan& plan)
      : mesh_(mesh), plan_(plan) {}

  void initialize(const Parallel& parallel) {
    sphere_ = VertexSpheres(mesh_, plan_.kernel, plan_.quadrics.feature_angle, parallel).fit();
    held_.resize(sphere_.size());
    ConstraintQuadrics(mesh_, plan_.quadrics).build(parallel, [&](int v, const Symmetric3& plane) {
      held_[v].a += plane;
    });
  }

  std::optional<Candidate> evaluate(Edge edge, Allowed allowed, const Vector3&) const {
    if (allowed == Allowed::OntoA) return at_end(edge, 0.0);
    if (allowed == Allowed::OntoB) return at_end(edge, 1.0);
    return least_along(edge);
  }

  void estimate(int v, const std::vector<int>& others, std::vector<double>& costs) const {
    costs.resize(others.size());
    for (std::size_t i = 0; i < others.size(); ++i) costs[i] = least_along({v, others[i]}).cost;
  }

  void release(const EdgeNeighborhood&, const std::vector<FacePlane>&) {}

  void merge(const VertexMerge& merge, const EdgeNeighborhood&) {
    const auto [keep, gone, keep_was, gone_was, now, t] = merge;
    sphere_[keep] = interpolated(sphere_[keep].with_origin_moved(now - keep_was),
                                 sphere_[gone].with_origin_moved(now - gone_was), t)
                        .normalised();
    held_[keep] = held_[keep].with_origin_moved(now - keep_was) +
                  held_[gone].with_origin_moved(now - gone_was);
  }

  void renew(int v, int source) { sphere_[v] = sphere_[source], held_[v] = held_[source]; }

  void renumber(const Renumbering& numbers) { numbers.vertices(sphere_), numbers.vertices(held_); }

 private:
  static constexpr int samples = 5;  // along the edge, ends included
  static constexpr double spacing = 1.0 / (samples - 1);
  static constexpr int golden_steps = 6;           // to a fiftieth of the edge
  static constexpr double golden = 0.38196601125;  // (3 - sqrt 5) / 2

  /// Between both ends' spheres, about the edge's midpoint.
  AlgebraicSphere sphere_at(Edge edge, double t) const {
    const Vector3 half = 0.5 * (mesh_.position[edge.b] - mesh_.position[edge.a]);
    return interpolated(sphere_[edge.a].with_origin_moved(half),
                        sphere_[edge.b].with_origin_moved(-half), t)
        .normalised();
  }

  /// On the sphere.
  Candidate at(Edge edge, double t) const {
    const Vector3 &a = mesh_.position[edge.a], &b = mesh_.position[edge.b];
    const Vector3 midpoint = 0.5 * (a + b);
    const AlgebraicSphere sphere = sphere_at(edge, t);
    const Vector3 offset = sphere.project((t - 0.5) * (b - a));
    return {cost(edge, midpoint + offset, sphere.with_origin_moved(offset)), midpoint + offset, t};
  }

  /// At an end as it is.
  Candidate at_end(Edge edge, double t) const {
    const int end = t == 0.0 ? edge.a : edge.b;
    return {cost(edge, mesh_.position[end], sphere_[end]), mesh_.position[end], t};
  }

  /// sphere: about x.
  double cost(Edge edge, const Vector3& x, const AlgebraicSphere& sphere) const {
    RingEnergy energy;
    for_faces_after(mesh_, edge, x, [&](const Triangle& t, int, int) { energy.add(sphere, t); });
    const Vector3 &a = mesh_.position[edge.a], &b = mesh_.position[edge.b];
    const double constraint = held_[edge.a].value(x - a) + held_[edge.b].value(x - b);
    const double weight = held_[edge.a].a.trace() + held_[edge.b].a.trace();
    const double sum =
        energy.of(plan_.energy) + planes_in_unit_of(plan_.energy, constraint, weight);
    const double nothing = energy_of_distance(
        plan_.energy, QuadricMetric::rounding * (b - a).norm(), energy.area + weight);
    return sum <= nothing ? 0.0 : sum;
  }

  /// By samples, then by golden section around the best of them.
  Candidate least_along(Edge edge) const {
    Candidate best = at(edge, 0.5);
    for (int i = 0; i < samples; ++i)
      if (const Candidate sample = at(edge, i / (samples - 1.0)); sample.cost < best.cost)
        best = sample;
    double low = std::max(0.0, best.t - spacing), high = std::min(1.0, best.t + spacing);
    for (int i = 0; i < golden_steps && best.cost > 0.0; ++i) {
      const bool upper = high - best.t > best.t - low;
      const double t = upper ? best.t + golden * (high - best.t) : best.t - golden * (best.t - low);
      const Candidate probe = at(edge, t);
      if (probe.cost < best.cost) {
        (upper ? low : high) = best.t;
        best = probe;
      } else {
        (upper ? high : low) = t;
      }
    }
    return best;
  }

  const WorkingMesh& mesh_;
  const SpherePlan plan_;
  std::vector<AlgebraicSphere> sphere_;  // by vertex, about it
  std::vector<Quadric> held_;  // by vertex, about it: planes of boundaries and sharp edges
};

}  // namespace curvdecim::detail
