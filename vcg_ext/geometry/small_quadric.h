// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/quadric.h"

namespace curvdecim::detail {

/// A quadric about the vertex that carries it, in single precision: there b and c are small, and
/// their rounding is to their own size.
struct SmallQuadric {
  float xx = 0, yy = 0, zz = 0, c = 0, xy = 0, yz = 0, xz = 0, bx = 0, by = 0, bz = 0;

  SmallQuadric() = default;
  explicit SmallQuadric(const Quadric& q)
      : xx(float(q.a.xx)),
        yy(float(q.a.yy)),
        zz(float(q.a.zz)),
        c(float(q.c)),
        xy(float(q.a.xy)),
        yz(float(q.a.yz)),
        xz(float(q.a.xz)),
        bx(float(q.b.x())),
        by(float(q.b.y())),
        bz(float(q.b.z())) {}

  Quadric quadric() const { return {{xx, xy, xz, yy, yz, zz}, {bx, by, bz}, c}; }
  double trace() const { return double(xx) + yy + zz; }
};

}  // namespace curvdecim::detail
