// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <type_traits>

#include "vcg_ext/errors.h"
#include "vcg_ext/params.h"

namespace curvdecim::detail {

/// The shortest decimal number that reads back as this one.
inline std::string decimal(double number) {
  std::array<char, 32> text;  // the longest shortest decimal of a double has 24 characters
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

/// "above 0 and at most 180 degrees"; empty where every finite number is in the range.
inline std::string describe(const Range& range) {
  std::string text;
  if (std::isfinite(range.low))
    text = (range.low_excluded ? "above " : "at least ") + decimal(range.low);
  if (std::isfinite(range.high))
    text += (text.empty() ? "at most " : " and at most ") + decimal(range.high);
  const bool has_unit = !text.empty() && *range.unit != '\0';
  return has_unit ? text + ' ' + range.unit : text;
}

[[noreturn]] inline void refuse_value(const std::string& name, double value,
                                      const std::string& allowed) {
  throw InputError(
      name + " is " + decimal(value) + "; it must be " + allowed + ". The mesh was not changed.",
      {name});
}

/// Throws InputError for a number out of its range.
inline void validate_field(const char* name, double value, const Range& range) {
  if (range.contains(value)) return;
  const std::string allowed = describe(range);
  refuse_value(name, value, allowed.empty() ? "a finite number" : allowed);
}

/// Throws InputError for a number that is no constant of the enum.
template <class Enum>
void validate_field(const char* name, Enum value) {
  std::string allowed;
  int number = 0;
  for (const char* label : labels(value)) {
    if (static_cast<int>(value) == number++) return;
    allowed += (allowed.empty() ? "one of " : ", ") + std::string(label);
  }
  refuse_value(name, static_cast<int>(value), allowed);
}

/// Checks every field by its range.
template <class Params>
void validate_fields(const Params& params) {
  for_each_field<Params>([&](const auto& field) {
    const auto value = params.*field.member;
    using Type = std::decay_t<decltype(value)>;
    if constexpr (std::is_enum_v<Type>)
      validate_field(field.name, value);
    else if constexpr (!std::is_same_v<Type, bool>)
      validate_field(field.name, static_cast<double>(value), field.range);
  });
}

/// Throws InputError where a field is out of its range, or fields contradict each other.
template <class Params>
void validate(const Params& params) {
  validate_fields(params);
}

inline void validate(const EdgeCollapseParams& params) {
  validate_fields(params);
  if (params.pair_distance > 0.0 && params.max_error > 0.0)
    throw InputError(
        "pair_distance and max_error are both given, but no bound is known where parts join. Set "
        "one of them to 0.",
        {"pair_distance", "max_error"});
}

/// Throws InputError where the parameters name no target.
inline void require_target(const DecimationParams& params) {
  if (params.target_faces == DecimationParams::no_target && params.target_vertices == 0 &&
      params.target_fraction == 0.0 && params.max_error == 0.0)
    throw InputError(
        "No target is given. Set target_faces, target_vertices, target_fraction or max_error.",
        {"target_faces", "target_vertices", "target_fraction", "max_error"});
}

inline void require_target(const VertexRemovalParams& params) {
  if (params.distance_bound == 0.0) require_target(static_cast<const DecimationParams&>(params));
}

inline void require_target(const ClusteringParams& params) {
  if (params.cell_size == 0.0 && params.target_faces == 0 && params.target_fraction == 0.0 &&
      params.max_error == 0.0)
    throw InputError(
        "No target is given. Set cell_size, target_faces, target_fraction or max_error.",
        {"cell_size", "target_faces", "target_fraction", "max_error"});
}

}  // namespace curvdecim::detail
