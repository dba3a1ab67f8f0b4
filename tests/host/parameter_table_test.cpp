// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of all filters: texts, defaults, and the members of the core that they set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "filter_curvdecim/filters/all_filters.h"
#include "filter_curvdecim/table/flat_dialogs.h"
#include "vcg_ext/errors.h"
#include "vcg_ext/run/validation.h"

namespace {

using namespace curvdecim;
using namespace curvdecim::glue;

template <class List>
struct TypesOf;
template <class... F>
struct TypesOf<FilterList<F...>> {
  using Type = testing::Types<F...>;
};

struct NameOfFilter {
  template <class F>
  static std::string GetName(int) {  // NOLINT(readability-identifier-naming): GoogleTest asks it
    return F::about().python_name;
  }
};

template <class F>
class ParameterTable : public testing::Test {};
TYPED_TEST_SUITE(ParameterTable, TypesOf<AllFilters>::Type, NameOfFilter);

template <class F>
ParameterRow<typename F::Params> row_of(const std::string& name) {
  for (const auto& row : F::parameters())
    if (row.name == name) return row;
  throw std::out_of_range("no parameter " + name);
}

template <class F>
typename F::Params with(const std::string& name, const Value& value) {
  typename F::Params params;
  row_of<F>(name).assign(params, value);
  return params;
}

std::string script_name(const Parameter& parameter) { return parameter.name; }

/// What the core says about a value, in the names of scripts; empty: nothing.
template <class F>
std::string refusal(const std::string& name, const Value& value) {
  try {
    detail::validate(with<F>(name, value));
    return "";
  } catch (const InputError& error) {
    return in_names_of(table_of<F>().parameters, error, script_name).what();
  }
}

/// A value in range that is not the default.
Value another_value(const Parameter& parameter) {
  const Value& value = parameter.fixed_default;
  if (parameter.kind == Kind::Bool) return !std::get<bool>(value);
  if (parameter.kind == Kind::Enum) return std::get<int>(value) == 0 ? 1 : 0;
  if (parameter.kind == Kind::Int || parameter.kind == Kind::Layer)
    return std::get<int>(value) == 7 ? 8 : 7;
  const double low = std::isfinite(parameter.range.low) ? parameter.range.low : 0.0;
  const double high = std::isfinite(parameter.range.high) ? parameter.range.high : low + 1.0;
  return low + 0.7 * (high - low);
}

/// The core's names of what differs between two sets of parameters.
template <class Params>
std::set<std::string> differences(const Params& one, const Params& other) {
  std::set<std::string> names;
  for_each_field<Params>([&](const auto& field) {
    if (one.*field.member != other.*field.member) names.insert(field.name);
  });
  return names;
}

TYPED_TEST(ParameterTable, BindsEveryFieldOfTheCoreOnceOrLeavesItOutOnPurpose) {
  std::multiset<std::string> expected, found;
  for_each_field<typename TypeParam::Params>(
      [&](const auto& field) { expected.insert(field.name); });
  for (const auto& row : TypeParam::parameters()) found.insert(row.field);
  for (const std::string& field : TypeParam::about().fields_not_offered) found.insert(field);
  EXPECT_EQ(found, expected);
}

TYPED_TEST(ParameterTable, HasUniqueNames) {
  std::set<std::string> names;
  for (const auto& row : TypeParam::parameters())
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
}

TYPED_TEST(ParameterTable, HasTexts) {
  EXPECT_NE(TypeParam::about().info.find("<br>See: "), std::string::npos);
  EXPECT_FALSE(TypeParam::parameters().empty());
  for (const auto& row : TypeParam::parameters()) {
    EXPECT_FALSE(row.label.empty()) << row.name;
    EXPECT_FALSE(row.text.help.empty()) << row.name;
    EXPECT_FALSE(dialog_help(row).empty()) << row.name;
    EXPECT_EQ(row.kind == Kind::Enum, !row.choices.empty()) << row.name;
    for (const Choice& choice : row.choices) EXPECT_FALSE(choice.meaning.empty()) << choice.name;
  }
}

/// What a reader sees of the HTML, by lines.
std::vector<std::string> visible_lines(const std::string& html) {
  std::vector<std::string> lines(1);
  for (std::size_t i = 0; i < html.size(); ++i) {
    if (html.compare(i, 4, "<br>") == 0) lines.emplace_back();
    if (html[i] == '<')
      i = html.find('>', i);
    else
      lines.back() += html[i];
  }
  return lines;
}

/// Otherwise they break, and its buttons move off small screens.
TYPED_TEST(ParameterTable, LabelsFitTheDialog) {
  constexpr std::size_t characters = 33;
  for (const auto& row : TypeParam::parameters())
    EXPECT_LE(row.label.size(), characters) << row.label;
}

/// "Balanced:" with nothing behind explains nothing.
TYPED_TEST(ParameterTable, EveryChoiceHasAHint) {
  for (const auto& row : TypeParam::parameters())
    for (const Choice& choice : row.choices) EXPECT_FALSE(choice.hint.empty()) << choice.name;
}

/// Dialogs sort by headings, and leave a heading alone when all below it is folded.
TYPED_TEST(ParameterTable, EveryHeadingHasARowThatIsNeverFolded) {
  std::map<std::string, bool> shown;
  for (const auto& row : TypeParam::parameters())
    shown[row.place.heading] |= row.place.audience == Audience::Everyone;
  for (const auto& [heading, has_row] : shown) EXPECT_TRUE(has_row) << heading;
}

/// MeshLab 2020.09 has them: its dialogs neither unfold nor scroll.
TYPED_TEST(ParameterTable, FlatDialogsAreLowAndHaveEveryParameter) {
  constexpr std::size_t most_rows = 17;
  std::set<std::string> names, all, menu_names;
  for (const FlatDialog& dialog : flat_dialogs(table_of<TypeParam>())) {
    EXPECT_LE(dialog.parameters.size(), most_rows) << dialog.menu_name;
    EXPECT_TRUE(menu_names.insert(dialog.menu_name).second) << dialog.menu_name;
    for (const Parameter& parameter : dialog.parameters) names.insert(parameter.name);
  }
  for (const auto& row : TypeParam::parameters()) all.insert(row.name);
  EXPECT_EQ(names, all);
}

bool asks_for(const FlatDialog& dialog, const std::string& name) {
  return std::any_of(dialog.parameters.begin(), dialog.parameters.end(),
                     [&](const Parameter& each) { return each.name == name; });
}

TEST(FlatDialogs, AllHaveTheTargetAndThePreset) {
  const std::vector<FlatDialog> dialogs = flat_dialogs(table_of<EdgeCollapseFilter>());
  ASSERT_EQ(dialogs.size(), 3u);
  for (const char* name : {"TargetFaceNum", "Preset"})
    for (const FlatDialog& dialog : dialogs)
      EXPECT_TRUE(asks_for(dialog, name)) << dialog.menu_name;
}

/// A dialog that has no parameter of its own has no use.
TYPED_TEST(ParameterTable, EveryFlatDialogHasAParameterOfItsOwn) {
  std::map<std::string, int> dialogs_with;
  const std::vector<FlatDialog> dialogs = flat_dialogs(table_of<TypeParam>());
  for (const FlatDialog& dialog : dialogs)
    for (const Parameter& each : dialog.parameters) ++dialogs_with[each.name];
  for (const FlatDialog& dialog : dialogs)
    EXPECT_TRUE(std::any_of(dialog.parameters.begin(), dialog.parameters.end(),
                            [&](const Parameter& each) { return dialogs_with[each.name] == 1; }))
        << dialog.menu_name;
}

/// With all that parts, shells and their materials may need at the same time.
TEST(FlatDialogs, OfAssembliesKeepPartsApart) {
  for (const FilterTable& table :
       {table_of<EdgeCollapseFilter>(), table_of<AlgebraicSphereFilter>()}) {
    const FlatDialog assemblies = flat_dialogs(table).back();
    for (const char* name : {"PreventIntersections", "TargetPerc", "MaxError", "Selected",
                             "PreserveTopology", "JoinBorders", "KeepBordersOf"})
      EXPECT_TRUE(asks_for(assemblies, name)) << name;
  }
}

/// MeshLab 2020.09 gives a text that it breaks itself less height than it takes, but for two lines.
TYPED_TEST(ParameterTable, TextsFitTheDialog) {
  constexpr std::size_t characters_a_line = 36;
  for (const auto& row : TypeParam::parameters()) {
    const auto lines = visible_lines(dialog_help(row));
    for (const std::string& line : lines)
      EXPECT_LE(line.size(), (lines.size() == 1 ? 2 : 1) * characters_a_line) << line;
  }
}

TYPED_TEST(ParameterTable, EveryDefaultIsTheCoresAndInRange) {
  const typename TypeParam::Params params;
  for (const auto& row : TypeParam::parameters()) {
    EXPECT_EQ(refusal<TypeParam>(row.name, default_value(row, {})), "");
    const auto assigned = with<TypeParam>(row.name, row.fixed_default);
    EXPECT_EQ(differences(assigned, params), std::set<std::string>()) << row.name;
  }
}

TYPED_TEST(ParameterTable, AValueReachesItsMemberOnly) {
  const typename TypeParam::Params params;
  for (const auto& row : TypeParam::parameters()) {
    const auto assigned = with<TypeParam>(row.name, another_value(row));
    EXPECT_EQ(differences(assigned, params), std::set<std::string>{row.field}) << row.name;
  }
}

TYPED_TEST(ParameterTable, AChoiceIsTheConstantOfItsName) {
  for_each_field<typename TypeParam::Params>([](const auto& field) {
    if constexpr (std::is_enum_v<
                      std::decay_t<decltype(typename TypeParam::Params().*field.member)>>)
      for (const auto& row : TypeParam::parameters())
        for (std::size_t i = 0; row.field == field.name && i < row.choices.size(); ++i) {
          const auto params = with<TypeParam>(row.name, static_cast<int>(i));
          EXPECT_EQ(label_of(params.*field.member), row.choices[i].name) << row.name;
        }
  });
}

/// PreserveNormal of preserve_normal
std::string in_camel_case(const std::string& field) {
  std::string name;
  bool capital = true;
  for (const char c : field) {
    if (c != '_') name += capital ? static_cast<char>(std::toupper(c)) : c;
    capital = c == '_';
  }
  return name;
}

/// The names that users know are the core's, but for four that are as in MeshLab's own filters.
TYPED_TEST(ParameterTable, NamesAreTheCoresOrMeshLabs) {
  const std::map<std::string, std::string> meshlabs = {{"target_faces", "TargetFaceNum"},
                                                       {"target_vertices", "TargetVertNum"},
                                                       {"target_fraction", "TargetPerc"},
                                                       {"selected_only", "Selected"}};
  for (const auto& row : TypeParam::parameters()) {
    const auto known = meshlabs.find(row.field);
    EXPECT_EQ(row.name, known == meshlabs.end() ? in_camel_case(row.field) : known->second);
  }
}

TYPED_TEST(ParameterTable, RefusesWhatIsNotFinite) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const auto& row : TypeParam::parameters()) {
    if (row.kind != Kind::Float && row.kind != Kind::Length) continue;
    for (double number : {std::nan(""), infinity, -infinity})
      EXPECT_EQ(refusal<TypeParam>(row.name, number).find(row.name + " is "), 0u) << number;
  }
}

