// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim::detail {

using Barycentric = std::array<double, 3>;

inline Vector3 at(const Triangle& t, const Barycentric& w) {
  const auto mix = [&](int k) { return w[0] * t[0][k] + w[1] * t[1][k] + w[2] * t[2][k]; };
  return {mix(0), mix(1), mix(2)};
}

/// Barycentric coordinates of the point of edge i, i+1 nearest to p.
inline Barycentric closest_on_edge(const Triangle& t, int i, const Vector3& p) {
  const int j = (i + 1) % 3;
  const Vector3 edge = t[j] - t[i];
  const double length2 = edge.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp(edge.dot(p - t[i]) / length2, 0.0, 1.0) : 0.0;
  Barycentric w{};
  w[i] = 1.0 - s;
  w[j] = s;
  return w;
}

/// Barycentric coordinates of the point of the triangle nearest to p; any triangle, also one
/// without area. From outside, the nearest point lies on an edge that p is beyond. A coordinate is
/// 0 exactly where the point is on the edge across from the corner.
///
/// normal: twice the area_vector.
inline Barycentric closest_point(const Triangle& t, const Vector3& normal, const Vector3& p) {
  const Vector3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const double scale = normal.squaredNorm();
  const double b = ap.cross(ac).dot(normal), c = ab.cross(ap).dot(normal), a = scale - b - c;
  const bool has_area = scale > 0.0;
  if (has_area && a >= 0.0 && b >= 0.0 && c >= 0.0) return {a / scale, b / scale, c / scale};
  const Barycentric inside = {a, b, c};
  Barycentric best{};
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (has_area && inside[(i + 2) % 3] >= 0.0) continue;
    const Barycentric w = closest_on_edge(t, i, p);
    const double distance2 = (at(t, w) - p).squaredNorm();
    if (distance2 < least) best = w, least = distance2;
  }
  return best;
}

inline Barycentric closest_point(const Triangle& t, const Vector3& p) {
  return closest_point(t, (t[1] - t[0]).cross(t[2] - t[0]), p);
}

/// A point of a face.
struct FacePoint {
  int face = -1;  // -1: there is none
  Barycentric weight{};

  /// The blend of what a face's corners have in a member, each read only where it counts: it may
  /// not be a number.
  template <class Corners, class Member>
  double blended(const Corners& corners, Member member) const {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
      if (weight[i] != 0.0) sum += weight[i] * corners[i].*member;
    return sum;
  }
};

/// The squared distance between p and a triangle.
inline double squared_distance(const Triangle& t, const Vector3& p) {
  return (at(t, closest_point(t, p)) - p).squaredNorm();
}

/// The point of some faces nearest to x; of equals, that of the first face. Mesh: triangle(f).
template <class Faces, class Mesh>
FacePoint nearest_point(const Faces& faces, const Mesh& mesh, const Vector3& x) {
  FacePoint nearest;
  double least = std::numeric_limits<double>::infinity();
  for (int f : faces) {
    const Triangle triangle = mesh.triangle(f);
    const Barycentric weight = closest_point(triangle, x);
    const double distance2 = (at(triangle, weight) - x).squaredNorm();
    if (distance2 < least) least = distance2, nearest = {f, weight};
  }
  return nearest;
}

}  // namespace curvdecim::detail
