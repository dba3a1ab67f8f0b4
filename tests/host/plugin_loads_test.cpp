// SPDX-License-Identifier: GPL-3.0-or-later
// The built plugin, loaded and driven as a host does it. Compiled once for each host whose library
// is on this machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <vcg/complex/algorithms/create/platonic.h>
#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/algorithms/update/normal.h>
#include <vcg/complex/algorithms/update/selection.h>

#include "filter_curvdecim/filters/all_filters.h"
#include "filter_curvdecim/host/host_api.h"
#include "filter_curvdecim/table/flat_dialogs.h"
#include "plugin_driver.h"

namespace curvdecim::glue {

/// How GoogleTest names the instances.
void PrintTo(const FilterTable& filter, std::ostream* out) { *out << filter.about.python_name; }

}  // namespace curvdecim::glue

namespace {

using namespace curvdecim::glue;

/// A sphere of 20 * 4^4 = 5120 faces: long enough for a run to ask more than once whether to stop.
constexpr int subdivisions = 4;
constexpr int sphere_faces = 5120;

bool always_go_on(const int, const char*) { return true; }
bool stop_at_once(const int, const char*) { return false; }
bool stop_late(const int percent, const char*) { return percent < 30; }

/// Everything of a mesh that a filter could change, to be compared bit by bit.
std::string bits_of(const MeshModel& mesh) {
  std::string bits;
  const auto add = [&bits](const auto& value) {
    bits.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const auto& v : mesh.cm.vert)
    add(v.cP()), add(v.cN()), add(v.cC()), add(v.cQ()), add(v.cFlags());
  for (const auto& f : mesh.cm.face) {
    for (int i = 0; i < 3; ++i) add(f.cV(i) - mesh.cm.vert.data());
    add(f.cN()), add(f.cFlags());
  }
  add(mesh.cm.vn), add(mesh.cm.fn), add(mesh.cm.bbox), add(mesh.dataMask());
  return bits;
}

class LoadedFilter : public testing::Test {
 protected:
  explicit LoadedFilter(FilterTable filter) : filter_(std::move(filter)) {}

  void SetUp() override {
    plugin_ = load_plugin();
    ASSERT_NE(plugin_, nullptr);
    action_ = find_action(*plugin_, filter_.about.menu_name);
    ASSERT_NE(action_, nullptr) << filter_.about.menu_name;
    mesh_ = add_sphere(true);
    if (compares_layers()) add_sphere(false);
    plugin_->setLog(&log_);
  }

  MeshModel* add_sphere(bool current) {
    MeshModel* const mesh = document_.addNewMesh("", "sphere", current);
    vcg::tri::Sphere(mesh->cm, subdivisions);
    vcg::tri::UpdateNormal<CMeshO>::PerFaceNormalized(mesh->cm);
    vcg::tri::UpdateNormal<CMeshO>::PerVertexAngleWeighted(mesh->cm);
    vcg::tri::UpdateBounding<CMeshO>::Box(mesh->cm);
    return mesh;
  }

  bool compares_layers() const {
    return std::any_of(filter_.parameters.begin(), filter_.parameters.end(),
                       [](const Parameter& each) { return each.kind == Kind::Layer; });
  }

  RichParameterList defaults() { return default_parameters(*plugin_, action_, document_); }

  std::string run(const RichParameterList& parameters, vcg::CallBackPos* callback = always_go_on) {
    return run_filter(*plugin_, action_, document_, parameters, callback);
  }

  std::string log_text() const {
    QStringList lines;
    log_.print(lines);
    return lines.join("\n").toStdString();
  }