TYPED_TEST(ParameterTable, RefusesANumberThatIsNoChoice) {
  for (const auto& row : TypeParam::parameters()) {
    if (row.kind != Kind::Enum) continue;
    for (int number : {-1, static_cast<int>(row.choices.size())})
      EXPECT_EQ(refusal<TypeParam>(row.name, number).find(row.name + " is "), 0u) << number;
  }
}

TEST(Refusal, NamesParameterValueAndRange) {
  const auto refused = refusal<EdgeCollapseFilter>;
  EXPECT_EQ(refused("TargetFaceNum", -1),
            "TargetFaceNum is -1; it must be at least 0 faces. The mesh was not changed.");
  EXPECT_EQ(
      refused("NormalAngle", 0.0),
      "NormalAngle is 0; it must be above 0 and at most 180 degrees. The mesh was not changed.");
  EXPECT_EQ(refused("Threads", -1),
            "Threads is -1; it must be at least 0 threads. The mesh was not changed.");
  EXPECT_EQ(refused("Metric", 3),
            "Metric is 3; it must be one of Quadric, CurvatureWeighted, CurvatureAdditive. The "
            "mesh was not changed.");
  EXPECT_NE(refused("TargetPerc", 1.01), "");
  EXPECT_NE(refused("MaxError", -0.1), "");
  EXPECT_EQ(refused("NormalAngle", 180.0), "");
  EXPECT_EQ(refused("TargetPerc", 1.0), "");
}

