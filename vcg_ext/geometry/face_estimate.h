// SPDX-License-Identifier: GPL-3.0-or-later
// What a face says about a point beside it: what would be carried there, were the face continued.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/geometry/triangle.h"

namespace curvdecim::detail {

/// What the corners of a face carry, in their order.
template <class Value>
using AtCorners = std::array<Value, 3>;

template <class Value>
Value interpolated(const AtCorners<Value>& corners, const Barycentric& at) {
  return at[0] * corners[0] + at[1] * corners[1] + at[2] * corners[2];
}

/// A point in the coordinates of a face that is continued over its plane, from its first corner in
/// edges to the second and the third.
struct PlanePoint {
  double b = 0.0, c = 0.0;
  double area = 0.0;  // of the face; 0: it has no plane
};

inline PlanePoint plane_point(const Triangle& face, const Vector3& x) {
  constexpr double furthest = 3.0;  // edges that a face is continued: slivers know little
  const Vector3 ab = face[1] - face[0], ac = face[2] - face[0], ax = x - face[0];
  const Vector3 normal = ab.cross(ac);
  const double scale = normal.squaredNorm();
  if (!(scale > 0.0)) return {};
  return {std::clamp(ax.cross(ac).dot(normal) / scale, -furthest, furthest),
          std::clamp(ab.cross(ax).dot(normal) / scale, -furthest, furthest),
          0.5 * std::sqrt(scale)};
}

/// Squared: differences that are the rounding of what is carried. Texture coordinates have seven
/// digits in files.
inline double rounding2_of(const Vector2& texture) {
  constexpr double rounding = 1e-6;
  return rounding * rounding * texture.squaredNorm();
}

/// Colours from 0 to 1 have 256 steps a channel.
inline double rounding2_of(const Vector3& color) {
  constexpr double step = 1.0 / 255.0;
  return static_cast<double>(color.size()) * step * step;
}

/// What a face says is carried at a point, and how much that counts.
template <class Value>
struct FaceEstimate {
  Value there = Value::Zero();
  double area = 0.0;  // of the face; 0: it says nothing

  /// Area times the squared distance to what is there instead @cite hoppe1999. What is affine costs
  /// nothing.
  double deviation(const Value& is) const {
    const double distance2 = (is - there).squaredNorm();
    return distance2 <= rounding2_of(is) ? 0.0 : area * distance2;
  }
};

template <class Value>
FaceEstimate<Value> face_estimate(const PlanePoint& at, const AtCorners<Value>& carried) {
  const Value there =
      carried[0] + at.b * (carried[1] - carried[0]) + at.c * (carried[2] - carried[0]);
  if (!there.allFinite()) return {};
  return {there, at.area};
}

/// The value that deviates least from some estimates: their mean by area, within the range of what
/// the faces carry.
template <class Value>
class EstimateFit {
 public:
  /// carried: by the face of the estimate.
  void add(const FaceEstimate<Value>& estimate, const AtCorners<Value>& carried) {
    if (estimate.area == 0.0) return;
    if (area_ == 0.0) low_ = high_ = carried[0];
    for (const Value& each : carried) low_ = low_.cwiseMin(each), high_ = high_.cwiseMax(each);
    sum_ += estimate.area * estimate.there, area_ += estimate.area;
  }

  /// otherwise: where none says anything.
  Value value(const Value& otherwise) const {
    return area_ > 0.0 ? Value((sum_ / area_).cwiseMax(low_).cwiseMin(high_)) : otherwise;
  }

 private:
  Value sum_ = Value::Zero(), low_ = Value::Zero(), high_ = Value::Zero();
  double area_ = 0.0;
};

/// The integral over a face of the squared gradient of what it carries, 0 for one without area.
template <class Value>
double squared_gradient(const Triangle& face, const AtCorners<Value>& carried) {
  const Vector3 ab = face[1] - face[0], ac = face[2] - face[0];
  const Value to_b = carried[1] - carried[0], to_c = carried[2] - carried[0];
  const double area = ab.cross(ac).norm();  // twice
  if (!(area > 0.0)) return 0.0;
  const double sum = ac.squaredNorm() * to_b.squaredNorm() - 2.0 * ab.dot(ac) * to_b.dot(to_c) +
                     ab.squaredNorm() * to_c.squaredNorm();
  return std::isfinite(sum) ? std::max(0.0, 0.5 * sum / area) : 0.0;
}

}  // namespace curvdecim::detail
