// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/geometry/vector3.h"

namespace curvdecim::test {

/// Points in and around the box of diagonal 1.
inline std::vector<detail::Vector3> probes() {
  std::vector<detail::Vector3> points;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 6; ++k)
        points.emplace_back(0.23 * i - 0.61, 0.21 * j - 0.53, 0.19 * k - 0.47);
  return points;
}

}  // namespace curvdecim::test
