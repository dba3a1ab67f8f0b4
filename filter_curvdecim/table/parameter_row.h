// SPDX-License-Identifier: GPL-3.0-or-later
// A row of a filter's table: a parameter, and the member of the core's parameters that it sets. The
// range, the unit and the labels come from the core.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "filter_curvdecim/table/parameter.h"

namespace curvdecim::glue {

template <class Params>
struct ParameterRow : Parameter {
  std::function<void(Params&, const Value&)> assign;
};

template <class Params>
using ParameterRows = std::vector<ParameterRow<Params>>;

/// The alternative of Value that holds a member of this type.
template <class Member>
using StoredAs =
    std::conditional_t<std::is_same_v<Member, bool>, bool,
                       std::conditional_t<std::is_floating_point_v<Member>, double, int>>;

/// How hosts show a member of this type. The unit tells a Length and a Layer.
template <class Member>
Kind kind_of(const Range& range) {
  if (std::is_enum_v<Member>) return Kind::Enum;
  if (std::is_same_v<Member, bool>) return Kind::Bool;
  if (std::is_same_v<Member, int>)
    return range.unit == std::string_view(layer_unit) ? Kind::Layer : Kind::Int;
  return range.unit == std::string_view(length_unit) ? Kind::Length : Kind::Float;
}

/// What the core says about a member; throws std::bad_optional_access where Params::fields() lacks
/// it.
template <class Params, class Owner, class Member>
Field<Owner, Member> field_of(Member Owner::*member) {
  std::optional<Field<Owner, Member>> found;
  for_each_field<Params>([&](const auto& field) {
    if constexpr (std::is_same_v<decltype(field.member), Member Owner::*>)
      if (field.member == member) found = field;
  });
  return found.value();
}

/// The row of a member that is not an enum.
template <class Params, class Owner, class Member>
ParameterRow<Params> row(Member Owner::*member, std::string name, std::string label,
                         ParameterText text,
                         std::optional<MeshDefault> mesh_default = std::nullopt) {
  using Stored = StoredAs<Member>;
  const Field<Owner, Member> field = field_of<Params>(member);
  return {
      {std::move(name), field.name, std::move(label), std::move(text), kind_of<Member>(field.range),
       field.range, static_cast<Stored>(Params().*member), std::move(mesh_default)},
      [member](Params& params, const Value& value) {
        params.*member = static_cast<Member>(std::get<Stored>(value));
      }};
}

template <class Params>
ParameterRows<Params> under(const char* heading, ParameterRows<Params> rows) {
  for (auto& row : rows) row.place.heading = heading;
  return rows;
}

template <class Params>
ParameterRow<Params> tuning(ParameterRow<Params> row) {
  row.place.audience = Audience::Tuning;
  return row;
}

template <class Params>
ParameterRow<Params> paper(ParameterRow<Params> row) {
  row.place.audience = Audience::Papers;
  return row;
}

template <class Params>
ParameterRows<Params> for_papers(ParameterRows<Params> rows) {
  for (auto& row : rows) row = paper(row);
  return rows;
}

template <class Params>
ParameterRow<Params> assemblies(ParameterRow<Params> row) {
  row.place.audience = Audience::Assemblies;
  return row;
}

template <class Params>
ParameterRow<Params> also_for(const std::vector<Audience>& others, ParameterRow<Params> row) {
  row.place.also_for = others;
  return row;
}

template <class Params>
ParameterRow<Params> also_for_assemblies(ParameterRow<Params> row) {
  return also_for({Audience::Assemblies}, std::move(row));
}

/// What a flat dialog starts with, whoever it is for.
template <class Params>
ParameterRow<Params> for_all(ParameterRow<Params> row) {
  return also_for({Audience::Papers, Audience::Assemblies}, std::move(row));
}

template <class Enum>
struct ChoiceText {
  Enum constant;
  const char *hint, *meaning;
};

/// The choices in the order of the core, whatever that of the texts is.
template <class Enum>
std::vector<Choice> choices_of(const std::vector<ChoiceText<Enum>>& texts) {
  std::vector<Choice> choices;
  for (const char* label : labels(Enum())) choices.push_back({label, "", ""});
  for (const auto& [constant, hint, meaning] : texts)
    choices[static_cast<std::size_t>(constant)] = {label_of(constant), hint, meaning};
  return choices;
}

/// The row of an enum.
template <class Params, class Owner, class Enum>
ParameterRow<Params> enum_row(Enum Owner::*member, std::string name, std::string label,
                              std::string help, const std::vector<ChoiceText<Enum>>& texts) {
  ParameterRow<Params> made =
      row<Params>(member, std::move(name), std::move(label), {std::move(help), ""});
  made.choices = choices_of(texts);
  return made;
}

}  // namespace curvdecim::glue
