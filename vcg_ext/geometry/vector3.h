// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/floating_point.h"
// clang-format off: before Eigen
#include <Eigen/Core>
#include <Eigen/Geometry>
// clang-format on

namespace curvdecim::detail {

using Vector3 = Eigen::Vector3d;

}  // namespace curvdecim::detail
