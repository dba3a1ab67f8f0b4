// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/quadric.h"

namespace curvdecim::detail {

/// Two numbers that are computed with side by side.
using Pair = double __attribute__((vector_size(16)));

inline Pair pair(double first, double second) { return Pair{first, second}; }

/// Several vertices side by side, with their quadrics about them. L: a vector of numbers.
template <class L>
struct VertexLanes {
  L x, y, z;                 // position
  L xx, xy, xz, yy, yz, zz;  // matrix
  L bx, by, bz, c;
};

inline VertexLanes<Pair> vertex_pair(const Vector3& at_0, const Quadric& q_0, const Vector3& at_1,
                                     const Quadric& q_1) {
  return {pair(at_0.x(), at_1.x()),   pair(at_0.y(), at_1.y()),   pair(at_0.z(), at_1.z()),
          pair(q_0.a.xx, q_1.a.xx),   pair(q_0.a.xy, q_1.a.xy),   pair(q_0.a.xz, q_1.a.xz),
          pair(q_0.a.yy, q_1.a.yy),   pair(q_0.a.yz, q_1.a.yz),   pair(q_0.a.zz, q_1.a.zz),
          pair(q_0.b.x(), q_1.b.x()), pair(q_0.b.y(), q_1.b.y()), pair(q_0.b.z(), q_1.b.z()),
          pair(q_0.c, q_1.c)};
}

/// What is the same for all edges. S: the numbers of the lanes.
template <class S>
struct CostScale {
  S pull;      // to the trace
  S rounding;  // squared, to the trace and the edge's length
};

/// Values of the sums of quadrics at their minima, as optimal_minimum has them before it looks
/// at the volume. The names are those of QuadricOfEdge; l and i are of Factorization3.
template <class L, class S>
L least_costs(const VertexLanes<L>& p, const VertexLanes<L>& q, const CostScale<S>& scale) {
  const auto least = [](L a, L b) { return b < a ? b : a; };
  const L hx = S(0.5) * (q.x - p.x), hy = S(0.5) * (q.y - p.y), hz = S(0.5) * (q.z - p.z);
  const L px = p.xx * hx + p.xy * hy + p.xz * hz, qx = q.xx * hx + q.xy * hy + q.xz * hz;
  const L py = p.xy * hx + p.yy * hy + p.yz * hz, qy = q.xy * hx + q.yy * hy + q.yz * hz;
  const L pz = p.xz * hx + p.yz * hy + p.zz * hz, qz = q.xz * hx + q.yz * hy + q.zz * hz;
  const L along = hx * (px + qx) + hy * (py + qy) + hz * (pz + qz);
  const L bx = p.bx + q.bx + (px - qx), by = p.by + q.by + (py - qy), bz = p.bz + q.bz + (pz - qz);
  const L c =
      p.c + q.c + along + S(2) * ((p.bx - q.bx) * hx + (p.by - q.by) * hy + (p.bz - q.bz) * hz);
  const L trace = p.xx + q.xx + p.yy + q.yy + p.zz + q.zz, pull = scale.pull * trace;
  const L xy = p.xy + q.xy, xz = p.xz + q.xz, yz = p.yz + q.yz;
  const L i0 = S(1) / (p.xx + q.xx + pull), l10 = xy * i0, l20 = xz * i0;
  const L i1 = S(1) / (p.yy + q.yy + pull - l10 * xy), u21 = yz - l20 * xy, l21 = u21 * i1;
  const L i2 = S(1) / (p.zz + q.zz + pull - l20 * xz - l21 * u21);
  const L y1 = by - l10 * bx, dz = (bz - l20 * bx - l21 * y1) * i2, dy = y1 * i1 - l21 * dz;
  const L dx = bx * i0 - l10 * dy - l20 * dz;  // minus the minimum's place
  const L inside = c - (bx * dx + by * dy + bz * dz) - pull * (dx * dx + dy * dy + dz * dz);
  const L even = along + c, odd = S(2) * (bx * hx + by * hy + bz * hz);
  const L value = least(least(trace > 0.0 ? inside : c, even - odd), even + odd);
  const L nothing = scale.rounding * trace * (hx * hx + hy * hy + hz * hz);
  return value <= nothing ? L{} : value;
}

}  // namespace curvdecim::detail
