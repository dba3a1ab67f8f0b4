// SPDX-License-Identifier: GPL-3.0-or-later
// curvdecim_parameters --markdown | --json: the filters and their parameters, for the documentation
// and for the Python package.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iostream>
#include <string>

#include <nlohmann/json.hpp>

#include "filter_curvdecim/filter_parameters.h"
#include "filter_curvdecim/filter_texts.h"
#include "vcg_ext/report.h"

namespace curvdecim {
namespace {

using Json = nlohmann::ordered_json;

const char* type_name(Kind kind) {
  switch (kind) {
    case Kind::Bool: return "bool";
    case Kind::Int: return "int";
    case Kind::Float: return "float";
    case Kind::Length: return "length";
    case Kind::Enum: return "enum";
  }
  return "";
}

/// Lower case, and with an underscore where Python has the word for itself, as PyMeshLab does.
std::string python_name(std::string name) {
  constexpr std::array keywords = {
      "and",    "as",   "assert", "async",  "await",  "break",   "class",    "continue",
      "def",    "del",  "elif",   "else",   "except", "finally", "for",      "from",
      "global", "if",   "import", "in",     "is",     "lambda",  "nonlocal", "not",
      "or",     "pass", "raise",  "return", "try",    "while",   "with",     "yield"};
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  const bool taken = std::find(keywords.begin(), keywords.end(), name) != keywords.end();
  return taken ? name + "_" : name;
}

Json bound(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }

Json default_of(const Parameter& parameter, FilterId filter) {
  if (mesh_default_of(parameter, filter) != MeshDefault::None) return "dynamic";
  const Value value = default_value(parameter, filter, {});
  if (parameter.kind == Kind::Enum) return parameter.values[std::get<int>(value)].name;
  return std::visit([](auto stored) { return Json(stored); }, value);
}

Json values_of(const Parameter& parameter) {
  Json values = Json::array();
  for (const EnumValue& value : parameter.values)
    values.push_back({{"name", value.name}, {"meaning", value.meaning}});
  return values;
}

Json describe_parameter(const Parameter& parameter, FilterId filter) {
  return {{"name", parameter.name},
          {"python_name", python_name(parameter.name)},
          {"type", type_name(parameter.kind)},
          {"default", default_of(parameter, filter)},
          {"range",
           {{"low", bound(parameter.range.low)},
            {"low_excluded", parameter.range.low_excluded},
            {"high", bound(parameter.range.high)}}},
          {"unit", parameter.unit},
          {"values", values_of(parameter)},
          {"label", parameter.label},
          {"help", meaning_of(parameter, filter).help}};
}

Json describe_filter(const FilterText& text) {
  Json parameters = Json::array();
  for (const Parameter* parameter : parameters_of(text.id))
    parameters.push_back(describe_parameter(*parameter, text.id));
  return {{"menu_name", text.menu_name},
          {"python_name", text.python_name},
          {"info", text.info},
          {"parameters", parameters}};
}

/// By number: PyMeshLab's dictionaries hold no text, so that stopped_by comes as this number there.
Json stop_reasons() {
  Json reasons = Json::array();
  for (StopReason reason :
       {StopReason::Target, StopReason::ErrorBound, StopReason::NothingLeft, StopReason::Cancelled})
    reasons.push_back(to_string(reason));
  return reasons;
}

Json as_json() {
  Json filters = Json::array();
  for (const FilterText& text : filter_texts()) filters.push_back(describe_filter(text));
  return {{"filters", filters}, {"stop_reasons", stop_reasons()}};
}

std::string default_text(const Parameter& parameter, FilterId filter) {
  switch (mesh_default_of(parameter, filter)) {
    case MeshDefault::HalfOfFaces:
      return "half of the faces, or of the selected ones if there are any";
    case MeshDefault::FacesSelected: return "true if faces are selected";
    case MeshDefault::PercentOfDiagonal: return "1 % of the bounding box's diagonal";
    case MeshDefault::None: break;
  }
  const Json value = default_of(parameter, filter);
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void print_parameter(const Parameter& parameter, FilterId filter) {
  const std::string range = describe(parameter.range, parameter.unit);
  std::cout << "### " << parameter.name << "\n\n"
            << parameter.label << ". In Python: `" << python_name(parameter.name)
            << "`. Type: " << type_name(parameter.kind) << (range.empty() ? "" : ", " + range)
            << ". Default: " << default_text(parameter, filter) << ".\n\n"
            << meaning_of(parameter, filter).help << "\n\n";
  for (const EnumValue& value : parameter.values)
    std::cout << "* `" << value.name << "`: " << value.meaning << "\n";
  if (!parameter.values.empty()) std::cout << "\n";
}

void print_results() {
  std::cout
      << "## What a decimation returns\n\n"
         "The log of MeshLab and meshlabserver has a line for each of these, PyMeshLab returns "
         "them as a dictionary.\n\n"
         "* `faces_before`, `faces`, `vertices_before`, `vertices`: the counts before and after\n"
         "* `stopped_by`: why it ended; as a number where PyMeshLab returns it without the Python "
         "package:";
  int number = 0;
  for (const Json& reason : stop_reasons())
    std::cout << (number ? ", " : " ") << number << " = " << reason.get<std::string>(), ++number;
  std::cout << "\n* `max_error`: no point of either surface is further than this from the other, "
               "in the mesh's unit; only "
               "with `MaxError`\n"
               "* `pairs_contracted`: how many unconnected pairs of vertices merged; only with "
               "`PairDistance`\n"
               "* `cost_last`: the cost of the last collapse, for a mesh of diagonal 1\n"
               "* `rejected_<reason>`: how many collapses each guard refused\n"
               "* `seconds`: wall time\n";
}

void print_filter(const FilterText& text) {
  std::cout << "## " << text.menu_name << "\n\nIn Python: `" << text.python_name << "`\n\n"
            << text.info << "\n\n";
  for (const Parameter* parameter : parameters_of(text.id)) print_parameter(*parameter, text.id);
}

void print_markdown() {
  std::cout << "# Filters and their parameters\n\n"
               "Generated by `curvdecim_parameters --markdown`; edit "
               "`filter_curvdecim/parameter_table.cpp` instead.\n"
               "A parameter of type length is an absolute length, or per cent of the bounding "
               "box's diagonal.\n\n";
  for (const FilterText& text : filter_texts()) print_filter(text);
  print_results();
}

}  // namespace
}  // namespace curvdecim

int main(int argc, char** argv) {
  const std::string format = argc == 2 ? argv[1] : "";
  if (format == "--json") {
    std::cout << curvdecim::as_json().dump(2) << "\n";
  } else if (format == "--markdown") {
    curvdecim::print_markdown();
  } else {
    std::cerr << "usage: curvdecim_parameters --json | --markdown\n";
    return 2;
  }
}
