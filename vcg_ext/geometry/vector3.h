// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace curvdecim {

using Vector3 = Eigen::Vector3d;

}  // namespace curvdecim
