// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "vcg_ext/report.h"

namespace curvdecim::detail {

/// Thrown where the caller asked to stop.
struct CancelRequest {};

/// Knows how far the work is, and asks the caller whether to go on.
class ProgressMeter {
 public:
  explicit ProgressMeter(Progress progress) : progress_(std::move(progress)) {}

  void begin(const char* stage) { stage_ = stage, set(0.0); }
  void set(double fraction) { percent_ = static_cast<int>(100.0 * fraction); }

  /// The work is done but for what cannot be stopped. Throws CancelRequest.
  void finish() { set(1.0), ask(); }

  /// Throws CancelRequest.
  void ask() const {
    if (progress_ && !progress_(percent_, stage_)) throw CancelRequest{};
  }

 private:
  Progress progress_;
  const char* stage_ = "Preparing";
  int percent_ = 0;
};

}  // namespace curvdecim::detail
