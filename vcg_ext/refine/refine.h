// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <optional>
#include <utility>

#include "vcg_ext/attributes/carried.h"
#include "vcg_ext/refine/refinement.h"

namespace curvdecim::detail {

/// What has to be kept of the mesh before the collapses for refine() after them; nullopt: the plan
/// has no refinement.
inline std::optional<InputCopy> keep_input(const WorkingMesh& mesh, const CollapsePlan& plan,
                                           const Parallel& parallel) {
  if (plan.refine_sweeps == 0) return std::nullopt;
  return copy_input(mesh, plan.metric, parallel);
}

/// Gives what is left new numbers without gaps, so that what is gone needs no memory.
inline void pack(WorkingMesh& mesh, std::optional<WedgeTexture>& wedges) {
  const Renumbering without_gaps(mesh.connectivity);
  mesh.renumber(without_gaps);
  mesh = WorkingMesh(mesh);  // a copy has no room to spare
  if (wedges) wedges->renumber(without_gaps);
}

/// Moves vertices and flips edges of the decimated mesh, as often as the plan says, to bring it
/// closer to the input. Throws CancelRequest.
inline void refine(WorkingMesh& decimated, std::optional<InputCopy> input, const CollapsePlan& plan,
                   Carried& carried, const Parallel& parallel, ProgressMeter& progress) {
  if (!input) return;
  pack(decimated, carried.wedges);
  if (decimated.connectivity.face_count() == 0) return;  // may be without the link condition
  const InputSurface surface(std::move(*input));
  Refinement refinement(decimated, surface, plan, carried.wedges ? &*carried.wedges : nullptr,
                        parallel);
  refinement.run(plan.refine_sweeps, progress);
  carried.resampled = refinement.attributes();
  assert((decimated.connectivity.validate(), true));
}

}  // namespace curvdecim::detail
