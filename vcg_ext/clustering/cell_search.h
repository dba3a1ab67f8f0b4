// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/clustering/clusters.h"

namespace curvdecim::detail {

/// Looks for the diameter of the cells at which a number of faces is left.
///
/// The number falls with the diameter nearly like a power, so that a secant through two logarithms
/// finds the target in a few steps; where it jumps, bisection goes on. First estimates from a
/// sample of the faces come near, then the clusters themselves are counted.
template <class ClusterAt>
class CellSearch {
 public:
  /// cluster_at(diameter): the Clusters.
  CellSearch(const FlatMesh& mesh, int target, ClusterAt cluster_at)
      : mesh_(mesh),
        target_(target),
        cluster_at_(std::move(cluster_at)),
        least_(std::log(CellGrid::least_diameter(mesh.half_size))),
        largest_(std::log(CellGrid::largest_diameter(mesh.half_size))) {
    const int count = static_cast<int>(mesh.faces.size()), step = count / most_samples + 1;
    for (int f = 0; f < count; f += step)
      if (FlatMesh::is_face(mesh.faces[f])) sample_.push_back(mesh.faces[f]);
  }

  /// The clusters whose number of faces is nearest to the target, of those tried; nullopt: all have
  /// none.
  std::optional<Clusters> run() {
    const double start = estimated();
    Secant steps(least_, largest_, start);
    while (!is_good() && steps.goes_on()) steps.learn(count(steps.at()) / target_);
    for (int i = 1; i <= most_steps_aside && !is_good(); ++i)
      for (int side : {-1, 1}) count(steps.at() + side * i * step_aside);
    return std::move(best_);
  }

 private:
  static constexpr int most_samples = 1 << 13;  // estimates then scatter by some per cent
  static constexpr double near = 0.03;          // so that they need not be nearer
  static constexpr double good = 0.02;          // miss, of the target

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

  bool is_good() const { return best_ && std::abs(faces_of(*best_) - target_) <= good * target_; }
  static double faces_of(const Clusters& clusters) {
    return static_cast<double>(clusters.faces.size());
  }

  /// The number of faces, which is kept if it is the best so far.
  double count(double at) {
    Clusters clusters = cluster_at_(std::exp(std::clamp(at, least_, largest_)));
    const double faces = faces_of(clusters);
    if (faces > 0 && (!best_ || std::abs(faces - target_) < std::abs(faces_of(*best_) - target_)))
      best_ = std::move(clusters);
    return faces;
  }

  /// Where the faces of the sample between three cells are as many as wanted.
  double estimated() const {
    const double wanted = static_cast<double>(target_) * sample_.size() / mesh_.face_count;
    Secant steps(least_, largest_, 0.5 * (least_ + largest_));
    for (double ratio = 0.0; steps.goes_on() && std::abs(ratio - 1.0) > near; steps.learn(ratio))
      ratio = faces_of_sample(std::exp(steps.at())) / wanted;
    return steps.at();
  }

  int faces_of_sample(double diameter) const {
    const CellGrid grid(mesh_.half_size, diameter);
    int count = 0;
    for (const Face& face : sample_) {
      const CellKey a = cell_key(mesh_, grid, face[0]), b = cell_key(mesh_, grid, face[1]),
                    c = cell_key(mesh_, grid, face[2]);
      count += a != b && b != c && c != a;
    }
    return count;
  }

  const FlatMesh& mesh_;
  const double target_;
  const ClusterAt cluster_at_;
  const double least_, largest_;  // logarithms of the diameter
  std::vector<Face> sample_;
  std::optional<Clusters> best_;
};

}  // namespace curvdecim::detail
