// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "vcg_ext/attributes/attribute_blend.h"
#include "vcg_ext/attributes/charts.h"
#include "vcg_ext/attributes/corner_values.h"
#include "vcg_ext/geometry/closest_point.h"

namespace curvdecim::detail {

/// Where several of the host's vertices became one vertex of the run and carry different values:
/// which of these copies each corner belongs to, and how the values of the copies follow from each
/// other. In a collapse the corners around the edge fall into charts (charts.h); each chart goes on
/// as one copy, with the values of its own point nearest to the merged vertex. So values do not mix
/// across a seam, and all copies lie in one place.
class CornerCopies : public CollapseObserver {
 public:
  /// of_corner: copies by face. host: by copy, the host's vertex.
  CornerCopies(std::vector<Face> of_corner, std::vector<int> host)
      : of_corner_(of_corner), at_start_(std::move(of_corner)), host_(std::move(host)) {}

  void make_room(int count) override { steps_.resize(count); }

  void before(const WorkingMesh& mesh, const EdgeNeighborhood& around, const VertexMerge& merge,
              int number) override {
    const auto charts =
        charts_around<int>(mesh, around, merge, [&](int f, int i) { return of_corner_[f][i]; });
    for (const Chart<int>& chart : charts) {
      const auto [copy, is_of_keep] = standing(chart, merge);
      if (is_of_keep && merge.now == merge.keep_was) continue;  // it keeps its bits
      if (const FacePoint point = nearest_point(chart.faces, mesh, merge.now); point.face >= 0)
        steps_[number].push_back(BlendStep::at(copy, of_corner_[point.face], point.weight));
    }
    for (const Chart<int>& chart : charts) assign(mesh, around, merge, chart);
  }

  /// A copy of a vertex has copies of its own.
  void copied(const WorkingMesh& mesh, int v, int /*source*/, int number) override {
    std::vector<std::pair<int, int>> renamed;
    for (int f : mesh.connectivity.faces_of(v)) {
      int& copy = of_corner_.at(mesh, f, v);
      const auto known = std::find_if(renamed.begin(), renamed.end(),
                                      [&](const auto& pair) { return pair.first == copy; });
      const int now = known != renamed.end() ? known->second : add_copy_of(copy, number);
      renamed.push_back({copy, now});
      copy = now;
    }
  }

  void added(const WorkingMesh& mesh, int f) override { of_corner_.add(mesh, f); }

  void renumber(const Renumbering& numbers) override { of_corner_.renumber(numbers); }

  // --- the result -------------------------------------------------------------------------------

  const Face& of_face(int f) const { return of_corner_[f]; }
  /// By copy: the host's vertex that it was.
  const std::vector<int>& host() const { return host_; }

  /// use(BlendStep), in the order of the collapses.
  template <class Use>
  void for_each(Use use) const {
    for (const std::vector<BlendStep>& steps : steps_)
      std::for_each(steps.begin(), steps.end(), use);
  }

  // --- refinement, once the collapses are done ---------------------------------------------------

  /// The copies of a face's corners at the start.
  const Face& of_start_face(int f) const { return at_start_[f]; }

  CornerValues<int>& values() { return of_corner_; }
  const CornerValues<int>& values() const { return of_corner_; }

 private:
  /// Returns the new one's number.
  int add_copy_of(int copy, int number) {
    const int now = static_cast<int>(host_.size());
    host_.push_back(host_[copy]);
    steps_[number].push_back(BlendStep::at(now, {copy, copy, copy}, {1.0, 0.0, 0.0}));
    return now;
  }

  /// The copy that a chart goes on as, and whether it is one of the vertex that is kept.
  static std::pair<int, bool> standing(const Chart<int>& chart, const VertexMerge& merge) {
    for (const auto& corner : chart.corners)
      if (corner.vertex == merge.keep) return {corner.at, true};
    return {chart.corners[0].at, false};
  }

  void assign(const WorkingMesh& mesh, const EdgeNeighborhood& around, const VertexMerge& merge,
              const Chart<int>& chart) {
    const int copy = standing(chart, merge).first;
    for (int f : chart.faces)
      for (int i = 0; i < 3 && !is_wing(around, f); ++i)
        if (const int v = mesh.connectivity.face(f)[i]; v == merge.keep || v == merge.gone)
          of_corner_[f][i] = copy;
  }

  CornerValues<int> of_corner_;  // the copies that corners belong to
  std::vector<Face> at_start_;
  std::vector<int> host_;                      // by copy
  std::vector<std::vector<BlendStep>> steps_;  // by collapse
};

}  // namespace curvdecim::detail
