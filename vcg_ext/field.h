// SPDX-License-Identifier: GPL-3.0-or-later
// What the parameters tell about themselves: the members by name, their ranges and units, and the
// labels of enums. Checks, dialogs, scripts and documentation are made from it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

namespace curvdecim {

/// The values that a number may have, both ends included but where said, and their unit.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  const char* unit = "";
  bool low_excluded = false;

  /// NaN and infinite numbers never lie in a range.
  bool contains(double number) const {
    return std::isfinite(number) && number <= high && (low_excluded ? number > low : number >= low);
  }
};

inline constexpr const char* length_unit = "in the mesh's unit";

constexpr Range at_least(double low, const char* unit = "") {
  return {low, std::numeric_limits<double>::infinity(), unit};
}

constexpr Range above_up_to(double low, double high, const char* unit = "") {
  return {low, high, unit, true};
}

constexpr Range between(double low, double high, const char* unit = "") {
  return {low, high, unit};
}

/// A member of a struct of parameters.
template <class Params, class Value>
struct Field {
  const char* name;
  Value Params::*member;
  Range range;

  constexpr Field(const char* its_name, Value Params::*its_member, Range its_range = {})
      : name(its_name), member(its_member), range(its_range) {}
};

/// use(field) for every field of a struct of parameters, those of its bases first.
template <class Params, class Use>
constexpr void for_each_field(Use use) {
  std::apply([&](const auto&... field) { (use(field), ...); }, Params::fields());
}

/// The label of an enum's constant, from labels(Enum), which stands beside the enum.
template <class Enum>
constexpr const char* label_of(Enum value) {
  return labels(value)[static_cast<std::size_t>(value)];
}

}  // namespace curvdecim
