// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/host/host_2022.h"

#include "filter_curvdecim/host/actions.h"

namespace glue = curvdecim::glue;

namespace {

/// PyMeshLab drops texts and 64-bit integers. Counts fit an int, as in the hosts' meshes, and a
/// constant is its number, which the Python package turns into text.
struct AsVariant {
  QVariant operator()(std::int64_t number) const { return static_cast<int>(number); }
  QVariant operator()(double number) const { return number; }
  QVariant operator()(const glue::Constant& constant) const { return constant.number; }
};

std::map<std::string, QVariant> dictionary_of(const glue::Outcome& outcome) {
  std::map<std::string, QVariant> dictionary;
  for (const auto& [name, value] : outcome.results)
    dictionary[name] = std::visit(AsVariant(), value);
  return dictionary;
}

bool changed_anything(const glue::Outcome& outcome) {
  return outcome.changed.shape || outcome.changed.quality_and_color;
}

}  // namespace

FilterCurvDecimPlugin::FilterCurvDecimPlugin() {
  for (std::size_t number = 0; number < glue::actions().size(); ++number) {
    typeList.push_back(static_cast<ActionIDType>(number));
    actionList.push_back(new QAction(filterName(typeList.back()), this));
  }
}

QString FilterCurvDecimPlugin::pluginName() const { return "FilterCurvDecim"; }

QString FilterCurvDecimPlugin::vendor() const { return "CurvDecim"; }

QString FilterCurvDecimPlugin::filterName(ActionIDType id) const {
  return QString::fromStdString(glue::action_of(id).about.menu_name);
}

QString FilterCurvDecimPlugin::pythonFilterName(ActionIDType id) const {
  return QString::fromStdString(glue::action_of(id).about.python_name);
}

QString FilterCurvDecimPlugin::filterInfo(ActionIDType id) const {
  return QString::fromStdString(glue::action_of(id).about.info);
}

FilterPlugin::FilterClass FilterCurvDecimPlugin::getClass(const QAction* action) const {
  return glue::menu_class(glue::action_of(ID(action)));
}

FilterPlugin::FilterArity FilterCurvDecimPlugin::filterArity(const QAction* action) const {
  return glue::names_its_layers(glue::action_of(ID(action))) ? FIXED : SINGLE_MESH;
}

int FilterCurvDecimPlugin::getPreConditions(const QAction*) const { return glue::precondition; }

int FilterCurvDecimPlugin::postCondition(const QAction* action) const {
  return glue::postcondition(glue::action_of(ID(action)));
}

RichParameterList FilterCurvDecimPlugin::initParameterList(const QAction* action,
                                                           const MeshDocument& document) {
  return glue::default_parameters(glue::action_of(ID(action)), document);
}

std::map<std::string, QVariant> FilterCurvDecimPlugin::applyFilter(
    const QAction* action, const RichParameterList& parameters, MeshDocument& document,
    unsigned int& post_condition_mask, vcg::CallBackPos* callback) {
  try {
    const auto outcome = glue::apply(glue::action_of(ID(action)), document, parameters, callback);
    if (!changed_anything(outcome)) post_condition_mask = MeshModel::MM_NONE;
    for (const std::string& line : glue::log_lines(outcome)) log(line);
    return dictionary_of(outcome);
  } catch (const std::exception& error) {
    // PyMeshLab does this only on success; its log dies with the MeshSet, and the next call would
    // write to it.
    setLog(nullptr);
    throw MLException(QString::fromUtf8(error.what()));
  }
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterCurvDecimPlugin)
