// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/symmetric3.h"
#include "vcg_ext/geometry/triangle.h"
#include "vcg_ext/params.h"

namespace curvdecim {

/// The plane of a face about any of its corners, which it passes through; factor: on its weight.
inline Symmetric3 plane_matrix(const FacePlane& plane, PlaneWeight weight, double factor = 1.0) {
  return Symmetric3::outer(plane.normal,
                           weight == PlaneWeight::Area ? factor * plane.area : factor);
}

}  // namespace curvdecim
