// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/vector3.h"

namespace curvdecim::detail {

/// Symmetric 3x3 matrix.
struct Symmetric3 {
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;

  /// weight * n n^T
  static Symmetric3 outer(const Vector3& n, double weight) {
    const Vector3 w = weight * n;
    return {w.x() * n.x(), w.x() * n.y(), w.x() * n.z(),
            w.y() * n.y(), w.y() * n.z(), w.z() * n.z()};
  }

  Symmetric3& operator+=(const Symmetric3& o) {
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz;
    return *this;
  }

  Symmetric3& operator-=(const Symmetric3& o) {
    xx -= o.xx, xy -= o.xy, xz -= o.xz, yy -= o.yy, yz -= o.yz, zz -= o.zz;
    return *this;
  }

  Symmetric3 operator*(double s) const { return {s * xx, s * xy, s * xz, s * yy, s * yz, s * zz}; }

  double trace() const { return xx + yy + zz; }

  Vector3 operator*(const Vector3& v) const {
    return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
            xz * v.x() + yz * v.y() + zz * v.z()};
  }

  Symmetric3 plus_diagonal(double d) const { return {xx + d, xy, xz, yy + d, yz, zz + d}; }
};

inline Symmetric3 operator+(Symmetric3 a, const Symmetric3& b) { return a += b; }

inline Symmetric3 operator-(Symmetric3 a, const Symmetric3& b) { return a -= b; }

/// L D L^T of a positive definite matrix, to solve for several right sides.
class Factorization3 {
 public:
  explicit Factorization3(const Symmetric3& m) {
    i0_ = 1.0 / m.xx;
    l10_ = m.xy * i0_, l20_ = m.xz * i0_;
    i1_ = 1.0 / (m.yy - l10_ * m.xy);
    const double u21 = m.yz - l20_ * m.xy;
    l21_ = u21 * i1_;
    i2_ = 1.0 / (m.zz - l20_ * m.xz - l21_ * u21);
  }

  Vector3 solve(const Vector3& r) const {
    const double y1 = r.y() - l10_ * r.x();
    const double z = (r.z() - l20_ * r.x() - l21_ * y1) * i2_;
    const double y = y1 * i1_ - l21_ * z;
    return {r.x() * i0_ - l10_ * y - l20_ * z, y, z};
  }

 private:
  double l10_, l20_, l21_, i0_, i1_, i2_;
};

}  // namespace curvdecim::detail
