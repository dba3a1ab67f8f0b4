// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "vcg_ext/curvature/vertex_spheres.h"
#include "vcg_ext/metric/quadric_metric.h"
#include "vcg_ext/metric/sphere_ring.h"

namespace curvdecim::detail {

/// Distance of the new faces to algebraic spheres @cite michaud2017, together with the memoryless
/// quadric error, and the position in space that minimises both. A vertex carries the fit sums of
/// all of the input that has gone into it, and its sphere is fitted to them; a face's is the mean
/// of its corners'. Spheres count as far as they can be trusted: what they leave on the input
/// itself and on its normals is doubt (docs/decisions/anchored-spheres.md). Sharp vertices have
/// none; the planes hold them.
class AnchoredSphereMetric {
 public:
  AnchoredSphereMetric(const WorkingMesh& mesh, const SpherePlan& plan)
      : mesh_(mesh), plan_(plan), planes_(mesh, plan.quadrics) {}

  void initialize(const Parallel& parallel) {
    planes_.initialize(parallel);
    fit_spheres(parallel);
    measure_doubt(parallel);
  }

  std::optional<Candidate> evaluate(Edge edge, Allowed allowed, const Vector3& wings) const {
    std::optional<Candidate> candidate = planes_.evaluate(edge, allowed, wings);
    if (!candidate) return candidate;
    const Quadric planes = planes_.of_edge(edge);
    const double squares = candidate->cost;
    candidate->cost = planes_in_unit_of(plan_.energy, squares, planes.a.trace());
    if (squares == 0.0 || !has_sphere(edge)) return candidate;
    const View view = look(edge, candidate->position);
    const Errors errors = errors_of(squares, planes, view);
    candidate->cost = errors.cost();
    if (allowed != Allowed::Anywhere || !is_inside(edge)) return candidate;
    return nearer_to_both(edge, planes, *candidate, view, errors);
  }

  /// By the planes alone: spheres decide where the vertex goes rather than which edge is cheapest.
  void estimate(int v, const std::vector<int>& others, std::vector<double>& costs) const {
    planes_.estimate(v, others, costs);
    if (plan_.energy == SphereEnergy::Squared) return;
    for (std::size_t i = 0; i < others.size(); ++i)
      costs[i] =
          planes_in_unit_of(plan_.energy, costs[i], planes_.weight(v) + planes_.weight(others[i]));
  }

  void release(const EdgeNeighborhood& around, const std::vector<FacePlane>& after) {
    planes_.release(around, after);
  }

  void merge(const VertexMerge& merge, const EdgeNeighborhood& around) {
    planes_.merge(merge, around);
    anchor_[merge.keep] =
        merged(merge.keep, merge.now - merge.keep_was, merge.gone, merge.now - merge.gone_was);
  }

  void renew(int v, int source) {
    planes_.renew(v, source);
    anchor_[v] = anchor_[source];
  }

  void renumber(const Renumbering& numbers) {
    planes_.renumber(numbers), numbers.vertices(anchor_);
  }

 private:
  /// How many times the doubt weighs against the energy: at this ratio a sphere counts half.
  static constexpr double caution = 3.0;
  static constexpr int hub = 64;  // faces around an edge, from which on the planes will do

  /// What a vertex knows of the input that has gone into it, about it.
  struct Anchor {
    SphereSums sums;  // no weight: there is no sphere
    AlgebraicSphere sphere;
    double doubt = 0.0;  // integral of the squared distance of the input to the spheres, length^4
  };

  /// The new faces seen from a position of the merged vertex.
  struct View {
    RingEnergy energy;
    Quadric distance;  // sum of area x (mean distance)^2, as a function of the vertex's step
    double trust = 0.0;
  };

  /// In the unit of the energy.
  struct Errors {
    double of_planes;
    double both;  // the mean of both, the spheres' by its trust

    /// Planes take a surface that curves evenly for an error, spheres know better. What spheres
    /// call an error and planes do not is mostly their own.
    double cost() const { return std::min(of_planes, both); }
  };

  void fit_spheres(const Parallel& parallel) {
    const VertexSpheres fits(mesh_, plan_.kernel, plan_.quadrics.feature_angle, parallel);
    const std::vector<AlgebraicSphere> spheres = fits.fit();
    anchor_.resize(spheres.size());
    parallel.for_each(static_cast<int>(anchor_.size()), [&](int v) {
      const SphereSample& sample = fits.sample_of(v);
      if (sample.sharp) return;
      anchor_[v].sums = sums_of_cell(spheres[v], sample.area);
      anchor_[v].sphere = anchor_[v].sums.fit();
    });
  }

  /// Sums over the points that are nearer to the vertex than to others, taken as a disk around
  /// it, with the normals of the fitted sphere: they overlap with no other vertex's, so that sums
  /// over many vertices are a fit to just their part of the surface.
  static SphereSums sums_of_cell(const AlgebraicSphere& sphere, double area) {
    const double length = sphere.l.norm();
    if (!(area > 0.0) || !(length > 0.0)) return {};
    const double point2 = area * area / (2.0 * M_PI);  // of a disk about its middle
    return {area, Vector3::Zero(), (area / length) * sphere.l, point2,
            2.0 * sphere.q / length * point2};
  }

