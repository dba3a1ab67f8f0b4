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

/// How many it takes for so many numbers.
constexpr int lane_groups(int count) { return (count + lane_count - 1) / lane_count; }

/// What comparing them gives, 0 where it does not hold, and four indices.
using LaneMask = std::int32_t __attribute__((vector_size(16)));

inline Lanes load(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

inline LaneMask load(const int* from) {
  LaneMask lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

inline Lanes root(Lanes x) {
  for (int i = 0; i < lane_count; ++i) x[i] = std::sqrt(x[i]);
  return x;
}

inline bool any(LaneMask mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }

/// Adds up, in this order.
inline float sum(Lanes x) { return (x[0] + x[2]) + (x[1] + x[3]); }

/// Adds up the first three.
inline float sum3(Lanes x) { return x[0] + x[1] + x[2]; }

/// Lanes of two vectors, those of the second counted from 4 on.
template <int I, int J, int K, int L>
Lanes mixed(Lanes a, Lanes b) {
#ifdef __clang__
  return __builtin_shufflevector(a, b, I, J, K, L);
#else
  return __builtin_shuffle(a, b, LaneMask{I, J, K, L});
#endif
}

/// A point in the lanes of one vector: x, y, z, and a number of its own.
inline Lanes row(const Vector3& p, float w) {
  return Lanes{static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()), w};
}

/// The coordinates one further.
inline Lanes yzx(Lanes p) { return mixed<1, 2, 0, 3>(p, p); }

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

/// Four rows turned into columns: `at` has the points, `w` the numbers of their own.
struct Columns {
  VectorLanes at;
  Lanes w;

  Columns(Lanes a, Lanes b, Lanes c, Lanes d) {
    const Lanes ab_xy = mixed<0, 4, 1, 5>(a, b), ab_zw = mixed<2, 6, 3, 7>(a, b);
    const Lanes cd_xy = mixed<0, 4, 1, 5>(c, d), cd_zw = mixed<2, 6, 3, 7>(c, d);
    at.x = mixed<0, 1, 4, 5>(ab_xy, cd_xy), at.y = mixed<2, 3, 6, 7>(ab_xy, cd_xy);
    at.z = mixed<0, 1, 4, 5>(ab_zw, cd_zw), w = mixed<2, 3, 6, 7>(ab_zw, cd_zw);
  }

  /// row_of(lane)
  template <class RowOf>
  static Columns of(RowOf row_of) {
    return {row_of(0), row_of(1), row_of(2), row_of(3)};
  }
};

}  // namespace curvdecim::detail
