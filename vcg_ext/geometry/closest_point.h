// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

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
/// without area.
inline Barycentric closest_point(const Triangle& t, const Vector3& p) {
  const Vector3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double scale = normal.squaredNorm();
  if (scale > 0.0) {
    const double w1 = (p - t[0]).cross(t[2] - t[0]).dot(normal) / scale;
    const double w2 = (t[1] - t[0]).cross(p - t[0]).dot(normal) / scale;
    if (w1 >= 0.0 && w2 >= 0.0 && w1 + w2 <= 1.0) return {1.0 - w1 - w2, w1, w2};
  }
  Barycentric best = closest_on_edge(t, 0, p);
  for (int i = 1; i < 3; ++i) {
    const Barycentric w = closest_on_edge(t, i, p);
    if ((at(t, w) - p).squaredNorm() < (at(t, best) - p).squaredNorm()) best = w;
  }
  return best;
}

}  // namespace curvdecim
