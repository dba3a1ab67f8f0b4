// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// Whether a collapse may be done.
struct GuardAnswer {
  std::optional<Rejection> refusal;  ///< nullopt: it may
  double error_bound = 0.0;          ///< of the faces around, were it done; 0 without MaxError
};

/// All that may refuse a collapse once its kinds allow it: the cheap guards first.
class CollapseGuards {
 public:
  CollapseGuards(const WorkingMesh& mesh, const DecimationParams& params)
      : mesh_(mesh),
        link_condition_(params.preserve_topology || params.max_error > 0.0),
        cos_normal_(params.preserve_normal ? least_cosine(params.normal_angle) : -1.0),
        cos_input_normal_(params.preserve_normal ? least_cosine(from_input * params.normal_angle)
                                                 : -1.0),
        bound_(mesh, params.max_error) {
    input_normal_.reserve(mesh.plane.size());
    for (const FacePlane& plane : mesh.plane) input_normal_.push_back(RoughNormal(plane.normal));
  }

  /// May the edge collapse to x? If so, `after` has the planes that the star would have.
  GuardAnswer ask(const EdgeNeighborhood& around, const Vector3& x,
                  std::vector<FacePlane>& after) const {
    if (link_condition_ && !satisfies_link_condition(mesh_, around))
      return {Rejection::LinkCondition};
    after.clear();
    for (int f : around.star()) {
      const Triangle moved = triangle_after(mesh_, f, around.edge(), x);
      after.push_back(face_plane(moved));
      if (const auto reason = refusal_of_face(f, moved, after.back())) return {reason};
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
    numbers.faces(input_normal_);
    bound_.renumber(numbers);
  }

 private:
  static constexpr double least_shape_quality = 0.01;  // a needle of 1 : 100
  static constexpr double from_input = 2.0 / 3.0;      // of the angle: what a face may turn in all

  /// Turns are counted from the current normal and from the input's, so that many small ones cannot
  /// flip a face.
  std::optional<Rejection> refusal_of_face(int f, const Triangle& after,
                                           const FacePlane& plane_after) const {
    const FacePlane& plane = mesh_.plane[f];
    if (turns_too_far(plane.normal, plane_after, cos_normal_) ||
        turns_too_far(input_normal_[f].unpacked(), plane_after, cos_input_normal_))
      return Rejection::NormalFlip;
    if (spoils_shape(after, plane_after.area, least_shape_quality,
                     [&] { return shape_quality(mesh_.triangle(f), plane.area); }))
      return Rejection::TriangleShape;
    return std::nullopt;
  }

  const WorkingMesh& mesh_;
  const bool link_condition_;  // also for the bound: without it a part may vanish
  const double cos_normal_, cos_input_normal_;
  std::vector<RoughNormal> input_normal_;  // by face
  ErrorBound bound_;
};

}  // namespace curvdecim