/// A message of the core as users of the edge collapse read it.
std::string translated(const std::string& message, const std::vector<std::string>& fields) {
  const auto parameters = table_of<EdgeCollapseFilter>().parameters;
  return in_names_of(parameters, InputError(message, fields), script_name).what();
}

TEST(Refusal, HasTheLabelOfADialogWithTheNameInScripts) {
  const auto parameters = table_of<EdgeCollapseFilter>().parameters;
  const InputError error("max_error is -1.", {"max_error"});
  EXPECT_STREQ(in_names_of(parameters, error, name_in_dialog).what(),
               "'Maximum error' (MaxError) is -1.");
}

TEST(Refusal, HasTheHostsNamesForWholeWordsOfTheListedFields) {
  EXPECT_EQ(translated("pair_distance and max_error contradict: set max_error to 0.",
                       {"pair_distance", "max_error"}),
            "PairDistance and MaxError contradict: set MaxError to 0.");
  EXPECT_EQ(translated("max_error_2 and a_max_error are others; max_error", {"max_error"}),
            "max_error_2 and a_max_error are others; MaxError");
  EXPECT_EQ(translated("max_error is not listed", {}), "max_error is not listed");
  EXPECT_EQ(translated("unknown is no parameter", {"unknown"}), "unknown is no parameter");
}

