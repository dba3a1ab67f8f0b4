// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "vcg_ext/geometry/blend.h"
#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/mesh/triangle_connectivity.h"

namespace curvdecim::detail {

/// What `keep` carries becomes the weighted sum of what three others do. They are wedges, or
/// vertices by the numbers that they had at the start.
struct BlendStep {
  static constexpr int none = -1;

  int keep = none;  ///< none: nothing changes
  Face from{};
  std::array<float, 3> weight{};  // barycentric: one record a collapse, so that it has to be small

  static BlendStep at(int keep, const Face& from, const Barycentric& w) {
    return {keep, from, {float(w[0]), float(w[1]), float(w[2])}};
  }
};

inline BlendStep step_on_edge(int keep, int gone, double t) {
  return BlendStep::at(keep, {keep, gone, gone}, {1.0 - t, t, 0.0});
}

/// What a step's `keep` becomes; otherwise: where none of the values counts.
template <class Value>
Value blended(const BlendStep& step, const std::vector<Value>& from, const Value& otherwise) {
  Blend<Value> blend(otherwise);
  for (int i = 0; i < 3; ++i) blend.add(step.weight[i], from[step.from[i]]);
  return blend.mean();
}

/// A step's `keep` takes the blend of `from`, which may be the same values.
template <class Value>
void take(const BlendStep& step, const std::vector<Value>& from, std::vector<Value>& values) {
  values[step.keep] = blended(step, from, values[step.keep]);
}

/// Finds the nearest point to x on some faces.
class NearestStep {
 public:
  /// otherwise: the step where there is no face.
  NearestStep(const Vector3& x, const BlendStep& otherwise) : x_(x), step_(otherwise) {}

  /// corners: what the face's corners are called; normal: of length 1, or zero.
  void look_at(const Triangle& triangle, const Vector3& normal, const Face& corners) {
    const double height = normal.dot(x_ - triangle[0]);
    if (height * height >= least2_) return;  // its plane is further away already
    const Barycentric weight = closest_point(triangle, x_);
    const double distance2 = (at(triangle, weight) - x_).squaredNorm();
    if (distance2 < least2_)
      least2_ = distance2, step_ = BlendStep::at(step_.keep, corners, weight);
  }

  const BlendStep& step() const { return step_; }

 private:
  const Vector3 x_;
  double least2_ = std::numeric_limits<double>::infinity();
  BlendStep step_;
};

}  // namespace curvdecim::detail
