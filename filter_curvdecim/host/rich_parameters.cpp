// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/host/rich_parameters.h"

#include <charconv>
#include <cmath>

#include "vcg_ext/errors.h"

namespace curvdecim::glue {
namespace {

QStringList names_of(const std::vector<Choice>& choices) {
  QStringList names;
  for (const Choice& choice : choices) names.append(QString::fromStdString(choice.name));
  return names;
}

/// The hosts keep every number as float, also those in double precision. The shortest decimal that
/// gives this float is the number that was typed: 0.7, not 0.699999988.
double as_typed(float number) {
  if (!std::isfinite(number)) return number;
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, number).ptr;
  double typed = number;
  std::from_chars(text, end, typed);
  return typed;
}

template <class T>
struct Tag {
  using Type = T;
};

void add_parameter(RichParameterList& list, const Parameter& parameter, const MeshFacts& mesh,
                   const MeshDocument& document) {
  const Value value = default_value(parameter, mesh);
  const bool advanced = parameter.place.audience != Audience::Everyone;
  const QString heading = QString::fromStdString(parameter.place.heading);
  const QString name = QString::fromStdString(parameter.name);
  const QString label = QString::fromStdString(parameter.label);
  const QString help = QString::fromStdString(dialog_help(parameter));
  // The dialog divides by the diagonal to show per cent.
  const double whole = std::isfinite(mesh.diagonal) && mesh.diagonal > 0.0 ? mesh.diagonal : 1.0;
  const auto add = [&](auto type, const auto&... values) {
    using Rich = typename decltype(type)::Type;
    list.addParam(in_place<Rich>(advanced, heading, name, values..., label, help));
  };
  switch (parameter.kind) {
    case Kind::Bool: return add(Tag<RichBool>(), std::get<bool>(value));
    case Kind::Int: return add(Tag<RichInt>(), std::get<int>(value));
    case Kind::Float: return add(Tag<RichFloat>(), std::get<double>(value));
    case Kind::Length: return add(Tag<RichLength>(), std::get<double>(value), 0, whole);
    case Kind::Enum: return add(Tag<RichEnum>(), std::get<int>(value), names_of(parameter.choices));
    case Kind::Layer: return add(Tag<RichLayer>(), std::get<int>(value), &document);
  }
}

/// A script may name any type for a parameter; the host's getters do not check it.
Value read_value(const Parameter& parameter, const ::Value& value) {
  switch (parameter.kind) {
    case Kind::Bool:
      if (value.isBool()) return value.getBool();
      break;
    case Kind::Int:
    case Kind::Enum:
      if (value.isInt()) return value.getInt();
      break;
    case Kind::Float:
    case Kind::Length:
      if (value.isFloat()) return as_typed(value.getFloat());
      break;
    case Kind::Layer:
      if (const auto number = layer_number(value)) return *number;
      break;
  }
  throw InputError(parameter.name + " is given as " + value.typeName().toStdString() +
                   ", which is not its type. The mesh was not changed.");
}

}  // namespace

RichParameterList rich_parameters(const std::vector<Parameter>& parameters, const MeshFacts& mesh,
                                  const MeshDocument& document) {
  RichParameterList list;
  for (const Parameter& parameter : parameters) add_parameter(list, parameter, mesh, document);
  return list;
}

std::vector<Value> read_values(const std::vector<Parameter>& parameters,
                               const RichParameterList& list, const MeshFacts& mesh) {
  std::vector<Value> values;
  for (const Parameter& parameter : parameters) {
    const QString name = QString::fromStdString(parameter.name);
    values.push_back(list.hasParameter(name)
                         ? read_value(parameter, list.getParameterByName(name).value())
                         : default_value(parameter, mesh));
  }
  return values;
}

}  // namespace curvdecim::glue
