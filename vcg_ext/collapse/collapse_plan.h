// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "vcg_ext/guard/limits.h"
#include "vcg_ext/mesh/tally.h"
#include "vcg_ext/metric/metric_plan.h"
#include "vcg_ext/parallel/timetable.h"

namespace curvdecim::detail {

inline constexpr int no_passes = std::numeric_limits<int>::max();

/// In which order edges collapse (docs/decisions/rounds.md).
struct Schedule {
  int passes_goal = no_passes;  ///< faces of the working mesh at which passes end
  double round_share =
      0.0;  ///< share of the choices that may be candidates in a round; 0: no rounds
  bool eager =
      false;  ///< in strict order: a collapse brings the costs of all edges around up to date
};

/// What a metric's costs are.
enum class CostUnit { AreaTimesSquaredLength, SquaredLength, AreaTimesLength };

/// Everything that a run of collapses needs to know, lengths in the box of diagonal 1. It is made
/// once, from any filter's parameters (run/plan_collapse.h), and never changes.
struct CollapsePlan {
  StopCriterion stop;
  CollapseLimits limits;
  MetricPlan metric;
  Schedule schedule;
  CostUnit cost_unit = CostUnit::AreaTimesSquaredLength;
  double pair_distance = 0.0;    ///< unconnected vertices that are closer may merge; 0: none
  double rounding = 0.0;         ///< of a vertex that is written, in the mesh's unit
  int refine_sweeps = 0;         ///< after the collapses
  double boundary_weight = 1.0;  ///< against the surface, in the refinement
  Timetable times;
};

}  // namespace curvdecim::detail
