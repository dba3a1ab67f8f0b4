// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/params.h"

namespace curvdecim::detail {

/// What becomes of sheets that touch: closed parts with a vertex or an edge in common.
enum class Sheets { StayTogether, AreSeparated };

/// How the host's mesh is read for a run step by step.
struct ReadingPlan {
  bool selected_only = false;
  bool joins_borders = false;  // that lie on each other
  Sheets sheets = Sheets::StayTogether;
  bool quality_weight = false;
  KeepBordersOf keep_borders_of = KeepBordersOf::Nothing;
};

/// The topology that is preserved is that of the whole: then sheets stay together.
inline ReadingPlan plan_reading(const DecimationParams& params) {
  return {params.selected_only, params.join_borders,
          params.preserve_topology ? Sheets::StayTogether : Sheets::AreSeparated,
          params.quality_weight, params.keep_borders_of};
}

/// Sheets that touch would be the first to join again where pairs may.
inline ReadingPlan plan_reading(const EdgeCollapseParams& params) {
  ReadingPlan plan = plan_reading(static_cast<const DecimationParams&>(params));
  if (params.pair_distance > 0.0) plan.sheets = Sheets::StayTogether;
  return plan;
}

/// Topology is kept always.
inline ReadingPlan plan_reading(const VertexRemovalParams& params) {
  ReadingPlan plan = plan_reading(static_cast<const DecimationParams&>(params));
  plan.sheets = Sheets::StayTogether;
  return plan;
}

}  // namespace curvdecim::detail
