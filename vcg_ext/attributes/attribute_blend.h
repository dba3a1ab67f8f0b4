// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/collapse/collapse_observer.h"
#include "vcg_ext/geometry/blend.h"
#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/parallel/parallel.h"

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

/// The attributes of `keep` move towards those of `gone`. Vertices have the numbers that they had
/// at the start.
struct EdgeStep {
  int keep = BlendStep::none;
  int gone = BlendStep::none;
  float t = 0.0f;  ///< 0..1, from keep to gone
};

/// How attributes went along some collapses, in an order in which it can be replayed: by one of the
/// two.
struct BlendSteps {
  std::vector<BlendStep> over_surface;
  std::vector<EdgeStep> on_edge;
  std::vector<std::vector<int>> stages;  // ends of runs of steps; those of a stage share no vertex

  int count() const { return static_cast<int>(over_surface.size() + on_edge.size()); }

  void append(const BlendSteps& o) {
    over_surface.insert(over_surface.end(), o.over_surface.begin(), o.over_surface.end());
    on_edge.insert(on_edge.end(), o.on_edge.begin(), o.on_edge.end());
  }

  void begin_stage() { stages.emplace_back(); }

  /// What was appended since the stage or the last run began.
  void end_run() { stages.back().push_back(count()); }
};

inline BlendStep step_on_edge(int keep, int gone, double t) {
  return BlendStep::at(keep, {keep, gone, gone}, {1.0 - t, t, 0.0});
}

/// Finds the nearest point to x on some faces.
class NearestStep {
 public:
  /// otherwise: the step where there is no face.
  NearestStep(const Vector3& x, const BlendStep& otherwise) : x_(x), step_(otherwise) {}

  /// corners: numbers of the face's vertices; normal: of length 1, or zero.
  void look_at(const Triangle& triangle, const Vector3& normal, const Face& corners) {
    const double height = normal.dot(x_ - triangle[0]);
    if (height * height >= least2_) return;  // its plane is further away already
    const Barycentric weight = closest_point(triangle, x_);
    const double distance2 = (at(triangle, weight) - x_).squaredNorm();
    if (distance2 < least2_)
      least2_ = distance2, step_ = BlendStep::at(step_.keep, corners, weight);
  }

  const BlendStep& step() const { return step_; }

 private:
  const Vector3 x_;
  double least2_ = std::numeric_limits<double>::infinity();
  BlendStep step_;
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
    over_surface ? steps_.over_surface.reserve(expected) : steps_.on_edge.reserve(expected);
  }

  /// The record of collapses that were done already.
  explicit BlendRecord(std::vector<BlendStep> steps) : steps_{std::move(steps), {}, {}} {}

  bool is_over_surface() const { return is_over_surface_; }

  /// For the first collapses, which no mesh is at hand for: to be appended as is_over_surface()
  /// says.
  BlendSteps& first_steps() { return steps_; }

  void make_room(int count) override {
    is_over_surface_ ? steps_.over_surface.resize(count) : steps_.on_edge.resize(count);
  }

  void before(const WorkingMesh& mesh, const EdgeNeighborhood& around, const VertexMerge& merge,
              int number) override {
    if (merge.now == merge.keep_was) return;
    const int keep = mesh.vertex_origin[merge.keep];
    if (!is_over_surface_) {
      steps_.on_edge[number] = {keep, mesh.vertex_origin[merge.gone], float(merge.t)};
      return;
    }
    BlendStep& step = steps_.over_surface[number];
    step = nearest_on_surface(mesh, around, merge);
    step.keep = keep;
    for (int& v : step.from) v = mesh.vertex_origin[v];
  }

  void copied(const WorkingMesh& mesh, int v, int source, int number) override {
    const int to = mesh.vertex_origin[v], from = mesh.vertex_origin[source];
    if (is_over_surface_)
      steps_.over_surface[number] = step_on_edge(to, from, 1.0);
    else
      steps_.on_edge[number] = {to, from, 1.0f};
  }

  void renumber(const Renumbering&) override {}

  /// use(BlendStep), in the order of the collapses, or at the same time for such that have no
  /// vertex in common.
  template <class Use>
  void for_each(const Parallel& parallel, Use use) const {
    int begin = 0;
    for (const std::vector<int>& ends : steps_.stages) {
      const auto replay_run = [&](int i) { replay(i == 0 ? begin : ends[i - 1], ends[i], use); };
      parallel.for_each(static_cast<int>(ends.size()), replay_run, Grain{1, runs_at_once});
      if (!ends.empty()) begin = ends.back();
    }
    replay(begin, steps_.count(), use);
  }

 private:
  static constexpr int runs_at_once = 1024;  // between two looks at whether to go on

  template <class Use>
  void replay(int begin, int end, Use& use) const {
    for (int i = begin; i < end; ++i)
      if (is_over_surface_) {
        if (steps_.over_surface[i].keep != BlendStep::none) use(steps_.over_surface[i]);
      } else if (const auto [keep, gone, t] = steps_.on_edge[i]; keep != BlendStep::none) {
        use(step_on_edge(keep, gone, t));
      }
  }

  static BlendStep nearest_on_surface(const WorkingMesh& mesh, const EdgeNeighborhood& around,
                                      const VertexMerge& merge) {
    NearestStep nearest(merge.now, step_on_edge(merge.keep, merge.gone, merge.t));
    for (const auto* faces : {&around.wings(), &around.star()})
      for (int f : *faces)
        nearest.look_at(mesh.triangle(f), mesh.plane[f].normal, mesh.connectivity.face(f));
    return nearest.step();
  }

  bool is_over_surface_ = true;
  BlendSteps steps_;  // by collapse
};

/// A step's `keep` takes the blend of `from`, which may be the same values.
template <class Value>
void take(const BlendStep& step, const std::vector<Value>& from, std::vector<Value>& values) {
  Blend<Value> blend(values[step.keep]);
  for (int i = 0; i < 3; ++i) blend.add(step.weight[i], from[step.from[i]]);
  values[step.keep] = blend.mean();
}

}  // namespace curvdecim::detail
