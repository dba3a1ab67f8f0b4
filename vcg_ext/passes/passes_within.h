// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "vcg_ext/attributes/attribute_blend.h"
#include "vcg_ext/guard/surface_bound.h"
#include "vcg_ext/passes/pass_schedule.h"

namespace curvdecim::detail {

/// Passes as long as samples stay well within a bound; they know none themselves. Then the bound
/// begins with the last surface that is within it everywhere; the first one, the input, is.
template <class MetricType>
void run_within(SurfaceBound& bound, PassSchedule<MetricType>& passes, PassSurface& surface,
                BlendRecord& record, const Parallel& parallel) {
  constexpr double share = 0.5;  // of the bound: a pass more, and there is room left still
  struct Level {
    PassSurface surface;
    BlendSteps steps;
  };
  std::vector<Level> finer;
  do finer.push_back({surface, record.first_steps()});
  while (passes.step(record) &&
         bound.holds_in_samples(surface, surface.face_count(), share, parallel));
  while (!bound.begin(surface, surface.face_count(), parallel) && !finer.empty()) {
    surface = std::move(finer.back().surface), record.first_steps() = std::move(finer.back().steps);
    finer.pop_back();
  }
}

}  // namespace curvdecim::detail