TEST(Refusal, KeepsTheListOfNames) {
  const auto parameters = table_of<EdgeCollapseFilter>().parameters;
  const InputError error("alpha and unknown", {"alpha", "unknown"});
  EXPECT_EQ(in_names_of(parameters, error, script_name).fields,
            (std::vector<std::string>{"Alpha", "unknown"}));
}

template <class F>
void expect_stepwise_defaults() {
  const auto target = row_of<F>("TargetFaceNum");
  const auto selected = row_of<F>("Selected");
  EXPECT_EQ(default_value(target, {1001, 0, 1.0}), Value(500));
  EXPECT_EQ(default_value(target, {1001, 20, 1.0}), Value(10));
  EXPECT_EQ(default_value(selected, {1001, 0, 1.0}), Value(false));
  EXPECT_EQ(default_value(selected, {1001, 20, 1.0}), Value(true));
}

TEST(MeshDefaults, FollowTheMesh) {
  expect_stepwise_defaults<EdgeCollapseFilter>();
  expect_stepwise_defaults<AlgebraicSphereFilter>();
  expect_stepwise_defaults<VertexRemovalFilter>();
  const auto size = row_of<VertexClusteringFilter>("CellSize");
  EXPECT_EQ(default_value(size, {1001, 0, 3.0}), Value(0.03));
  EXPECT_EQ(default_value(size, {1001, 0, std::nan("")}), Value(0.0));
  EXPECT_EQ(default_value(row_of<VertexClusteringFilter>("TargetFaceNum"), {1001, 0, 3.0}),
            Value(0));
}

TEST(PythonName, IsInLowerCaseAndNoKeyword) {
  EXPECT_EQ(python_name(row_of<EdgeCollapseFilter>("TargetFaceNum")), "targetfacenum");
  EXPECT_EQ(python_name(row_of<EdgeCollapseFilter>("Lambda")), "lambda_");
}

}  // namespace
