// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/collapse/collapse_observer.h"
#include "vcg_ext/geometry/blend.h"
#include "vcg_ext/geometry/closest_point.h"

namespace curvdecim::detail {

/// The attributes of `keep` become the weighted sum of those of three vertices. Vertices have the
/// numbers that they had at the start.
struct BlendStep {
  static constexpr int none = -1;

  int keep = none;  ///< none: nothing changes
  Face from{};
  std::array<float, 3> weight{};  // barycentric: one record a collapse, so that it has to be small

  static BlendStep at(int keep, const Face& from, const Barycentric& w) {
    return {keep, from, {float(w[0]), float(w[1]), float(w[2])}};
  }
};

/// Notes for every collapse where, on the surface just before it, the merged vertex takes its
/// attributes from: the nearest point of the faces around the edge. An attribute that is affine in
/// position is so carried over the surface and not only along the edge. Where no attribute but the
/// normal varies, the nearest point of the edge will do, and takes less memory.
class BlendRecord : public CollapseObserver {
 public:
  /// expected: collapses, to have room for; may be exceeded.
  explicit BlendRecord(bool over_surface = true, std::size_t expected = 0)
      : is_over_surface_(over_surface) {
    over_surface ? over_surface_.reserve(expected) : on_edge_.reserve(expected);
  }

  /// The record of collapses that were done already.
  explicit BlendRecord(std::vector<BlendStep> steps) : over_surface_(std::move(steps)) {}

  void make_room(int count) override {
    is_over_surface_ ? over_surface_.resize(count) : on_edge_.resize(count);
  }

  void before(const WorkingMesh& mesh, const EdgeNeighborhood& around, const VertexMerge& merge,
              int number) override {
    if (merge.now == merge.keep_was) return;
    const int keep = mesh.vertex_origin[merge.keep];
    if (!is_over_surface_) {
      on_edge_[number] = {keep, mesh.vertex_origin[merge.gone], float(merge.t)};
      return;
    }
    BlendStep& step = over_surface_[number];
    step = nearest_on_surface(mesh, around, merge);
    step.keep = keep;
    for (int& v : step.from) v = mesh.vertex_origin[v];
  }

  void copied(const WorkingMesh& mesh, int v, int source, int number) override {
    const int to = mesh.vertex_origin[v], from = mesh.vertex_origin[source];
    if (is_over_surface_)
      over_surface_[number] = on_edge(to, from, 1.0);
    else
      on_edge_[number] = {to, from, 1.0f};
  }

  void renumber(const Renumbering&) override {}

  /// use(BlendStep), in the order of the collapses.
  template <class Use>
  void for_each(Use use) const {
    for (const BlendStep& step : over_surface_)
      if (step.keep != BlendStep::none) use(step);
    for (const EdgeStep& step : on_edge_)
      if (step.keep != BlendStep::none) use(on_edge(step.keep, step.gone, step.t));
  }

 private:
  struct EdgeStep {
    int keep = BlendStep::none, gone = BlendStep::none;
    float t = 0.0f;
  };

  static BlendStep on_edge(int keep, int gone, double t) {
    return BlendStep::at(keep, {keep, gone, gone}, {1.0 - t, t, 0.0});
  }

  static BlendStep nearest_on_surface(const WorkingMesh& mesh, const EdgeNeighborhood& around,
                                      const VertexMerge& merge) {
    const Vector3& x = merge.now;
    BlendStep nearest = on_edge(merge.keep, merge.gone, merge.t);
    double least = std::numeric_limits<double>::infinity();
    for (const auto* faces : {&around.wings(), &around.star()})
      for (int f : *faces) {
        const Triangle triangle = mesh.triangle(f);
        const double height = mesh.plane[f].normal.dot(x - triangle[0]);
        if (height * height >= least) continue;  // its plane is further away already
        const Barycentric weight = closest_point(triangle, x);
        const double distance2 = (at(triangle, weight) - x).squaredNorm();
        if (distance2 < least)
          least = distance2, nearest = BlendStep::at(merge.keep, mesh.connectivity.face(f), weight);
      }
    return nearest;
  }

  bool is_over_surface_ = true;
  std::vector<BlendStep> over_surface_;  // by collapse, one of the two
  std::vector<EdgeStep> on_edge_;
};

/// A step's `keep` takes the blend of `from`, which may be the same values.
template <class Value>
void take(const BlendStep& step, const std::vector<Value>& from, std::vector<Value>& values) {
  Blend<Value> blend(values[step.keep]);
  for (int i = 0; i < 3; ++i) blend.add(step.weight[i], from[step.from[i]]);
  values[step.keep] = blend.mean();
}

}  // namespace curvdecim::detail
