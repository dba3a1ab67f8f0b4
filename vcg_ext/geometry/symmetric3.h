// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/vector3.h"

namespace curvdecim {

/// Symmetric 3x3 matrix.
struct Symmetric3 {
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;

  /// weight * n n^T
  static Symmetric3 outer(const Vector3& n, double weight) {
    const Vector3 w = weight * n;
    return {w.x() * n.x(), w.x() * n.y(), w.x() * n.z(), w.y() * n.y(), w.y() * n.z(), w.z() * n.z()};
  }

  Symmetric3& operator+=(const Symmetric3& o) {
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz;
    return *this;
  }

  Symmetric3 operator*(double s) const { return {s * xx, s * xy, s * xz, s * yy, s * yz, s * zz}; }

  double trace() const { return xx + yy + zz; }

  Vector3 operator*(const Vector3& v) const {
    return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
            xz * v.x() + yz * v.y() + zz * v.z()};
  }

  Symmetric3 plus_diagonal(double d) const { return {xx + d, xy, xz, yy + d, yz, zz + d}; }

  /// x of (*this) x = r for a positive definite matrix, by LDL^T.
  Vector3 solve(const Vector3& r) const {
    const double l10 = xy / xx, l20 = xz / xx;
    const double d1 = yy - l10 * xy;
    const double l21 = (yz - l20 * xy) / d1;
    const double d2 = zz - l20 * xz - l21 * l21 * d1;
    const double y1 = r.y() - l10 * r.x();
    const double z = (r.z() - l20 * r.x() - l21 * y1) / d2;
    const double y = y1 / d1 - l21 * z;
    return {r.x() / xx - l10 * y - l20 * z, y, z};
  }
};

inline Symmetric3 operator+(Symmetric3 a, const Symmetric3& b) { return a += b; }

}  // namespace curvdecim
