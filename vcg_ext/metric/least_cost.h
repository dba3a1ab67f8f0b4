// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/quadric.h"

namespace curvdecim::detail {

/// Two numbers that are computed with side by side.
using Pair = double __attribute__((vector_size(16)));

inline Pair pair(double first, double second) { return Pair{first, second}; }
inline Pair least(Pair a, Pair b) { return b < a ? b : a; }

/// Two vertices with their quadrics about them.
struct VertexPair {
  Pair x, y, z;                 // position
  Pair xx, xy, xz, yy, yz, zz;  // matrix
  Pair bx, by, bz, c;

  VertexPair(const Vector3& at_0, const Quadric& q_0, const Vector3& at_1, const Quadric& q_1)
      : x(pair(at_0.x(), at_1.x())),
        y(pair(at_0.y(), at_1.y())),
        z(pair(at_0.z(), at_1.z())),
        xx(pair(q_0.a.xx, q_1.a.xx)),
        xy(pair(q_0.a.xy, q_1.a.xy)),
        xz(pair(q_0.a.xz, q_1.a.xz)),
        yy(pair(q_0.a.yy, q_1.a.yy)),
        yz(pair(q_0.a.yz, q_1.a.yz)),
        zz(pair(q_0.a.zz, q_1.a.zz)),
        bx(pair(q_0.b.x(), q_1.b.x())),
        by(pair(q_0.b.y(), q_1.b.y())),
        bz(pair(q_0.b.z(), q_1.b.z())),
        c(pair(q_0.c, q_1.c)) {}
};

/// What is the same for both edges of a pair.
struct CostScale {
  double pull;      // to the trace
  double rounding;  // squared, to the trace and the edge's length
};

/// Values of the two sums of quadrics at their minima, as optimal_minimum has them before it looks
/// at the volume. The names are those of QuadricOfEdge; l and i are of Factorization3.
inline Pair least_costs(const VertexPair& p, const VertexPair& q, const CostScale& scale) {
  const Pair hx = 0.5 * (q.x - p.x), hy = 0.5 * (q.y - p.y), hz = 0.5 * (q.z - p.z);
  const Pair px = p.xx * hx + p.xy * hy + p.xz * hz, qx = q.xx * hx + q.xy * hy + q.xz * hz;
  const Pair py = p.xy * hx + p.yy * hy + p.yz * hz, qy = q.xy * hx + q.yy * hy + q.yz * hz;
  const Pair pz = p.xz * hx + p.yz * hy + p.zz * hz, qz = q.xz * hx + q.yz * hy + q.zz * hz;
  const Pair along = hx * (px + qx) + hy * (py + qy) + hz * (pz + qz);
  const Pair bx = p.bx + q.bx + (px - qx), by = p.by + q.by + (py - qy),
             bz = p.bz + q.bz + (pz - qz);
  const Pair c =
      p.c + q.c + along + 2.0 * ((p.bx - q.bx) * hx + (p.by - q.by) * hy + (p.bz - q.bz) * hz);
  const Pair trace = p.xx + q.xx + p.yy + q.yy + p.zz + q.zz, pull = scale.pull * trace;
  const Pair xy = p.xy + q.xy, xz = p.xz + q.xz, yz = p.yz + q.yz;
  const Pair i0 = 1.0 / (p.xx + q.xx + pull), l10 = xy * i0, l20 = xz * i0;
  const Pair i1 = 1.0 / (p.yy + q.yy + pull - l10 * xy), u21 = yz - l20 * xy, l21 = u21 * i1;
  const Pair i2 = 1.0 / (p.zz + q.zz + pull - l20 * xz - l21 * u21);
  const Pair y1 = by - l10 * bx, dz = (bz - l20 * bx - l21 * y1) * i2, dy = y1 * i1 - l21 * dz;
  const Pair dx = bx * i0 - l10 * dy - l20 * dz;  // minus the minimum's place
  const Pair inside = c - (bx * dx + by * dy + bz * dz) - pull * (dx * dx + dy * dy + dz * dz);
  const Pair even = along + c, odd = 2.0 * (bx * hx + by * hy + bz * hz);
  const Pair value = least(least(trace > 0.0 ? inside : c, even - odd), even + odd);
  const Pair nothing = scale.rounding * trace * (hx * hx + hy * hy + hz * hz);
  return value <= nothing ? Pair{} : value;
}

}  // namespace curvdecim::detail
