// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "vcg_ext/guard/error_bound.h"
#include "vcg_ext/guard/link_condition.h"
#include "vcg_ext/guard/normal_flip.h"
#include "vcg_ext/guard/triangle_after.h"
#include "vcg_ext/guard/triangle_shape.h"
#include "vcg_ext/params.h"
#include "vcg_ext/report.h"

namespace curvdecim {

/// All that may refuse a collapse once its kinds allow it: the cheap guards first.
class CollapseGuards {
 public:
  CollapseGuards(const WorkingMesh& mesh, const DecimationParams& params)
      : mesh_(mesh),
        link_condition_(params.preserve_topology || params.max_error > 0.0),
        cos_normal_(params.preserve_normal ? limit(params.normal_angle) : -1.0),
        cos_input_normal_(params.preserve_normal ? limit(from_input * params.normal_angle) : -1.0),
        bound_(mesh, params.max_error) {
    for (const FacePlane& plane : mesh.plane) input_normal_.push_back(plane.normal);
  }

  /// Why the edge may not collapse to x; nullopt: it may.
  std::optional<Rejection> refusal(const EdgeNeighborhood& around, const Vector3& x) {
    if (link_condition_ && !satisfies_link_condition(mesh_, around))
      return Rejection::LinkCondition;
    for (int f : around.star())
      if (const auto reason = refusal_of_face(f, triangle_after(mesh_, f, around.edge(), x)))
        return reason;
    if (bound_.active() && !bound_.allows(asked_bound_ = bound_.after(mesh_, around, x)))
      return Rejection::ErrorBound;
    return std::nullopt;
  }

  /// To be told that the collapse last asked about, and not refused, is done.
  void accept(const EdgeNeighborhood& around) {
    if (bound_.active()) bound_.set(around, asked_bound_);
  }

  /// The guaranteed bound, in the unit of the working mesh; 0 without one.
  double largest_error() const { return bound_.largest(); }

 private:
  static constexpr double least_shape_quality = 0.01;  // a needle of 1 : 100
  static constexpr double from_input = 2.0 / 3.0;      // of the angle: what a face may turn in all
  static constexpr double margin = 0.05;  // two faces on the very limit could lie back to back

  static double limit(double degrees) { return std::cos(degrees * (M_PI / 180.0)) + margin; }

  /// Turns are counted from the current normal and from the input's, so that many small ones cannot
  /// flip a face.
  std::optional<Rejection> refusal_of_face(int f, const Triangle& triangle) const {
    const FacePlane& before = mesh_.plane[f];
    const FacePlane after = face_plane(triangle);
    if (turns_too_far(before.normal, after, cos_normal_) ||
        turns_too_far(input_normal_[f], after, cos_input_normal_))
      return Rejection::NormalFlip;
    if (spoils_shape(mesh_.triangle(f), before.area, triangle, after.area, least_shape_quality))
      return Rejection::TriangleShape;
    return std::nullopt;
  }

  const WorkingMesh& mesh_;
  const bool link_condition_;  // also for the bound: without it a part may vanish
  const double cos_normal_, cos_input_normal_;
  std::vector<Vector3> input_normal_;  // by face
  ErrorBound bound_;
  double asked_bound_ = 0.0;  // of the collapse last asked about
};

}  // namespace curvdecim