  const FilterTable filter_;
  HostFilter* plugin_ = nullptr;
  QAction* action_ = nullptr;
  MeshDocument document_;
  MeshModel* mesh_ = nullptr;
  GLLogStream log_;
};

class AnyFilter : public LoadedFilter, public testing::WithParamInterface<FilterTable> {
 protected:
  AnyFilter() : LoadedFilter(GetParam()) {}
};

class EdgeCollapse : public LoadedFilter {
 protected:
  EdgeCollapse() : LoadedFilter(table_of<EdgeCollapseFilter>()) {}
};

class Importance : public LoadedFilter {
 protected:
  Importance() : LoadedFilter(table_of<CurvatureImportanceFilter>()) {}
};

/// The list of a script that gives one parameter and leaves the others out.
RichParameterList only(const RichParameter& parameter) {
  RichParameterList list;
  list.addParam(parameter);
  return list;
}

QString name_of(const Parameter& parameter) { return QString::fromStdString(parameter.name); }

/// The entries of this host's menu for a filter, that for daily use first.
std::vector<FlatDialog> offered(const FilterTable& filter) {
  if (!dialogs_unfold) return flat_dialogs(filter);
  return {{filter.about.menu_name, filter.about.python_name, filter.parameters}};
}

/// As the users of this host know it.
std::string shown_name(const Parameter& parameter) {
  constexpr bool is_python = std::is_same_v<CMeshO::ScalarType, double>;
  return is_python ? python_name(parameter) : name_in_dialog(parameter);
}

TEST(Plugin, HasTheActionsOfTheListInItsOrder) {
  HostFilter* const plugin = load_plugin();
  ASSERT_NE(plugin, nullptr);
  std::vector<std::string> names, actions;
  for (const FilterTable& filter : AllFilters::tables())
    for (const FlatDialog& dialog : offered(filter)) names.push_back(dialog.menu_name);
  for (const QAction* action : plugin->actions()) actions.push_back(action->text().toStdString());
  EXPECT_EQ(actions, names);
}

TEST_P(AnyFilter, DeclaresWhatTheLoaderChecks) {
  EXPECT_NE(plugin_->getClass(action_), HostFilter::Generic);
  EXPECT_NE(plugin_->getRequirements(action_), int(MeshModel::MM_UNKNOWN));
  EXPECT_EQ(plugin_->getPreConditions(action_), int(MeshModel::MM_FACENUMBER));
  EXPECT_NE(plugin_->postCondition(action_), int(MeshModel::MM_UNKNOWN));
  EXPECT_EQ(plugin_->filterArity(action_),
            compares_layers() ? HostFilter::FIXED : HostFilter::SINGLE_MESH);
  EXPECT_TRUE(plugin_->filterInfo(action_).contains("<br>See: "));
}

TEST_P(AnyFilter, OffersItsRowsOfTheTableWithLabelAndHelp) {
  const RichParameterList list = defaults();
  const auto rows = offered(filter_).front().parameters;
  ASSERT_EQ(list.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(list.at(i).name().toStdString(), rows[i].name);
    EXPECT_EQ(list.at(i).fieldDescription().toStdString(), rows[i].label);
    EXPECT_EQ(list.at(i).toolTip().toStdString(), dialog_help(rows[i]));
  }
}

TEST_P(AnyFilter, HasDefaultsForAnEmptyMeshAndForNone) {
  mesh_->cm.Clear();
  const std::size_t rows = offered(filter_).front().parameters.size();
  EXPECT_EQ(defaults().size(), rows);
  MeshDocument nothing;
  const RichParameterList list = default_parameters(*plugin_, action_, nothing);
  EXPECT_EQ(list.size(), rows);
  EXPECT_NE(run_filter(*plugin_, action_, nothing, list, nullptr), "");
}

TEST_P(AnyFilter, RefusesAnEmptyMesh) {
  mesh_->cm.Clear();
  EXPECT_NE(run(defaults()), "");
}

TEST_P(AnyFilter, LeavesTheMeshAsItWasWhenToldToStop) {
  mesh_->updateDataMask(MeshModel::MM_FACEFACETOPO | MeshModel::MM_VERTFACETOPO);
  const std::string before = bits_of(*mesh_);
  EXPECT_EQ(run(defaults(), stop_at_once), "");
  EXPECT_EQ(bits_of(*mesh_), before);
  EXPECT_TRUE(mesh_->hasDataMask(MeshModel::MM_FACEFACETOPO | MeshModel::MM_VERTFACETOPO));
  EXPECT_NE(log_text().find("stopped_by: cancelled"), std::string::npos) << log_text();
}

TEST_P(AnyFilter, RunsWithoutCallback) { EXPECT_EQ(run(defaults(), nullptr), ""); }

TEST_P(AnyFilter, RunsWithEveryChoiceOfEveryEnum) {
  for (const Parameter& parameter : filter_.parameters)
    for (int choice = 0; choice < static_cast<int>(parameter.choices.size()); ++choice)
      EXPECT_EQ(run(only(RichEnum(name_of(parameter), choice, {}))), "")
          << parameter.name << " = " << parameter.choices[choice].name;
}

TEST_P(AnyFilter, RunsWithEveryBoolOnAndOff) {
  vcg::tri::UpdateSelection<CMeshO>::FaceAll(mesh_->cm);
  for (const Parameter& parameter : filter_.parameters) {
    if (parameter.kind != Kind::Bool) continue;
    for (bool on : {false, true})
      EXPECT_EQ(run(only(RichBool(name_of(parameter), on))), "") << parameter.name;
  }
}

/// The parameter with a value that no range contains; it is not a Bool.
RichParameterList invalid(const Parameter& parameter) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr int least = std::numeric_limits<int>::min();
  switch (parameter.kind) {
    case Kind::Float: return only(RichFloat(name_of(parameter), nan));
    case Kind::Length: return only(RichLength(name_of(parameter), nan, 0, 1));
    case Kind::Enum: return only(RichEnum(name_of(parameter), least, {}));
    default: return only(RichInt(name_of(parameter), least));
  }
}

