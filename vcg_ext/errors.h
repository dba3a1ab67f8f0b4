// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace curvdecim {

/// A mesh or a parameter that cannot be used. The message names what, where and what to do; it is
/// thrown before the mesh is touched.
struct InputError : std::invalid_argument {
  /// fields: the members of the parameters that the message names, for a caller who shows them
  /// under other names.
  explicit InputError(const std::string& message, std::vector<std::string> named_fields = {})
      : std::invalid_argument(message), fields(std::move(named_fields)) {}

  std::vector<std::string> fields;
};

}  // namespace curvdecim
