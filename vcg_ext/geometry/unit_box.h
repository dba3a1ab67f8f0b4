// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "vcg_ext/errors.h"
#include "vcg_ext/geometry/vector3.h"

namespace curvdecim::detail {

/// The way between a mesh's own coordinates and a box of diagonal 1 around the origin.
struct UnitBox {
  Vector3 center = Vector3::Zero();
  double diagonal = 1.0;  // of the bounding box, in the mesh's unit

  Vector3 to_box(const Vector3& p) const { return (p - center) / diagonal; }
  Vector3 to_user(const Vector3& p) const { return diagonal * p + center; }
};

/// The way to and from a bounding box. Divides by its largest side before squaring, so that no
/// unit of length overflows. Throws InputError where the box is a point.
inline UnitBox unit_box(const Vector3& low, const Vector3& high) {
  const double side = (high - low).maxCoeff();
  if (!(side > 0.0) || !std::isfinite(side))
    throw InputError("All faces lie in one point, or the coordinates are too large to subtract.");
  return {0.5 * low + 0.5 * high, side * ((high - low) / side).norm()};
}

}  // namespace curvdecim::detail
