// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/parallel/progress_meter.h"

namespace curvdecim::detail {

/// How long the stages of a run take, in nanoseconds on two cores, as measured on scans of a
/// million faces. What counts is their proportion: by it they share the bar of the progress.
struct Timetable {
  double preparing = 0.0;  ///< reading the host's mesh, and what is measured on it
  double steps = 0.0;      ///< collapses, removals or the clustering
  double refining = 0.0;
  double writing = 0.0;  ///< to the host's mesh; nobody is asked any more

  void begin_preparing(ProgressMeter& progress) const {
    progress.begin("Preparing", preparing, steps + refining + writing);
  }
  void begin_steps(const char* stage, ProgressMeter& progress) const {
    progress.begin(stage, steps, refining + writing);
  }
  void begin_refining(ProgressMeter& progress) const {
    progress.begin("Refining", refining, writing);
  }
};

}  // namespace curvdecim::detail
