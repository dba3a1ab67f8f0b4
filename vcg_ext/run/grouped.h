// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace curvdecim::detail {

/// A count as people read it: 1,234,567.
inline std::string grouped(std::int64_t count) {
  std::string digits = std::to_string(count);
  const int first = count < 0 ? 1 : 0;
  for (int place = static_cast<int>(digits.size()) - 3; place > first; place -= 3)
    digits.insert(place, ",");
  return digits;
}

}  // namespace curvdecim::detail
