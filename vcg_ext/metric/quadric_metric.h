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
/// both ends. Accumulated, a vertex carries the planes of all that was merged into it; memoryless
/// @cite lindstrom1998, it carries those of the faces around it now.
class QuadricMetric {
 public:
  QuadricMetric(const WorkingMesh& mesh, const EdgeCollapseParams& params) : mesh_(mesh), params_(params) {}

  void initialize(const Parallel& parallel) {
    constraint_ = ConstraintQuadrics(mesh_, params_, params_.plane_weight).build();
    quadric_.resize(mesh_.position.size());
    parallel.for_each(static_cast<int>(quadric_.size()), [this](int v) { recompute(v); });
    if (params_.quadrics == Quadrics::Accumulated) constraint_ = {};  // from now on inside quadric_
  }

  std::optional<Candidate> evaluate(Edge edge, Allowed allowed) const {
    const Vector3 &a = mesh_.position[edge.a], &b = mesh_.position[edge.b];
    const Vector3 half = 0.5 * (b - a);
    const Quadric q = quadric_[edge.a].with_origin_moved(half) + quadric_[edge.b].with_origin_moved(-half);
    const Placed placed = place(q, half, allowed, params_.placement);
    const double cost = std::max(q.value(placed.offset), 0.0);
    if (placed.offset == -half) return Candidate{cost, a, 0.0};  // not rounded: the vertex itself
    if (placed.offset == half) return Candidate{cost, b, 1.0};
    return Candidate{cost, a + (half + placed.offset), placed.t};
  }

  /// ring: the neighbours of collapse.keep.
  void merge(const Collapse& collapse, const std::vector<int>& ring) {
    if (params_.quadrics == Quadrics::Accumulated) return add(quadric_, collapse);
    if (!constraint_.empty()) add(constraint_, collapse);
    recompute(collapse.keep);
    for (int v : ring) recompute(v);
  }

 private:
  void recompute(int v) {
    quadric_[v] = constraint_.empty() ? Quadric{} : constraint_[v];
    quadric_[v].a += plane_quadric(mesh_, v, params_.plane_weight);
  }

  void add(std::vector<Quadric>& quadrics, const Collapse& collapse) const {
    const Vector3& now = mesh_.position[collapse.keep];
    quadrics[collapse.keep] = quadrics[collapse.keep].with_origin_moved(now - collapse.keep_was) +
                              quadrics[collapse.gone].with_origin_moved(now - collapse.gone_was);
  }

  const WorkingMesh& mesh_;
  const EdgeCollapseParams& params_;
  std::vector<Quadric> quadric_;     // by vertex, about the vertex
  std::vector<Quadric> constraint_;  // by vertex, about the vertex; empty: none
};

}  // namespace curvdecim
