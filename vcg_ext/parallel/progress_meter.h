// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>

#include "vcg_ext/report.h"

namespace curvdecim::detail {

/// Thrown where the caller asked to stop.
struct CancelRequest {};

/// Knows how far a run is, on one bar from 0 to 100 that never goes back, and asks the caller
/// whether to go on. A stage of the run has a stretch of the bar; in a stage, loops can have
/// stretches of that, along which they move the bar by themselves (parallel.h).
class ProgressMeter {
 public:
  ProgressMeter() = default;
  explicit ProgressMeter(Progress progress) : progress_(std::move(progress)) {}

  /// A stage that takes `work` where `later` is still to come after it, in any unit of time.
  void begin(const char* stage, double work, double later) {
    stage_ = stage;
    loops_ = {};
    start_ = at_;
    length_ = (1.0 - at_) * work / std::max(work + later, least_work);
  }

  /// fraction: of the stage.
  void set(double fraction) {
    at_ = std::max(at_, start_ + length_ * std::clamp(fraction, 0.0, 1.0));
  }

  /// Throws CancelRequest.
  void ask() const {
    if (progress_ && !progress_(static_cast<int>(100.0 * at_), stage_)) throw CancelRequest{};
  }

  /// The caller is asked no more: what is its own is about to change, which cannot be stopped half
  /// way.
  void fall_silent() { progress_ = nullptr; }

  /// Loops in work() move the bar along a stretch of the stage, or of the stretch around it.
  template <class Work>
  void along(double from, double to, Work work) {
    const Stretch outer = loops_;
    loops_ = {outer.at(from), outer.at(to), true};
    work();
    set(loops_.to);
    loops_ = outer;
  }

  /// To be called by a loop. fraction: of it that is done. Throws CancelRequest.
  void in_loop(double fraction) {
    if (loops_.moves) set(loops_.at(fraction));
    ask();
  }

 private:
  struct Stretch {
    double from = 0.0, to = 1.0;  // of the stage
    bool moves = false;           // the bar

    double at(double fraction) const { return from + fraction * (to - from); }
  };

  static constexpr double least_work = 1e-9;  // a nanosecond: nothing is to be divided by 0

  Progress progress_;
  const char* stage_ = "Preparing";
  double at_ = 0.0;                    // of the bar, 0..1
  double start_ = 0.0, length_ = 0.0;  // the stage's stretch of it
  Stretch loops_;
};

}  // namespace curvdecim::detail
