// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/triangle_tree.h"
#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/refine/match.h"
#include "vcg_ext/refine/surface_curve.h"

namespace curvdecim::detail {

/// Samples of curves of the mesh and of the input, such as their boundaries, each with the nearest
/// point of the other's curves, unless that one belongs to something else.
class CurveSamples {
 public:
  /// weight: against samples of the surface.
  CurveSamples(SurfaceCurve of_input, SurfaceCurve of_mesh, double weight,
               const MatchLimits& limits, const Parallel& parallel)
      : weight_(weight),
        limits_(limits),
        of_input_(std::move(of_input)),
        of_mesh_(std::move(of_mesh)) {
    if (of_input_.size() == 0 || of_mesh_.size() == 0 || !(weight > 0.0)) return;
    input_tree_.emplace(of_input_, of_input_.size(), parallel);
    mesh_tree_.emplace(of_mesh_, of_mesh_.size(), parallel);
  }

  /// With the mesh as it is now.
  void match(const Parallel& parallel) {
    if (!mesh_tree_) return;
    mesh_tree_->refit(parallel);
    of_edge_.assign(of_mesh_.size(), {});
    for (int e = 0; e < of_mesh_.size(); ++e) match_mesh_edge(e);
    for (int e = 0; e < of_input_.size(); ++e) match_input_edge(e);
  }

  int edge_count() const { return static_cast<int>(of_edge_.size()); }
  Edge edge(int e) const { return of_mesh_.edges[e]; }
  Triangle triangle(int e) const { return of_mesh_.triangle(e); }
  const std::vector<Match>& of_edge(int e) const { return of_edge_[e]; }

 private:
  static constexpr int per_mesh_edge = 4, per_input_edge = 2;

  /// A sample counts by the length that it stands for times that of the mesh's edge: an area.
  void match_mesh_edge(int e) {
    const Triangle edge = of_mesh_.triangle(e);
    const double length = of_mesh_.length(e);
    for (int i = 0; i < per_mesh_edge; ++i) {
      const Barycentric w = along(i, per_mesh_edge);
      SurfacePoint found = input_tree_->nearest(at(edge, w), SurfacePoint::none);
      limits_.round(found);
      const Vector3 target = at(of_input_.triangle(found.face), found.weight);
      if (has_nearer(*mesh_tree_, target, found)) continue;
      of_edge_[e].push_back(
          {w, target, weight_ * length * length / per_mesh_edge, found.distance2});
    }
  }

  void match_input_edge(int e) {
    const Triangle edge = of_input_.triangle(e);
    for (int i = 0; i < per_input_edge; ++i) {
      const Vector3 p = at(edge, along(i, per_input_edge));
      SurfacePoint found = mesh_tree_->nearest(p, SurfacePoint::none);
      limits_.round(found);
      if (has_nearer(*input_tree_, at(of_mesh_.triangle(found.face), found.weight), found))
        continue;
      const auto [w0, w1, w2] = found.weight;
      const double length = of_input_.length(e) * of_mesh_.length(found.face);
      of_edge_[found.face].push_back(
          {{w0, w1 + w2, 0.0}, p, weight_ * length / per_input_edge, found.distance2});
    }
  }

  /// True if the match is much nearer to another place of the curves that the sample is of. Then
  /// the sample's own place has no counterpart: its hole was closed, or torn open.
  static bool has_nearer(const TriangleTree<SurfaceCurve>& own, const Vector3& match,
                         const SurfacePoint& found) {
    constexpr double much2 = 0.25;  // squared: half as far
    const Vector3 any_way = Vector3::Zero();
    return own.nearest_facing(match, any_way, much2 * found.distance2, SurfacePoint::none).found();
  }

  static Barycentric along(int i, int count) {
    const double t = (i + 0.5) / count;
    return {1.0 - t, t, 0.0};
  }

  const double weight_;
  const MatchLimits limits_;
  SurfaceCurve of_input_, of_mesh_;
  std::optional<TriangleTree<SurfaceCurve>> input_tree_, mesh_tree_;
  std::vector<std::vector<Match>> of_edge_;  // by edge of the mesh
};

}  // namespace curvdecim::detail
