// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/host/host_2022.h"

#include "filter_curvdecim/filter_curvdecim.h"

using curvdecim::filter_of;

namespace {

/// PyMeshLab drops texts and 64-bit integers. Counts fit an int, as in the hosts' meshes, and a
/// reason is its number, which the Python package turns into text.
struct AsVariant {
  QVariant operator()(std::int64_t number) const { return static_cast<int>(number); }
  QVariant operator()(double number) const { return number; }
  QVariant operator()(curvdecim::StopReason reason) const { return static_cast<int>(reason); }
};

std::map<std::string, QVariant> dictionary_of(const curvdecim::Outcome& outcome) {
  std::map<std::string, QVariant> dictionary;
  for (const curvdecim::Result& result : outcome.results)
    dictionary[result.name] = std::visit(AsVariant(), result.value);
  return dictionary;
}

}  // namespace

FilterCurvDecimPlugin::FilterCurvDecimPlugin() {
  for (const curvdecim::Filter& filter : curvdecim::filters()) {
    typeList.push_back(static_cast<ActionIDType>(filter.id));
    actionList.push_back(new QAction(filterName(typeList.back()), this));
  }
}

QString FilterCurvDecimPlugin::pluginName() const { return "FilterCurvDecim"; }

QString FilterCurvDecimPlugin::vendor() const { return "CurvDecim"; }

QString FilterCurvDecimPlugin::filterName(ActionIDType id) const {
  return QString::fromStdString(curvdecim::text_of(filter_of(id).id).menu_name);
}

QString FilterCurvDecimPlugin::pythonFilterName(ActionIDType id) const {
  return QString::fromStdString(curvdecim::text_of(filter_of(id).id).python_name);
}

QString FilterCurvDecimPlugin::filterInfo(ActionIDType id) const {
  return QString::fromStdString(curvdecim::text_of(filter_of(id).id).info);
}

FilterPlugin::FilterClass FilterCurvDecimPlugin::getClass(const QAction* action) const {
  return filter_of(ID(action)).menu_class;
}

FilterPlugin::FilterArity FilterCurvDecimPlugin::filterArity(const QAction*) const {
  return SINGLE_MESH;
}

int FilterCurvDecimPlugin::getPreConditions(const QAction* action) const {
  return filter_of(ID(action)).precondition;
}

int FilterCurvDecimPlugin::postCondition(const QAction* action) const {
  return filter_of(ID(action)).postcondition;
}

RichParameterList FilterCurvDecimPlugin::initParameterList(const QAction* action,
                                                           const MeshDocument& document) {
  return curvdecim::default_parameters(filter_of(ID(action)), document.mm());
}

std::map<std::string, QVariant> FilterCurvDecimPlugin::applyFilter(
    const QAction* action, const RichParameterList& parameters, MeshDocument& document,
    unsigned int& postConditionMask, vcg::CallBackPos* callback) {
  try {
    const auto outcome =
        curvdecim::apply(filter_of(ID(action)), document.mm(), parameters, callback);
    if (!outcome.mesh_changed) postConditionMask = MeshModel::MM_NONE;
    for (const std::string& line : curvdecim::log_lines(outcome)) log(line);
    return dictionary_of(outcome);
  } catch (const std::exception& error) {
    // PyMeshLab does this only on success; its log dies with the MeshSet, and the next call would
    // write to it.
    setLog(nullptr);
    throw MLException(QString::fromUtf8(error.what()));
  }
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterCurvDecimPlugin)
