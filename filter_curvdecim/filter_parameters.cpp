// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/filter_parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

#include "vcg_ext/errors.h"

namespace curvdecim {
namespace {

const Binding* binding_of(const Parameter& parameter, FilterId filter) {
  const auto found =
      std::find_if(parameter.bindings.begin(), parameter.bindings.end(),
                   [filter](const Binding& binding) { return binding.filter == filter; });
  return found == parameter.bindings.end() ? nullptr : &*found;
}

double as_number(const Value& value) {
  return std::visit([](auto stored) { return static_cast<double>(stored); }, value);
}

bool contains(const Range& range, double number) {
  return std::isfinite(number) && number <= range.high &&
         (range.low_excluded ? number > range.low : number >= range.low);
}

Range allowed_range(const Parameter& parameter) {
  if (parameter.kind == Kind::Enum)
    return {0.0, static_cast<double>(parameter.values.size()) - 1.0};
  return parameter.range;
}

std::string allowed_text(const Parameter& parameter) {
  const std::string text = describe(allowed_range(parameter), parameter.unit);
  return text.empty() ? "a finite number" : text;
}

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + " " + unit;
}

}  // namespace

std::vector<const Parameter*> parameters_of(FilterId filter) {
  std::vector<const Parameter*> rows;
  for (const Parameter& parameter : parameter_table())
    if (binding_of(parameter, filter)) rows.push_back(&parameter);
  return rows;
}

MeshDefault mesh_default_of(const Parameter& parameter, FilterId filter) {
  return binding_of(parameter, filter)->mesh_default;
}

Meaning meaning_of(const Parameter& parameter, FilterId filter) {
  return binding_of(parameter, filter)->meaning.value_or(Meaning{parameter.help, parameter.hint});
}

Value default_value(const Parameter& parameter, FilterId filter, const MeshFacts& mesh) {
  switch (mesh_default_of(parameter, filter)) {
    case MeshDefault::HalfOfFaces:
      return (mesh.selected_faces > 0 ? mesh.selected_faces : mesh.faces) / 2;
    case MeshDefault::FacesSelected: return mesh.selected_faces > 0;
    case MeshDefault::PercentOfDiagonal:
      return std::isfinite(mesh.diagonal) ? 0.01 * mesh.diagonal : 0.0;
    case MeshDefault::None: break;
  }
  return binding_of(parameter, filter)->get(Settings());
}

void assign(Settings& settings, FilterId filter, const Parameter& parameter, const Value& value) {
  const double number = as_number(value);
  if (parameter.kind != Kind::Bool && !contains(allowed_range(parameter), number))
    throw InputError(parameter.name + " is " + decimal(number) + "; it must be " +
                     allowed_text(parameter) + ". The mesh was not changed.");
  binding_of(parameter, filter)->set(settings, value);
}

std::string describe(const Range& range, const std::string& unit) {
  std::string text;
  if (std::isfinite(range.low))
    text = (range.low_excluded ? "above " : "at least ") + decimal(range.low);
  if (std::isfinite(range.high))
    text += (text.empty() ? "at most " : " and at most ") + decimal(range.high);
  return text.empty() ? text : with_unit(text, unit);
}

std::string dialog_help(const Parameter& parameter, FilterId filter) {
  constexpr std::size_t line = 70;  // characters that the dialog shows side by side
  std::size_t length = 0;
  for (const EnumValue& value : parameter.values)
    length += value.name.size() + value.hint.size() + std::strlen(": ; ");
  const char* const between = length <= line ? "; <b>" : "<br><b>";
  std::string values;
  for (const EnumValue& value : parameter.values)
    values += (values.empty() ? "<b>" : between) + value.name + "</b>" +
              (value.hint.empty() ? "" : ": ") + value.hint;
  const std::string hint = meaning_of(parameter, filter).hint;
  return hint + (hint.empty() || values.empty() ? "" : "<br>") + values;
}

std::string decimal(double number) {
  std::array<char, 32> text;  // the longest shortest decimal of a double has 24 characters
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

}  // namespace curvdecim
