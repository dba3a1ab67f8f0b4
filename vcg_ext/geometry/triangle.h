// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "vcg_ext/geometry/vector3.h"

namespace curvdecim::detail {

using Triangle = std::array<Vector3, 3>;

/// The one with these corners; position: by vertex.
template <class Positions>
Triangle triangle_of(const Positions& position, const std::array<int, 3>& corners) {
  return {position[corners[0]], position[corners[1]], position[corners[2]]};
}

/// Normal times area, by the right-hand rule.
inline Vector3 area_vector(const Vector3& a, const Vector3& b, const Vector3& c) {
  return 0.5 * (b - a).cross(c - a);
}

inline Vector3 area_vector(const Triangle& t) { return area_vector(t[0], t[1], t[2]); }

inline Vector3 center_of(const Triangle& t) { return (t[0] + t[1] + t[2]) / 3.0; }

/// Unit normal and area of a face; the normal of a face without area is zero.
struct FacePlane {
  Vector3 normal = Vector3::Zero();
  double area = 0.0;

  Vector3 area_vector() const { return area * normal; }
};

inline FacePlane face_plane(const Triangle& t) {
  const Vector3 v = area_vector(t);
  const double area = v.norm();
  return area > 0.0 ? FacePlane{v / area, area} : FacePlane{};
}

/// Angle at `apex` in radians, 0..pi; stable for needles and caps.
inline double corner_angle(const Vector3& apex, const Vector3& b, const Vector3& c) {
  const Vector3 u = b - apex, v = c - apex;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

inline double sum_of_squared_edges(const Triangle& t) {
  return (t[1] - t[0]).squaredNorm() + (t[2] - t[1]).squaredNorm() + (t[0] - t[2]).squaredNorm();
}

inline constexpr double four_root_three = 6.92820323027550917;

/// 4 sqrt(3) area / sum of squared edges: 1 for the equilateral triangle, 0 without area
/// @cite bhatia1990.
inline double shape_quality(const Triangle& t, double area) {
  const double edges = sum_of_squared_edges(t);
  return edges > 0.0 ? four_root_three * area / edges : 0.0;
}

/// True if the shape_quality is below `quality`, without a division.
inline bool is_worse_shaped(const Triangle& t, double area, double quality) {
  return four_root_three * area < quality * sum_of_squared_edges(t);
}

}  // namespace curvdecim::detail
