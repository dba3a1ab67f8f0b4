// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "vcg_ext/geometry/vector3.h"
#include "vcg_ext/parallel/radix_sort.h"

namespace curvdecim::detail {

/// The 21 lowest bits of x with two zeros before each.
inline std::uint64_t spread_bits(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Place on the Z-order curve of a point with coordinates from -0.5 to 0.5: what is near in space
/// is near on the curve.
inline std::uint64_t morton_code(const Vector3& p) {
  constexpr double cells = 2097151.0;  // 2^21 - 1 an axis
  const auto cell = [](double x) { return static_cast<std::uint64_t>((x + 0.5) * cells); };
  return spread_bits(cell(p.x())) | spread_bits(cell(p.y())) << 1 | spread_bits(cell(p.z())) << 2;
}

/// The numbers below count in the order of the curve, by their codes; value: the number.
/// point_of(i): its point.
template <class PointOf>
Array<Keyed> along_curve(int count, const Parallel& parallel, PointOf point_of) {
  constexpr int code_bits = 63;
  return sorted_by_key(count, code_bits, parallel, [&](int i) {
    return Keyed{morton_code(point_of(i)), i};
  });
}

}  // namespace curvdecim::detail
