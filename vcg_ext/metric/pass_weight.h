// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace curvdecim::detail {

/// How much a vertex counts in passes (passes/), and what that is averaged by where two become one.
struct PassWeight {
  float saturation = 1.0f;  ///< CurvatureWeight::saturation
  float area = 0.0f;        ///< of the input, that has gone into it
  float factor = 1.0f;      ///< on the planes around
};

}  // namespace curvdecim::detail
