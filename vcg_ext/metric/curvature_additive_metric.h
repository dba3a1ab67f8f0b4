// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "vcg_ext/metric/quadric_metric.h"

namespace curvdecim::detail {

/// Quadric error plus lambda times a discrete curvature of the edge @cite yao2015, equation 8. The
/// printed curvature is ambiguous; docs/decisions/yao-curvature-term.md has both readings.
class CurvatureAdditiveMetric {
 public:
  CurvatureAdditiveMetric(const WorkingMesh& mesh, const CurvatureAdditivePlan& plan)
      : mesh_(mesh), plan_(plan), quadric_(mesh, plan.quadrics) {}

  void initialize(const Parallel& parallel) { quadric_.initialize(parallel); }

  std::optional<Candidate> evaluate(Edge edge, Allowed allowed, const Vector3& wings) const {
    std::optional<Candidate> candidate = quadric_.evaluate(edge, allowed, wings);
    if (candidate) candidate->cost += additive_term(edge);
    return candidate;
  }

  void estimate(int v, const std::vector<int>& others, std::vector<double>& costs) const {
    quadric_.estimate(v, others, costs);
    for (std::size_t i = 0; i < others.size(); ++i) costs[i] += additive_term({v, others[i]});
  }

  void release(const EdgeNeighborhood& around, const std::vector<FacePlane>& after) {
    quadric_.release(around, after);
  }

  void merge(const VertexMerge& merge, const EdgeNeighborhood& around) {
    quadric_.merge(merge, around);
  }

  void renew(int v, int source) { quadric_.renew(v, source); }

  void renumber(const Renumbering& numbers) { quadric_.renumber(numbers); }

 private:
  double additive_term(Edge edge) const {
    return plan_.lambda * plane_unit(edge) * edge_curvature(edge);
  }

  /// What one plane weighs around the edge, so that lambda means the same with area weights.
  double plane_unit(Edge edge) const {
    if (plan_.quadrics.plane_weight == PlaneWeight::Unit) return 1.0;
    double area = 0.0;
    int faces = 0;
    for (int v : {edge.a, edge.b})
      for (int f : mesh_.connectivity.faces_of(v)) area += mesh_.plane[f].area, ++faces;
    return area / faces;
  }

  /// Edge length times the largest deviation of a face around from the edge's own faces.
  double edge_curvature(Edge edge) const {
    double largest = 0.0;
    for (int v : {edge.a, edge.b})
      for (int f : mesh_.connectivity.faces_of(v)) largest = std::max(largest, deviation(f, edge));
    return largest * (mesh_.position[edge.b] - mesh_.position[edge.a]).norm();
  }

  double deviation(int f, Edge edge) const {
    const bool melax = plan_.term == CurvatureTerm::Melax;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (int wing : mesh_.connectivity.faces_of(edge.a)) {
      if (!mesh_.connectivity.face_has(wing, edge.b)) continue;
      const double cosine = mesh_.plane[f].normal.dot(mesh_.plane[wing].normal);
      least = std::min(least, 0.5 * (1.0 - cosine));
      most = std::max(most, cosine);
    }
    if (std::isinf(least)) return 1.0;  // a pair has no face: the most that there can be
    return melax ? least : most;
  }

  const WorkingMesh& mesh_;
  const CurvatureAdditivePlan plan_;
  QuadricMetric quadric_;
};

}  // namespace curvdecim::detail