TEST_P(AnyFilter, RefusesWhatIsOutOfRangeByNameAndLeavesTheMesh) {
  const std::string before = bits_of(*mesh_);
  for (const Parameter& parameter : filter_.parameters) {
    if (parameter.kind == Kind::Bool) continue;
    EXPECT_EQ(run(invalid(parameter)).find(shown_name(parameter) + " is "), 0u) << parameter.name;
    EXPECT_EQ(bits_of(*mesh_), before) << parameter.name;
  }
}

TEST_P(AnyFilter, RefusesAValueOfAnotherType) {
  const Parameter& first = filter_.parameters.front();
  const std::string error = run(only(RichString(name_of(first), "many")));
  EXPECT_EQ(error.find(first.name + " is given as String"), 0u) << error;
}

TEST_P(AnyFilter, LogsItsResultsInTheOrderOfTheTable) {
  EXPECT_EQ(run(defaults()), "");
  const std::string log = "\n" + log_text();
  std::vector<std::size_t> places;
  for (const ResultText& result : filter_.results)
    if (const auto at = log.find("\n" + result.name + ": "); at != std::string::npos)
      places.push_back(at);
  EXPECT_GE(places.size(), 3u) << log;
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end())) << log;
}

TEST_P(AnyFilter, TakesDefaultsForWhatAScriptLeavesOut) { EXPECT_EQ(run(RichParameterList()), ""); }

INSTANTIATE_TEST_SUITE_P(Filters, AnyFilter, testing::ValuesIn(AllFilters::tables()),
                         [](const auto& each) { return each.param.about.python_name; });

TEST_F(EdgeCollapse, HalvesTheFacesByDefault) {
  EXPECT_EQ(run(defaults()), "");
  EXPECT_EQ(mesh_->cm.fn, sphere_faces / 2);
  EXPECT_EQ(mesh_->cm.face.size(), sphere_faces / 2u);
}

TEST_F(EdgeCollapse, StopsMidway) {
  const std::string before = bits_of(*mesh_);
  EXPECT_EQ(run(defaults(), stop_late), "");
  EXPECT_EQ(bits_of(*mesh_), before);
  EXPECT_NE(log_text().find("stopped_by: cancelled"), std::string::npos) << log_text();
}

TEST_F(EdgeCollapse, DropsAdjacencyAndUpdatesNormalsAndCounters) {
  mesh_->updateDataMask(MeshModel::MM_FACEFACETOPO | MeshModel::MM_VERTFACETOPO);
  vcg::tri::UpdateSelection<CMeshO>::FaceAll(mesh_->cm);
  EXPECT_EQ(run(defaults()), "");
  EXPECT_FALSE(mesh_->hasDataMask(MeshModel::MM_FACEFACETOPO));
  EXPECT_FALSE(mesh_->hasDataMask(MeshModel::MM_VERTFACETOPO));
  EXPECT_EQ(mesh_->cm.sfn, mesh_->cm.fn);
  for (const auto& face : mesh_->cm.face)
    EXPECT_GT(face.cN() * vcg::TriangleNormal(face).Normalize(), 0.9999);
}

TEST_F(EdgeCollapse, ReadsADecimalFractionExactly) {
  // 0.7 as float is less than 0.7: cut down to an int, that would be a face short.
  EXPECT_EQ(run(only(RichFloat("TargetPerc", 0.7f))), "");
  EXPECT_EQ(mesh_->cm.fn, sphere_faces * 7 / 10);
}

TEST_F(EdgeCollapse, HasTheSameDefaultsAfterOtherCalls) {
  EXPECT_EQ(run(only(RichFloat("NormalAngle", 10))), "");
  EXPECT_EQ(defaults().getParameterByName("NormalAngle").value().getFloat(), 90);
}

TEST_F(EdgeCollapse, LeavesAMeshThatIsSmallEnoughToTheBit) {
  const std::string before = bits_of(*mesh_);
  EXPECT_EQ(run(only(RichInt("TargetFaceNum", sphere_faces))), "");
  EXPECT_EQ(bits_of(*mesh_), before);
}

TEST_F(Importance, WritesTheCurvatureOfASphere) {
  constexpr double curvature = 2.0;  // |k1| + |k2| of a sphere of radius 1
  constexpr double tolerance = 0.3;  // the twelve vertices of five faces are off by 15 %
  EXPECT_EQ(run(defaults()), "");
  for (const auto& vertex : mesh_->cm.vert) EXPECT_NEAR(vertex.cQ(), curvature, tolerance);
}

}  // namespace
