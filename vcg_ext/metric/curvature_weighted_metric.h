// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "vcg_ext/curvature/curvature_weight.h"
#include "vcg_ext/metric/quadric_metric.h"

namespace curvdecim {

/// Quadric error times a factor that grows with the curvature at both ends @cite pellizzoni2020,
/// equation 8. The curvature is that of the current mesh.
class CurvatureWeightedMetric {
 public:
  /// diagonal: of the input in its own unit.
  CurvatureWeightedMetric(const WorkingMesh& mesh, const EdgeCollapseParams& params, double diagonal)
      : mesh_(mesh), params_(params), diagonal_(diagonal), quadric_(mesh, params), weight_(0.0, 1.0, 1.0) {}

  void initialize(const Parallel& parallel) {
    quadric_.initialize(parallel);
    const std::vector<VertexCurvature> curvature = vertex_curvatures(mesh_, parallel);
    weight_ = curvature_weight(params_, curvature, diagonal_);
    for (const VertexCurvature& c : curvature) curvature_.push_back(c.of_kind(params_.curvature_kind));
    angles_.resize(mesh_.plane.size());
    parallel.for_each(static_cast<int>(angles_.size()), [this](int f) { update_angles(f); });
  }

  std::optional<Candidate> evaluate(Edge edge, Allowed allowed) const {
    std::optional<Candidate> candidate = quadric_.evaluate(edge, allowed);
    if (candidate) candidate->cost *= weight_(curvature_[edge.a] + curvature_[edge.b]);
    return candidate;
  }

  void merge(const Collapse& collapse, const std::vector<int>& ring) {
    quadric_.merge(collapse, ring);
    for (int f : mesh_.connectivity.faces_of(collapse.keep)) update_angles(f);
    update(collapse.keep);
    for (int v : ring) update(v);
  }

 private:
  void update(int v) {
    const auto remembered = [this](int f, int i) { return angles_[f][i]; };
    curvature_[v] = vertex_curvature(mesh_, v, remembered).of_kind(params_.curvature_kind);
  }

  void update_angles(int f) {
    for (int i = 0; i < 3; ++i) angles_[f][i] = corner_angle(mesh_, f, i);
  }

  const WorkingMesh& mesh_;
  const EdgeCollapseParams& params_;
  const double diagonal_;
  QuadricMetric quadric_;
  CurvatureWeight weight_;
  std::vector<std::array<double, 3>> angles_;  // by face and corner: most stay as they are in a collapse
  std::vector<double> curvature_;  // by vertex, of the current mesh in its box of diagonal 1
};

}  // namespace curvdecim
