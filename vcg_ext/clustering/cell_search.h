// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/clustering/clusters.h"

namespace curvdecim::detail {

/// Looks for the diameter of the cells at which a number of faces is left.
///
/// The number falls with the diameter nearly like a power, so that a secant through two logarithms
/// finds the target in a few steps; where it jumps, bisection goes on. A sample of the faces tells
/// about where to begin. What is counted are faces between three cells; which share of them is left
/// without doubles, the clusters tell, and few of these have to be made.
template <class ClusterAt>
class CellSearch {
 public:
  /// cluster_at(diameter): the Clusters.
  CellSearch(const FlatMesh& mesh, int target, const Parallel& parallel, ClusterAt cluster_at)
      : mesh_(mesh),
        target_(target),
        parallel_(parallel),
        cluster_at_(std::move(cluster_at)),
        least_(std::log(CellGrid::least_diameter(mesh.half_size))),
        largest_(std::log(CellGrid::largest_diameter(mesh.half_size))),
        keys_(mesh.position.size()) {}

  /// The clusters whose number of faces is nearest to the target, of those tried; nullopt: all have
  /// none.
  std::optional<Clusters> run() {
    double at = nearest_to(estimated());
    try_at(at);
    for (int round = 1; round < most_rounds && !is_good(); ++round)
      if (const double before = std::exchange(at, nearest_to(at)); at != before) try_at(at);
    for (int i = 1; i <= most_steps_aside && !is_good(); ++i)
      for (int side : {-1, 1})
        if (const double aside = at + side * i * step_aside; promises(aside)) try_at(aside);
    return std::move(best_);
  }

 private:
  static constexpr int most_samples = 1 << 13;  // estimates then scatter by some per cent
  static constexpr double near = 0.03;          // so that they need not be nearer
  static constexpr double close = 0.015;        // miss of a count, of the target
  static constexpr double good = 0.02;          // miss, of the target
  static constexpr double none = std::numeric_limits<double>::infinity();
  static constexpr int most_rounds = 4;  // the share is known after one or two

  // The numbers around a jump, found by bisection, rise and fall by some per cent.
  static constexpr int most_steps_aside = 3;
  static constexpr double step_aside = 0.01;  // of the diameter

  /// Brackets a diameter's logarithm between too many faces and too few.
  class Secant {
   public:
    Secant(double low, double high, double start) : low_(low), high_(high), at_(start) {}

    double at() const { return at_; }
    bool goes_on() const { return steps_ < most_steps && high_ - low_ > narrow; }

    /// ratio: faces at at() to those wanted.
    void learn(double ratio) {
      ++steps_;
      (ratio > 1.0 ? low_ : high_) = at_;
      const double value = std::log(std::max(ratio, 1e-9));
      if (steps_ > 1 && at_ != last_at_)
        power_ = std::clamp((last_value_ - value) / (at_ - last_at_), 0.5, 4.0);
      last_at_ = at_, last_value_ = value;
      at_ += value / power_;
      if (!(at_ > low_ && at_ < high_) || steps_ > most_secants) at_ = 0.5 * (low_ + high_);
    }

   private:
    static constexpr int most_steps = 24, most_secants = 8;
    static constexpr double narrow = 1e-3;  // by which the numbers around a jump scatter anyway

    double low_, high_, at_;
    double power_ = 2.0;  // faces go with the area of a cell
    double last_at_ = 0.0, last_value_ = 0.0;
    int steps_ = 0;
  };

  static double faces_of(const Clusters& clusters) {
    return static_cast<double>(clusters.faces.size());
  }
  /// No face at all is no result.
  double miss(double faces) const { return faces > 0.0 ? std::abs(faces - target_) : none; }
  double least_miss() const { return best_ ? miss(faces_of(*best_)) : none; }
  bool is_good() const { return least_miss() <= good * target_; }

  /// Whether it seems that its clusters would be better.
  bool promises(double at) { return miss(share_ * crossing_at(at)) < least_miss(); }

  /// Keeps the clusters if they are the best so far.
  void try_at(double at) {
    Clusters clusters = cluster_at_(diameter_at(at));
    const double faces = faces_of(clusters);
    if (faces > 0.0) share_ = faces / static_cast<double>(clusters.crossing);
    if (miss(faces) < least_miss()) best_ = std::move(clusters);
  }

  /// Where the counted faces, times the share, come nearest to the target, of what is tried.
  double nearest_to(double start) {
    Secant steps(least_, largest_, start);
    double nearest = start, least = none;
    while (steps.goes_on() && least > close * target_) {
      const double faces = share_ * crossing_at(steps.at());
      if (miss(faces) < least) least = miss(faces), nearest = steps.at();
      steps.learn(faces / target_);
    }
    return nearest;
  }

  double diameter_at(double at) const { return std::exp(std::clamp(at, least_, largest_)); }

  /// The faces between three cells.
  double crossing_at(double at) {
    const CellGrid grid(mesh_.half_size, diameter_at(at));
    parallel_.for_each(static_cast<int>(keys_.size()), [&](int v) {
      if (mesh_.role[v] != VertexRole::Unused) keys_[v] = cell_key(mesh_, grid, v);
    });
    std::atomic<int> count{0};
    parallel_.for_ranges(static_cast<int>(mesh_.faces.size()), [&](int begin, int end, int) {
      int crossing = 0;
      for (int f = begin; f < end; ++f)
        if (const Face& face = mesh_.faces[f]; FlatMesh::is_face(face))
          crossing += is_between_three(keys_[face[0]], keys_[face[1]], keys_[face[2]]);
      count += crossing;
    });
    return count;
  }

  static bool is_between_three(CellKey a, CellKey b, CellKey c) {
    return a != b && b != c && c != a;
  }

  /// Where the faces of a sample between three cells are as many as wanted.
  double estimated() const {
    const std::vector<Face> sample = sampled();
    const double wanted = target_ * static_cast<double>(sample.size()) / mesh_.face_count;
    Secant steps(least_, largest_, 0.5 * (least_ + largest_));
    for (double ratio = 0.0; steps.goes_on() && std::abs(ratio - 1.0) > near; steps.learn(ratio))
      ratio = crossing_of(sample, diameter_at(steps.at())) / wanted;
    return steps.at();
  }

  std::vector<Face> sampled() const {
    const int count = static_cast<int>(mesh_.faces.size()), step = count / most_samples + 1;
    std::vector<Face> sample;
    for (int f = 0; f < count; f += step)
      if (FlatMesh::is_face(mesh_.faces[f])) sample.push_back(mesh_.faces[f]);
    return sample;
  }

  int crossing_of(const std::vector<Face>& sample, double diameter) const {
    const CellGrid grid(mesh_.half_size, diameter);
    const auto key = [&](int v) { return cell_key(mesh_, grid, v); };
    return static_cast<int>(std::count_if(sample.begin(), sample.end(), [&](const Face& face) {
      return is_between_three(key(face[0]), key(face[1]), key(face[2]));
    }));
  }

  const FlatMesh& mesh_;
  const double target_;
  const Parallel& parallel_;
  const ClusterAt cluster_at_;
  const double least_, largest_;  // logarithms of the diameter
  Array<CellKey> keys_;           // by vertex
  double share_ = 1.0;            // of the faces between three cells, that is left
  std::optional<Clusters> best_;
};

}  // namespace curvdecim::detail
