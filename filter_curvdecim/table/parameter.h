// SPDX-License-Identifier: GPL-3.0-or-later
// A parameter of a filter, as dialogs, scripts and documentation need it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "vcg_ext/errors.h"
#include "vcg_ext/field.h"

namespace curvdecim::glue {

/// What a host shows, and in which type it hands the value over: an Enum as int, a Length
/// (absolute, or per cent of the bounding box's diagonal) as double in the mesh's unit, a Layer of
/// the document as the int that is its number.
enum class Kind { Bool, Int, Float, Length, Enum, Layer };
constexpr auto labels(Kind) {
  return std::array{"bool", "int", "float", "length", "enum", "layer"};
}

inline constexpr const char* layer_unit = "the number of a layer";

/// The document knows which there are.
inline constexpr Range any_layer = {Range().low, Range().high, layer_unit};

using Value = std::variant<bool, int, double>;

/// What defaults may depend on. Lengths in the mesh's unit.
struct MeshFacts {
  int faces = 0;
  int selected_faces = 0;
  double diagonal = 0.0;
  int first_layer = 0, second_layer = 0;  ///< of the document; where it has one, twice the same
};

/// A default that depends on the mesh.
struct MeshDefault {
  Value (*value)(const MeshFacts&);
  std::string meaning;  ///< in a few words, for the documentation
};

/// One of the values of an Enum; its number is its place.
struct Choice {
  std::string name;
  std::string hint;  ///< the meaning in a few words, for the dialog
  std::string meaning;
};

struct ParameterText {
  std::string help;  ///< HTML, for the documentation
  std::string hint;  ///< for the dialog, which cuts longer texts off; may be empty for an Enum
};

/// Who needs a parameter.
enum class Audience {
  Everyone,
  Tuning,      ///< those who tune: in a dialog that unfolds, on demand
  Papers,      ///< those who repeat a paper, or go on with the result in scripts: the same
  Assemblies,  ///< those whose mesh is of parts that lie close to each other: the same
};

/// Where a dialog shows a parameter.
struct Place {
  std::string heading = {};  ///< bold, above it; dialogs sort by it, after what has none
  Audience audience = Audience::Everyone;
  std::vector<Audience> also_for = {};  ///< others who need it beside their own, in flat dialogs
};

struct Parameter {
  std::string name;   ///< as hosts and their scripts have it
  std::string field;  ///< the name of the core's member
  std::string label;
  ParameterText text;
  Kind kind;
  Range range;
  Value fixed_default;
  std::optional<MeshDefault> mesh_default = std::nullopt;  ///< wins over fixed_default
  std::vector<Choice> choices = {};
  Place place = {};
};

Value default_value(const Parameter& parameter, const MeshFacts& mesh);

/// The name as PyMeshLab has it: in lower case, and with an underscore where Python has the word
/// for itself.
std::string python_name(const Parameter& parameter);

/// As a dialog has it, with the name that scripts use: 'Preset' (Preset).
std::string name_in_dialog(const Parameter& parameter);

/// The hint, and those of the choices, on a line each where one line is too short, in HTML.
std::string dialog_help(const Parameter& parameter);

/// The same error with names that the user knows in place of the core's.
InputError in_names_of(const std::vector<Parameter>& parameters, const InputError& error,
                       std::string (*shown)(const Parameter&));

}  // namespace curvdecim::glue
