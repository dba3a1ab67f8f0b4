// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace curvdecim::detail {

/// Texture coordinates of one corner of a face.
struct WedgeCoordinate {
  double u = 0.0, v = 0.0;
  int page = 0;  // texture image
};

using FaceWedges = std::array<WedgeCoordinate, 3>;

}  // namespace curvdecim::detail
