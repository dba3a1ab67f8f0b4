// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "vcg_ext/guard/error_bound.h"
#include "vcg_ext/guard/face_guard.h"
#include "vcg_ext/guard/link_condition.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/report.h"

namespace curvdecim::detail {

/// Whether a collapse may be done.
struct GuardAnswer {
  std::optional<Rejection> refusal;  ///< nullopt: it may
  double error_bound = 0.0;          ///< of the faces around, were it done; 0 without a bound
};

/// All that may refuse a collapse once its kinds allow it: the cheap guards first.
class CollapseGuards {
 public:
  CollapseGuards(const WorkingMesh& mesh, const CollapseLimits& limits)
      : mesh_(mesh),
        link_condition_(limits.keeps_topology || limits.max_error > 0.0),
        face_guard_(mesh, limits.faces),
        bound_(mesh, limits.max_error) {}

  /// May the edge collapse to x? If so, `after` has the planes that the star would have.
  GuardAnswer ask(const EdgeNeighborhood& around, const Vector3& x,
                  std::vector<FacePlane>& after) const {
    if (link_condition_ && !satisfies_link_condition(mesh_, around))
      return {Rejection::LinkCondition};
    after.clear();
    for (int f : around.star()) {
      const Triangle moved = triangle_after(mesh_, f, around.edge(), x);
      after.push_back(face_plane(moved));
      if (const auto reason = face_guard_.refusal(f, moved, after.back())) return {reason};
    }
    if (!bound_.active()) return {};
    const double bound = bound_.after(mesh_, around, x);
    if (!bound_.allows(bound)) return {Rejection::ErrorBound};
    return {std::nullopt, bound};
  }

  /// To be told of every collapse that is done, with the bound of the answer.
  void accept(const EdgeNeighborhood& around, double error_bound) {
    if (bound_.active()) bound_.set(around, error_bound);
  }

  void renumber(const Renumbering& numbers) {
    face_guard_.renumber(numbers);
    bound_.renumber(numbers);
  }

 private:
  const WorkingMesh& mesh_;
  const bool link_condition_;  // also for the bound: without it a part may vanish
  FaceGuard face_guard_;
  ErrorBound bound_;
};

}  // namespace curvdecim::detail
