// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "vcg_ext/guard/limits.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/report.h"

namespace curvdecim::detail {

/// Whether a face may become another triangle. Turns are counted from the current normal and from
/// the input's, so that many small ones cannot flip a face.
class FaceGuard {
 public:
  FaceGuard(const WorkingMesh& mesh, const FaceLimits& limits)
      : mesh_(mesh),
        cos_normal_(least_cosine(limits, 1.0)),
        cos_input_normal_(least_cosine(limits, from_input)) {
    input_normal_.reserve(mesh.plane.size());
    for (const FacePlane& plane : mesh.plane) input_normal_.push_back(RoughNormal(plane.normal));
  }

  std::optional<Rejection> refusal(int f, const Triangle& after,
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

  void renumber(const Renumbering& numbers) { numbers.faces(input_normal_); }

 private:
  static constexpr double least_shape_quality = 0.01;  // a needle of 1 : 100
  static constexpr double from_input = 2.0 / 3.0;      // of the angle: what a face may turn in all

  const WorkingMesh& mesh_;
  const double cos_normal_, cos_input_normal_;
  std::vector<RoughNormal> input_normal_;  // by face
};

}  // namespace curvdecim::detail
