// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "vcg_ext/guard/limits.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/report.h"

namespace curvdecim::detail {

/// What a face may become. Turns are counted from the current normal and from the input's, so that
/// many small ones do not turn a face over.
class FaceGuard {
 public:
  FaceGuard(const WorkingMesh& mesh, const FaceLimits& limits)
      : mesh_(mesh),
        cos_normal_(least_cosine(limits, 1.0)),
        cos_input_normal_(least_cosine(limits, from_input)) {
    input_normal_.reserve(mesh.plane.size());
    for (const FacePlane& plane : mesh.plane) input_normal_.push_back(RoughNormal(plane.normal));
  }

  /// Where nothing is weighed against anything else: no turn too far, and no sliver out of a face
  /// that was none.
  std::optional<Rejection> refusal(int f, const Triangle& after,
                                   const FacePlane& plane_after) const {
    if (turns(f, plane_after)) return Rejection::NormalFlip;
    if (spoils_shape(after, plane_after.area, fair_quality,
                     [&] { return shape_quality(mesh_.triangle(f), mesh_.plane[f].area); }))
      return Rejection::TriangleShape;
    return std::nullopt;
  }

  /// What it costs that face f becomes `after`, in area times squared length; nullopt: it loses its
  /// height but for rounding, and so its normal, which it may not. A face that turns or becomes a
  /// sliver costs by its size, so that among fair faces none does, and where a place consists of
  /// slivers, whose normals mean little, they do not stand in the way
  /// (docs/decisions/prices-not-bans.md).
  std::optional<double> price(int f, const Triangle& after, const FacePlane& plane_after) const {
    double price = 0.0;  // per area
    if (turns(f, plane_after)) price += turn_price * sum_of_squared_edges(after);
    if (is_worse_shaped(after, plane_after.area, fair_quality)) {
      if (loses_height(f, after, plane_after.area)) return std::nullopt;
      price += lost_shape(f, after, plane_after.area) * sliver_price(f, after);
    }
    return price * plane_after.area;
  }

  /// To be told of every face that was made anew.
  void renew(int f) { input_normal_[f] = RoughNormal(mesh_.plane[f].normal); }

  void renumber(const Renumbering& numbers) { numbers.faces(input_normal_); }

 private:
  static constexpr double fair_quality = 0.01;     // a needle of 1 : 100
  static constexpr double from_input = 2.0 / 3.0;  // of the angle: what a face may turn in all
  // On the sum of the squared edges. A third or three times as much measures alike.
  static constexpr double turn_price = 0.1;
  static constexpr double shape_price = 0.0003;
  static constexpr double move_price = 3.0;  // on its square; a thirtieth or thirty times: alike

  bool loses_height(int f, const Triangle& after, double area_after) const {
    return !has_height(after, area_after) && has_height(mesh_.triangle(f), mesh_.plane[f].area);
  }

  static bool has_height(const Triangle& t, double area) {
    constexpr double rounding = 1e-9;  // in the box
    return area * area > rounding * rounding * sum_of_squared_edges(t);
  }

  bool turns(int f, const FacePlane& after) const {
    return turns_too_far(mesh_.plane[f].normal, after, cos_normal_) ||
           turns_too_far(input_normal_[f].unpacked(), after, cos_input_normal_);
  }

  /// A sliver as long as its part costs no more than its move: one that stays in the surface, as
  /// along a rod, is what the place consists of.
  double sliver_price(int f, const Triangle& after) const {
    const Vector3 &normal = mesh_.plane[f].normal, on_plane = mesh_.triangle(f)[0];
    double move = 0.0;
    for (const Vector3& corner : after)
      move = std::max(move, std::abs(normal.dot(corner - on_plane)));
    return std::min(shape_price * sum_of_squared_edges(after), move_price * move * move);
  }

  /// 0: as slender as before; 1: no height is left.
  double lost_shape(int f, const Triangle& after, double area_after) const {
    const double before =
        std::min(fair_quality, shape_quality(mesh_.triangle(f), mesh_.plane[f].area));
    const double now = shape_quality(after, area_after);
    return now < before ? 1.0 - now / before : 0.0;
  }

  const WorkingMesh& mesh_;
  const double cos_normal_, cos_input_normal_;
  std::vector<RoughNormal> input_normal_;  // by face
};

}  // namespace curvdecim::detail
