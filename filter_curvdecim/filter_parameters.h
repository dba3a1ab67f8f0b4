// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "filter_curvdecim/filter_texts.h"
#include "vcg_ext/params.h"

namespace curvdecim {

/// Vertex removal, and what it shows.
struct VertexRemovalTask : VertexRemovalParams {
  bool show_classes = false;  ///< writes the classes of the vertices to their quality and colour
};

/// The parameters of every filter.
struct Settings {
  EdgeCollapseParams edge_collapse;
  VertexRemovalTask vertex_removal;
  SphereParams sphere;
  ClusteringParams clustering;
  ImportanceParams importance;
};

/// What a host shows, and in which type it hands the value over: an Enum as int, a Length
/// (absolute, or per cent of the bounding box's diagonal) as double in the mesh's unit.
enum class Kind { Bool, Int, Float, Length, Enum };
using Value = std::variant<bool, int, double>;

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_excluded = false;
};

struct EnumValue {
  std::string name;
  std::string hint;  ///< the meaning in a few words, for the dialog
  std::string meaning;
};

/// A default that depends on the mesh; otherwise it is that of the default-constructed parameters.
enum class MeshDefault { None, HalfOfFaces, FacesSelected, PercentOfDiagonal };

/// Help and hint of a parameter.
struct Meaning {
  std::string help, hint;
};

/// A filter that has the parameter, and the member of its parameters that holds the value.
struct Binding {
  FilterId filter;
  void (*set)(Settings&, const Value&);
  Value (*get)(const Settings&);
  MeshDefault mesh_default = MeshDefault::None;
  std::optional<Meaning> meaning = std::nullopt;  ///< where it differs from the row's
};

struct Parameter {
  std::string name;
  std::string label;
  Kind kind;
  Range range;
  std::string unit;
  std::string help;  ///< HTML, for the documentation
  std::string hint;  ///< for the dialog, which cuts longer texts off; may be empty for an Enum
  std::vector<EnumValue> values;
  std::vector<Binding> bindings;
};

/// What defaults may depend on. Lengths in the mesh's unit.
struct MeshFacts {
  int faces = 0;
  int selected_faces = 0;
  double diagonal = 0.0;
};

/// The one table of parameters, in the order of the dialogs.
const std::vector<Parameter>& parameter_table();

/// The rows of one filter.
std::vector<const Parameter*> parameters_of(FilterId filter);

MeshDefault mesh_default_of(const Parameter& parameter, FilterId filter);

Meaning meaning_of(const Parameter& parameter, FilterId filter);

Value default_value(const Parameter& parameter, FilterId filter, const MeshFacts& mesh);

/// Throws InputError for a value out of range, and names the parameter, the value and the range.
void assign(Settings& settings, FilterId filter, const Parameter& parameter, const Value& value);

/// "above 0 and at most 180 degrees"; empty when every finite number is allowed.
std::string describe(const Range& range, const std::string& unit);

/// The hint, or those of the enum values on a line each, in HTML.
std::string dialog_help(const Parameter& parameter, FilterId filter);

/// The shortest decimal number that reads back as this one.
std::string decimal(double number);

}  // namespace curvdecim
