// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/host/host_2020.h"

#include "filter_curvdecim/host/actions.h"

namespace glue = curvdecim::glue;

FilterCurvDecimPlugin::FilterCurvDecimPlugin() {
  for (std::size_t number = 0; number < glue::actions().size(); ++number) {
    typeList.append(static_cast<FilterIDType>(number));
    actionList.append(new QAction(filterName(typeList.last()), this));
  }
}

QString FilterCurvDecimPlugin::pluginName() const { return "FilterCurvDecim"; }

QString FilterCurvDecimPlugin::filterName(FilterIDType id) const {
  return QString::fromStdString(glue::action_of(id).about.menu_name);
}

QString FilterCurvDecimPlugin::filterInfo(FilterIDType id) const {
  return QString::fromStdString(glue::action_of(id).about.info);
}

QString FilterCurvDecimPlugin::filterScriptFunctionName(FilterIDType id) {
  return QString::fromStdString(glue::action_of(id).about.python_name);
}

MeshFilterInterface::FilterClass FilterCurvDecimPlugin::getClass(QAction* action) {
  return glue::menu_class(glue::action_of(ID(action)));
}

MeshFilterInterface::FILTER_ARITY FilterCurvDecimPlugin::filterArity(QAction* action) const {
  return glue::names_its_layers(glue::action_of(ID(action))) ? FIXED : SINGLE_MESH;
}

int FilterCurvDecimPlugin::getPreConditions(QAction*) const { return glue::precondition; }

int FilterCurvDecimPlugin::postCondition(QAction* action) const {
  return glue::postcondition(glue::action_of(ID(action)));
}

void FilterCurvDecimPlugin::initParameterSet(QAction* action, MeshDocument& document,
                                             RichParameterList& parameters) {
  parameters = glue::default_parameters(glue::action_of(ID(action)), document);
}

bool FilterCurvDecimPlugin::applyFilter(QAction* action, MeshDocument& document,
                                        const RichParameterList& parameters,
                                        vcg::CallBackPos* callback) {
  try {
    const auto outcome = glue::apply(glue::action_of(ID(action)), document, parameters, callback);
    for (const std::string& line : glue::log_lines(outcome)) Log(line);
    return true;
  } catch (const std::exception& error) {
    errorMessage = QString::fromUtf8(error.what());
    Log(std::string("Error: ") +
        error.what());  // meshlabserver prints the log, but not errorMessage
    return false;
  }
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterCurvDecimPlugin)
