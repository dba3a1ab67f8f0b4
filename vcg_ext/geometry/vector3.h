// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/floating_point.h"
// clang-format off: before Eigen
#include <Eigen/Core>
#include <Eigen/Geometry>
// clang-format on

namespace curvdecim::detail {

using Vector3 = Eigen::Vector3d;
using Vector2 = Eigen::Vector2d;  // in a texture

/// A host's point or vector, of any scalar.
template <class HostVector>
Vector3 vector_of(const HostVector& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// The way back: rounds to the host's scalar.
template <class HostVector>
void assign(HostVector& to, const Vector3& p) {
  for (int k = 0; k < 3; ++k) to[k] = static_cast<typename HostVector::ScalarType>(p[k]);
}

}  // namespace curvdecim::detail
