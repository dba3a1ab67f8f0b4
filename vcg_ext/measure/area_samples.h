// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "vcg_ext/geometry/mixed.h"
#include "vcg_ext/measure/measured_surface.h"

namespace curvdecim::detail {

/// Samples of a surface, one in each of as many equal shares of its area. Where a sample lies
/// follows from its number alone: in its share by a hash, so that no pattern of the faces meets one
/// of the samples; in its face by a sequence of low discrepancy, so that those of one face spread.
class AreaSamples {
 public:
  AreaSamples(const MeasuredSurface& surface, int count)
      : count_(count), area_up_to_(surface.face_count()) {
    double area = 0.0;
    for (int i = 0; i < surface.face_count(); ++i) area_up_to_[i] = area += surface.plane(i).area;
  }

  int count() const { return count_; }

  /// The area that a sample stands for, in the box of diagonal 1.
  double share() const { return area_up_to_.back() / count_; }

  /// use(sample, face, weight) for all samples, on all cores.
  template <class Use>
  void for_each(const Parallel& parallel, Use use) const {
    parallel.for_each(
        runs(), [&](int run) { for_run(run, use); }, Parallel::heavy);
  }

  /// Runs of samples that are neighbours, so that a thread can take each as a whole.
  int runs() const { return count_ / run_length + (count_ % run_length != 0); }

  /// use(sample, face, weight) for those of a run.
  template <class Use>
  void for_run(int run, Use use) const {
    const int begin = run * run_length, end = begin + std::min(run_length, count_ - begin);
    int face = face_at(begin);
    for (int i = begin; i < end; ++i) {
      while (area_up_to_[face] <= area_before(i) && face + 1 < face_count()) ++face;
      use(i, face, weight(i));
    }
  }

 private:
  static constexpr int run_length = 1024;

  int face_count() const { return static_cast<int>(area_up_to_.size()); }

  int face_at(int sample) const {
    const auto face = std::upper_bound(area_up_to_.begin(), area_up_to_.end(), area_before(sample));
    return std::min(static_cast<int>(face - area_up_to_.begin()), face_count() - 1);
  }

  double area_before(int sample) const { return (sample + scattered(sample)) * share(); }

  /// 0..1
  static double scattered(int sample) {
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;  // else 0 would stay 0
    const std::uint64_t bits = mixed((static_cast<std::uint64_t>(sample) + 1) * golden);
    return std::ldexp(static_cast<double>(bits >> 11), -53);
  }

  /// Uniform in a triangle: the additive sequence of the plastic number, whose upper half is folded
  /// over.
  static Barycentric weight(int sample) {
    constexpr double plastic = 1.32471795724474602596;
    constexpr double step_u = 1.0 / plastic, step_v = step_u / plastic;
    const auto fraction = [](double x) { return x - std::floor(x); };
    double u = fraction(0.5 + sample * step_u), v = fraction(0.5 + sample * step_v);
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    return {1.0 - u - v, u, v};
  }

  const int count_;
  std::vector<double> area_up_to_;  // by face: of all up to it
};

}  // namespace curvdecim::detail
