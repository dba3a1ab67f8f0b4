// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "vcg_ext/geometry/floating_point.h"
#include "vcg_ext/geometry/vector3.h"

namespace curvdecim::detail {

/// Four numbers in single precision that are computed with side by side: as many as every processor
/// has had for long, so that the results are the same on all.
using Lanes = float __attribute__((vector_size(16)));
inline constexpr int lane_count = 4;

/// What comparing them gives: 0 where it does not hold.
using LaneMask = std::int32_t __attribute__((vector_size(16)));

inline Lanes load(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

inline Lanes root(Lanes x) {
  for (int i = 0; i < lane_count; ++i) x[i] = std::sqrt(x[i]);
  return x;
}

/// In this order.
inline float sum(Lanes x) { return (x[0] + x[2]) + (x[1] + x[3]); }

/// Three coordinates each.
struct VectorLanes {
  Lanes x, y, z;

  VectorLanes operator-(const VectorLanes& o) const { return {x - o.x, y - o.y, z - o.z}; }
  VectorLanes operator*(Lanes s) const { return {x * s, y * s, z * s}; }
  Lanes dot(const VectorLanes& o) const { return x * o.x + y * o.y + z * o.z; }
  Lanes squared() const { return dot(*this); }
  VectorLanes cross(const VectorLanes& o) const {
    return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x};
  }
};

/// The same vector in all lanes.
inline VectorLanes lanes_of(const Vector3& p) {
  const auto all = [](double x) { return Lanes{} + static_cast<float>(x); };
  return {all(p.x()), all(p.y()), all(p.z())};
}

}  // namespace curvdecim::detail
