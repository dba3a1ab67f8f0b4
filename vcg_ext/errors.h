// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace curvdecim {

/// A mesh or a parameter that cannot be used. The message names what, where and what to do; it is
/// thrown before the mesh is touched.
struct InputError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

}  // namespace curvdecim
