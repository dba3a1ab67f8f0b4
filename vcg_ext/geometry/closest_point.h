// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim {

using Barycentric = std::array<double, 3>;

inline Vector3 at(const Triangle& t, const Barycentric& w) {
  return w[0] * t[0] + w[1] * t[1] + w[2] * t[2];
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
/// without area. From outside, the nearest point lies on an edge that p is beyond.
inline Barycentric closest_point(const Triangle& t, const Vector3& p) {
  const Vector3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double scale = normal.squaredNorm();
  Barycentric inside = {-1.0, -1.0, -1.0};
  if (scale > 0.0) {
    inside[1] = (p - t[0]).cross(t[2] - t[0]).dot(normal) / scale;
    inside[2] = (t[1] - t[0]).cross(p - t[0]).dot(normal) / scale;
    inside[0] = 1.0 - inside[1] - inside[2];
    if (inside[0] >= 0.0 && inside[1] >= 0.0 && inside[2] >= 0.0) return inside;
  }
  Barycentric best{};
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (inside[(i + 2) % 3] >= 0.0) continue;
    const Barycentric w = closest_on_edge(t, i, p);
    const double distance2 = (at(t, w) - p).squaredNorm();
    if (distance2 < least) best = w, least = distance2;
  }
  return best;
}

}  // namespace curvdecim
