// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "filter_curvdecim/filter_parameters.h"
#include "vcg_ext/errors.h"

namespace {

using namespace curvdecim;

constexpr FilterId collapse = FilterId::CurvatureEdgeCollapse;
constexpr FilterId sphere = FilterId::AlgebraicSphere;
constexpr FilterId importance = FilterId::CurvatureImportance;

const Parameter& row(const std::string& name, FilterId filter) {
  for (const Parameter* parameter : parameters_of(filter))
    if (parameter->name == name) return *parameter;
  throw std::out_of_range("no parameter " + name);
}

Settings with(FilterId filter, const std::string& name, const Value& value) {
  Settings settings;
  assign(settings, filter, row(name, filter), value);
  return settings;
}

/// The settings with an enum parameter at the value of this name.
Settings choosing(const std::string& name, const std::string& choice, FilterId filter = collapse) {
  const auto& values = row(name, filter).values;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i].name == choice) return with(filter, name, static_cast<int>(i));
  throw std::out_of_range(name + " has no value " + choice);
}

std::string refusal(const std::string& name, const Value& value) {
  try {
    with(collapse, name, value);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ParameterTable, HasUniqueNamesInEveryFilter) {
  for (const FilterText& text : filter_texts()) {
    std::set<std::string> names;
    for (const Parameter* parameter : parameters_of(text.id))
      EXPECT_TRUE(names.insert(parameter->name).second) << text.menu_name << parameter->name;
  }
}

TEST(ParameterTable, HasTexts) {
  for (const Parameter& parameter : parameter_table()) {
    EXPECT_FALSE(parameter.label.empty()) << parameter.name;
    EXPECT_FALSE(parameter.help.empty()) << parameter.name;
    for (const Binding& binding : parameter.bindings)
      EXPECT_FALSE(dialog_help(parameter, binding.filter).empty()) << parameter.name;
    EXPECT_EQ(parameter.kind == Kind::Enum, !parameter.values.empty()) << parameter.name;
    EXPECT_FALSE(parameter.bindings.empty()) << parameter.name;
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

/// MeshLab 2020.09 gives a text that it breaks itself less height than it takes, but for two lines.
TEST(ParameterTable, TextsFitTheDialog) {
  constexpr std::size_t characters_a_line = 36;
  for (const Parameter& parameter : parameter_table())
    for (const Binding& binding : parameter.bindings) {
      const auto lines = visible_lines(dialog_help(parameter, binding.filter));
      for (const std::string& line : lines)
        EXPECT_LE(line.size(), (lines.size() == 1 ? 2 : 1) * characters_a_line) << line;
    }
}

TEST(ParameterTable, EveryFilterHasTexts) {
  for (const FilterText& text : filter_texts()) {
    EXPECT_FALSE(parameters_of(text.id).empty()) << text.menu_name;
    EXPECT_NE(text.info.find("<br>See:<br>"), std::string::npos) << text.menu_name;
  }
}

TEST(ParameterTable, EveryDefaultIsInRangeAndOfItsKind) {
  for (const FilterText& text : filter_texts())
    for (const Parameter* parameter : parameters_of(text.id)) {
      Settings settings;
      EXPECT_NO_THROW(assign(settings, text.id, *parameter, default_value(*parameter, text.id, {})))
          << parameter->name;
    }
}

TEST(ParameterTable, EnumValuesAreInTheOrderOfTheCore) {
  EXPECT_EQ(choosing("Metric", "Quadric").edge_collapse.metric, Metric::Quadric);
  EXPECT_EQ(choosing("Metric", "CurvatureWeighted").edge_collapse.metric,
            Metric::CurvatureWeighted);
  EXPECT_EQ(choosing("Metric", "CurvatureAdditive").edge_collapse.metric,
            Metric::CurvatureAdditive);
  EXPECT_EQ(choosing("Preset", "Fast").edge_collapse.preset, Preset::Fast);
  EXPECT_EQ(choosing("Preset", "Balanced").edge_collapse.preset, Preset::Balanced);
  EXPECT_EQ(choosing("Preset", "Best").edge_collapse.preset, Preset::Best);
  EXPECT_EQ(choosing("Preset", "Custom").edge_collapse.preset, Preset::Custom);
  EXPECT_EQ(choosing("AlphaUnits", "ScaleFree").edge_collapse.alpha_units, AlphaUnits::ScaleFree);
  EXPECT_EQ(choosing("AlphaUnits", "ModelUnits").edge_collapse.alpha_units, AlphaUnits::ModelUnits);
  EXPECT_EQ(choosing("CurvatureKind", "Gaussian").edge_collapse.curvature_kind,
            CurvatureKind::Gaussian);
  EXPECT_EQ(choosing("CurvatureKind", "Absolute").edge_collapse.curvature_kind,
            CurvatureKind::Absolute);
  EXPECT_EQ(choosing("CurvatureTerm", "Melax").edge_collapse.curvature_term, CurvatureTerm::Melax);
  EXPECT_EQ(choosing("CurvatureTerm", "Literal").edge_collapse.curvature_term,
            CurvatureTerm::Literal);
  EXPECT_EQ(choosing("Quadrics", "Memoryless").edge_collapse.quadrics, Quadrics::Memoryless);
  EXPECT_EQ(choosing("Quadrics", "Accumulated").edge_collapse.quadrics, Quadrics::Accumulated);
  EXPECT_EQ(choosing("PlaneWeight", "Area").edge_collapse.plane_weight, PlaneWeight::Area);
  EXPECT_EQ(choosing("PlaneWeight", "Unit").edge_collapse.plane_weight, PlaneWeight::Unit);
  EXPECT_EQ(choosing("Placement", "Optimal").edge_collapse.placement, Placement::Optimal);
  EXPECT_EQ(choosing("Placement", "Line").edge_collapse.placement, Placement::Line);
  EXPECT_EQ(choosing("Placement", "EndpointOrMidpoint").edge_collapse.placement,
            Placement::EndpointOrMidpoint);
  EXPECT_EQ(choosing("Placement", "HalfEdge").edge_collapse.placement, Placement::HalfEdge);
  EXPECT_EQ(choosing("Scheduler", "Lazy").edge_collapse.scheduler, Scheduler::Lazy);
  EXPECT_EQ(choosing("Scheduler", "Eager").edge_collapse.scheduler, Scheduler::Eager);
  EXPECT_EQ(choosing("Energy", "Squared", sphere).sphere.energy, SphereEnergy::Squared);
  EXPECT_EQ(choosing("Energy", "Poster", sphere).sphere.energy, SphereEnergy::Poster);
  EXPECT_EQ(choosing("Placement", "Free3D", sphere).sphere.placement, SpherePlacement::Free3D);
  EXPECT_EQ(choosing("Placement", "OnSphereAlongEdge", sphere).sphere.placement,
            SpherePlacement::OnSphereAlongEdge);
  EXPECT_FALSE(choosing("Output", "Curvature", importance).importance.as_factor);
  EXPECT_TRUE(choosing("Output", "Factor", importance).importance.as_factor);
}

TEST(ParameterTable, ValuesReachTheirMemberOnly) {
  EXPECT_EQ(with(collapse, "TargetFaceNum", 7).edge_collapse.target_faces, 7);
  EXPECT_EQ(with(collapse, "TargetVertNum", 7).edge_collapse.target_vertices, 7);
  EXPECT_EQ(with(collapse, "TargetPerc", 0.7).edge_collapse.target_fraction, 0.7);
  EXPECT_EQ(with(collapse, "MaxError", 0.7).edge_collapse.max_error, 0.7);
  EXPECT_EQ(with(collapse, "BoundaryWeight", 0.7).edge_collapse.boundary_weight, 0.7);
  EXPECT_EQ(with(collapse, "NormalAngle", 7.0).edge_collapse.normal_angle, 7.0);
  EXPECT_EQ(with(collapse, "FeatureAngle", 7.0).edge_collapse.feature_angle, 7.0);
  EXPECT_EQ(with(collapse, "Lambda", 0.7).edge_collapse.lambda, 0.7);
  EXPECT_EQ(with(collapse, "Threads", 7).edge_collapse.threads, 7);
  EXPECT_EQ(with(collapse, "RefineSweeps", 7).edge_collapse.refine_sweeps, 7);
  EXPECT_FALSE(with(collapse, "PreserveBoundary", false).edge_collapse.preserve_boundary);
  EXPECT_FALSE(with(collapse, "PreserveNormal", false).edge_collapse.preserve_normal);
  EXPECT_FALSE(with(collapse, "PreserveTopology", false).edge_collapse.preserve_topology);
  EXPECT_TRUE(with(collapse, "Selected", true).edge_collapse.selected_only);
  EXPECT_TRUE(with(collapse, "QualityWeight", true).edge_collapse.quality_weight);
  EXPECT_EQ(with(sphere, "KernelScale", 3.0).sphere.kernel_scale, 3.0);
  EXPECT_FALSE(with(sphere, "AdaptiveKernel", false).sphere.adaptive_kernel);
  EXPECT_EQ(with(sphere, "RefineSweeps", 7).sphere.refine_sweeps, 7);
  EXPECT_EQ(with(sphere, "TargetFaceNum", 7).sphere.target_faces, 7);
  EXPECT_EQ(with(sphere, "TargetFaceNum", 7).edge_collapse.target_faces,
            DecimationParams::no_target);
  const Settings settings = with(importance, "Alpha", 0.7);
  EXPECT_EQ(settings.importance.alpha, 0.7);
  EXPECT_EQ(settings.edge_collapse.alpha, CurvatureParams().alpha);
}

TEST(ParameterTable, RefusesNumbersOutOfRangeByNameValueAndRange) {
  EXPECT_EQ(refusal("TargetFaceNum", -1),
            "TargetFaceNum is -1; it must be at least 0 faces. The mesh was not changed.");
  EXPECT_EQ(
      refusal("NormalAngle", 0.0),
      "NormalAngle is 0; it must be above 0 and at most 180 degrees. The mesh was not changed.");
  EXPECT_NE(refusal("TargetPerc", 1.01), "");
  EXPECT_NE(refusal("MaxError", -0.1), "");
  EXPECT_NE(refusal("Metric", 3), "");
  EXPECT_NE(refusal("Metric", -1), "");
  EXPECT_EQ(refusal("NormalAngle", 180.0), "");
  EXPECT_EQ(refusal("TargetPerc", 1.0), "");
}

TEST(ParameterTable, RefusesWhatIsNotFinite) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const Parameter* parameter : parameters_of(collapse)) {
    if (parameter->kind != Kind::Float && parameter->kind != Kind::Length) continue;
    for (double number : {std::nan(""), infinity, -infinity})
      EXPECT_NE(refusal(parameter->name, number), "") << parameter->name << " = " << number;
  }
}

TEST(ParameterTable, DefaultsFollowTheMesh) {
  for (FilterId filter : {collapse, sphere}) {
    EXPECT_EQ(default_value(row("TargetFaceNum", filter), filter, {1001, 0, 1.0}), Value(500));
    EXPECT_EQ(default_value(row("TargetFaceNum", filter), filter, {1001, 20, 1.0}), Value(10));
    EXPECT_EQ(default_value(row("Selected", filter), filter, {1001, 0, 1.0}), Value(false));
    EXPECT_EQ(default_value(row("Selected", filter), filter, {1001, 20, 1.0}), Value(true));
  }
}

}  // namespace
