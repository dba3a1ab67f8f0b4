// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/guard/limits.h"
#include "vcg_ext/mesh/tally.h"
#include "vcg_ext/parallel/timetable.h"
#include "vcg_ext/params.h"

namespace curvdecim::detail {

/// Everything that a run of vertex removals needs to know, lengths in the box of diagonal 1. It is
/// made once, from the parameters (run/plan_removal.h), and never changes.
struct RemovalPlan {
  StopCriterion stop;
  FaceLimits faces;
  RemovalCriterion criterion = RemovalCriterion::Heap;
  double max_sum = 0.0;    ///< of distances at a vertex; 0: no bound
  double max_error = 0.0;  ///< distance to the input; 0: no bound
  bool max_error_one_sided = false;
  double aspect_ratio_min = 0.0;  ///< of the lines that split a loop
  double feature_angle = 60.0;    ///< degrees
  bool preserve_features = false;
  bool preserve_boundary = true;
  double boundary_weight = 1.0;  ///< factor on distances to boundary and feature lines
  Timetable times;
};

}  // namespace curvdecim::detail
