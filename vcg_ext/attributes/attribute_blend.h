// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/collapse/collapse_observer.h"
#include "vcg_ext/mesh/blend_step.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

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

/// Notes for every collapse where, on the surface just before it, the merged vertex takes its
/// attributes from: the nearest point of the faces around the edge. An attribute that is affine in
/// position is so carried over the surface and not only along the edge. Where no attribute but the
/// normal varies, the nearest point of the edge will do, and takes less time and memory. Where
/// corners are told apart, the steps are those of the charts (mesh/edge_charts.h) and of wedges.
class BlendRecord : public CollapseObserver {
 public:
  /// vary: attributes other than the normal do. expected: collapses, to have room for; may be
  /// exceeded. by_wedge: corners are told apart.
  explicit BlendRecord(bool vary = true, std::size_t expected = 0, bool by_wedge = false)
      : is_nearest_(vary), by_wedge_(by_wedge) {
    is_over_surface() ? steps_.over_surface.reserve(expected) : steps_.on_edge.reserve(expected);
  }

  /// The record of collapses that were done already.
  explicit BlendRecord(std::vector<BlendStep> steps) : steps_{std::move(steps), {}, {}} {}

  /// Whether steps go to the nearest point of the faces around; otherwise of the edge.
  bool is_nearest() const { return is_nearest_; }

  /// Whether steps are noted as those over the surface are.
  bool is_over_surface() const { return is_nearest_ || by_wedge_; }

  /// For the first collapses, which no mesh is at hand for: to be appended as is_over_surface()
  /// says.
  BlendSteps& first_steps() { return steps_; }

  void make_room(int count) override {
    if (by_wedge_) {
      if (others_.empty()) before_others_ = steps_.count();
      others_.resize(count - before_others_);
    }
    is_over_surface() ? steps_.over_surface.resize(count) : steps_.on_edge.resize(count);
  }

  void before(const WorkingMesh& mesh, const EdgeNeighborhood& around, const EdgeCharts& charts,
              const VertexMerge& merge, int number) override {
    for (int c = 0; c < charts.count(); ++c) note(charts.step(mesh, merge, c, is_nearest_), number);
    if (charts.count() > 0 || merge.now == merge.keep_was) return;
    const int keep = mesh.vertex_origin[merge.keep];
    if (!is_over_surface()) {
      steps_.on_edge[number] = {keep, mesh.vertex_origin[merge.gone], float(merge.t)};
      return;
    }
    BlendStep& step = steps_.over_surface[number];
    step = nearest_on_surface(mesh, around, merge);
    step.keep = keep;
    for (int& v : step.from) v = mesh.vertex_origin[v];
  }

  void copied(const WorkingMesh& mesh, int v, int source, const std::vector<Wedges::Parted>& wedges,
              int number) override {
    for (const auto [now, was] : wedges) note(step_on_edge(now, was, 1.0), number);
    if (!wedges.empty()) return;
    const int to = mesh.vertex_origin[v], from = mesh.vertex_origin[source];
    if (is_over_surface())
      steps_.over_surface[number] = step_on_edge(to, from, 1.0);
    else
      steps_.on_edge[number] = {to, from, 1.0f};
  }

  void renumber(const Renumbering&) override {}

  /// What follows after the collapses.
  void append(const std::vector<BlendStep>& steps) {
    steps_.over_surface.insert(steps_.over_surface.end(), steps.begin(), steps.end());
  }

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

  /// The steps of collapse i beyond the first.
  template <class Use>
  void replay_others(int i, Use& use) const {
    const int place = i - before_others_;
    if (i < before_others_ || place >= static_cast<int>(others_.size())) return;
    for (const BlendStep& step : others_[place]) use(step);
  }

  /// One of the steps of a collapse, of wedges.
  void note(const BlendStep& step, int number) {
    if (step.keep == BlendStep::none) return;
    BlendStep& first = steps_.over_surface[number];
    if (first.keep == BlendStep::none)
      first = step;
    else
      others_[number - before_others_].push_back(step);
  }

  template <class Use>
  void replay(int begin, int end, Use& use) const {
    for (int i = begin; i < end; ++i)
      if (is_over_surface()) {
        if (steps_.over_surface[i].keep != BlendStep::none) use(steps_.over_surface[i]);
        replay_others(i, use);
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

  bool is_nearest_ = true, by_wedge_ = false;
  BlendSteps steps_;  // by collapse
  std::vector<std::vector<BlendStep>>
      others_;  // by collapse after the first ones: beyond the first
  int before_others_ = std::numeric_limits<int>::max();
};

}  // namespace curvdecim::detail
