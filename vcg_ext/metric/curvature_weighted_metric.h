// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
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
  CurvatureWeightedMetric(const WorkingMesh& mesh, const EdgeCollapseParams& params,
                          double diagonal)
      : mesh_(mesh),
        params_(params),
        diagonal_(diagonal),
        quadric_(mesh, params),
        weight_(0.0, 1.0, 1.0) {}

  void initialize(const Parallel& parallel) {
    quadric_.initialize(parallel);
    const int vertices = static_cast<int>(mesh_.position.size());
    angles_.resize(mesh_.plane.size());
    sums_.resize(vertices);
    saturation_.resize(vertices);
    std::vector<VertexCurvature> input(vertices);
    parallel.for_each(static_cast<int>(angles_.size()), [this](int f) { update_angles(f); });
    parallel.for_each(vertices, [&](int v) {
      sums_[v] = curvature_sums(mesh_, v, [this](int f, int i) { return angles_[f][i]; });
      input[v] = sums_[v].curvature(mesh_.kind[v]);
    });
    weight_ = curvature_weight(params_, input, diagonal_);
    parallel.for_each(vertices, [&](int v) {
      saturation_[v] = weight_.saturation(input[v].of_kind(params_.curvature_kind));
    });
  }

  std::optional<Candidate> evaluate(Edge edge, Allowed allowed) const {
    std::optional<Candidate> candidate = quadric_.evaluate(edge, allowed);
    if (candidate) candidate->cost *= weight_.of_edge(saturation_[edge.a], saturation_[edge.b]);
    return candidate;
  }

  void release(const EdgeNeighborhood& around) {
    quadric_.release(around);
    for (const auto* faces : {&around.wings(), &around.star()})
      for (int f : *faces) add(f, -1.0, around.edge());
  }

  void merge(const Collapse& collapse, const EdgeNeighborhood& around,
             const std::vector<int>& ring) {
    quadric_.merge(collapse, around, ring);
    sums_[collapse.keep] = {};
    for (int f : around.star()) {
      if (!mesh_.connectivity.alive(f)) continue;
      update_angles(f);
      add(f, 1.0, no_edge);
    }
    update(collapse.keep);
    for (int v : ring) update(v);
  }

 private:
  /// To the sums of the corners that are not on the edge.
  void add(int f, double sign, Edge edge) {
    for (int i = 0; i < 3; ++i)
      if (const int v = mesh_.connectivity.face(f)[i]; v != edge.a && v != edge.b)
        sums_[v].add(mesh_, f, i, angles_[f][i], sign);
  }

  void update(int v) {
    const VertexCurvature curvature = sums_[v].curvature(mesh_.kind[v]);
    saturation_[v] = weight_.saturation(curvature.of_kind(params_.curvature_kind));
  }

  void update_angles(int f) {
    const double first = corner_angle(mesh_, f, 0), second = corner_angle(mesh_, f, 1);
    angles_[f] = {first, second, std::max(M_PI - first - second, 0.0)};
  }

  const WorkingMesh& mesh_;
  const EdgeCollapseParams& params_;
  const double diagonal_;
  QuadricMetric quadric_;
  CurvatureWeight weight_;
  std::vector<std::array<double, 3>> angles_;  // by face and corner
  std::vector<CurvatureSums> sums_;            // by vertex
  std::vector<double> saturation_;             // by vertex, of the current mesh's curvature
};

}  // namespace curvdecim