  /// What the spheres leave on the input's own faces.
  void measure_doubt(const Parallel& parallel) {
    std::vector<double> of_face(mesh_.plane.size());
    parallel.for_each(static_cast<int>(of_face.size()), [&](int f) {
      const auto [a, b, c] = mesh_.connectivity.face(f);
      RingEnergy energy;
      energy.add(face_sphere(anchor_[a], mesh_.position[a], b, c),
                 {Vector3::Zero(), mesh_.position[b] - mesh_.position[a],
                  mesh_.position[c] - mesh_.position[a]});
      of_face[f] = energy.squared;
    });
    parallel.for_each(static_cast<int>(anchor_.size()), [&](int v) {
      for (int f : mesh_.connectivity.faces_of(v)) anchor_[v].doubt += of_face[f] / 3.0;
    });
  }

  bool has_sphere(Edge edge) const {
    const TriangleConnectivity& c = mesh_.connectivity;
    return anchor_[edge.a].sums.weight > 0.0 && anchor_[edge.b].sums.weight > 0.0 &&
           c.faces_of(edge.a).size() + c.faces_of(edge.b).size() <= hub;
  }

  bool is_inside(Edge edge) const {
    return mesh_.kind[edge.a] == VertexKind::Interior && mesh_.kind[edge.b] == VertexKind::Interior;
  }

  /// The anchor of two vertices, seen from the place that lies these steps away from them.
  Anchor merged(int a, const Vector3& from_a, int b, const Vector3& from_b) const {
    Anchor anchor;
    if (!(anchor_[a].sums.weight > 0.0) || !(anchor_[b].sums.weight > 0.0)) return anchor;
    anchor.sums = anchor_[a].sums.with_origin_moved(from_a);
    anchor.sums += anchor_[b].sums.with_origin_moved(from_b);
    anchor.sphere = anchor.sums.fit();
    anchor.doubt = anchor_[a].doubt + anchor_[b].doubt;
    return anchor;
  }

  /// The mean of the spheres that a face's corners have, about the one at x.
  AlgebraicSphere face_sphere(const Anchor& at, const Vector3& x, int u, int v) const {
    AlgebraicSphere sum = at.sphere;
    int count = at.sums.weight > 0.0;
    for (int corner : {u, v}) {
      if (!(anchor_[corner].sums.weight > 0.0)) continue;
      sum += anchor_[corner].sphere.with_origin_moved(x - mesh_.position[corner]);
      ++count;
    }
    return count > 1 ? sum * (1.0 / count) : sum;
  }

  View look(Edge edge, const Vector3& x) const {
    View view;
    const Anchor at =
        merged(edge.a, x - mesh_.position[edge.a], edge.b, x - mesh_.position[edge.b]);
    for_faces_after(mesh_, edge, x, [&](const Triangle& t, int u, int v) {
      const AlgebraicSphere sphere = face_sphere(at, x, u, v);
      const double before = view.energy.area;
      view.energy.add(sphere, t);
      add_distance(sphere, t, view.energy.area - before, view.distance);
    });
    view.trust = trust_in(at, view.energy);
    return view;
  }

  /// The mean distance of a face changes by a third of what its vertex at the origin moves along
  /// the gradient.
  static void add_distance(const AlgebraicSphere& sphere, const Triangle& t, double area,
                           Quadric& sum) {
    const Vector3 third = sphere.gradient((t[1] + t[2]) / 3.0) / 3.0;
    const double mean = mean_over(sphere, t);
    sum += {Symmetric3::outer(third, area), (area * mean) * third, area * mean * mean};
  }

  /// 0..1: the energy against what it may be by the spheres' own fault.
  double trust_in(const Anchor& at, const RingEnergy& energy) const {
    const double fault = caution * energy.area * (at.doubt / at.sums.weight + at.sums.doubt());
    const double energy2 = energy.squared * energy.squared;
    return energy2 > 0.0 ? energy2 / (energy2 + fault * fault) : 0.0;
  }

  Errors errors_of(double squares, const Quadric& planes, const View& view) const {
    const double of_planes = planes_in_unit_of(plan_.energy, squares, planes.a.trace());
    const double of_spheres = view.energy.of(plan_.energy);
    return {of_planes, (of_planes + view.trust * of_spheres) / (1.0 + view.trust)};
  }

  /// The candidate, where the view was taken, or one at the minimum of both errors if that is less.
  Candidate nearer_to_both(Edge edge, const Quadric& planes, const Candidate& candidate,
                           const View& view, const Errors& errors) const {
    const Vector3 half = 0.5 * (mesh_.position[edge.b] - mesh_.position[edge.a]);
    const Vector3 midpoint = mesh_.position[edge.a] + half;
    const auto step = step_to_minimum(planes, candidate.position - midpoint, view, half);
    if (!step) return candidate;
    const Vector3 x = candidate.position + *step;
    const Errors there = errors_of(planes.value(x - midpoint), planes, look(edge, x));
    if (!(there.both < errors.both)) return candidate;
    return {there.cost(), x, parameter_along(half, x - midpoint)};
  }

  /// From `offset`, where the view was taken, to the minimum of both. None where it would be longer
  /// than the edge.
  std::optional<Vector3> step_to_minimum(const Quadric& planes, const Vector3& offset,
                                         const View& view, const Vector3& half) const {
    const Quadric at = planes.with_origin_moved(offset);
    const Symmetric3 a = at.a + view.distance.a * view.trust;
    const double trace = a.trace();
    if (!(trace > 0.0)) return std::nullopt;
    const Vector3 step = -Factorization3(a.plus_diagonal(relative_pull * trace))
                              .solve(at.b + view.trust * view.distance.b);
    if (!(step.squaredNorm() <= 4.0 * half.squaredNorm())) return std::nullopt;
    return step;
  }

  const WorkingMesh& mesh_;
  const SpherePlan plan_;
  QuadricMetric planes_;
  std::vector<Anchor> anchor_;  // by vertex
};

}  // namespace curvdecim::detail
