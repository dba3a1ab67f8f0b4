// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/host/host_2020.h"

#include "filter_curvdecim/filter_curvdecim.h"

using curvdecim::filter_of;

FilterCurvDecimPlugin::FilterCurvDecimPlugin() {
  for (const curvdecim::Filter& filter : curvdecim::filters()) {
    typeList.append(static_cast<FilterIDType>(filter.id));
    actionList.append(new QAction(filterName(typeList.last()), this));
  }
}

QString FilterCurvDecimPlugin::pluginName() const { return "FilterCurvDecim"; }

QString FilterCurvDecimPlugin::filterName(FilterIDType id) const {
  return QString::fromStdString(curvdecim::text_of(filter_of(id).id).menu_name);
}

QString FilterCurvDecimPlugin::filterInfo(FilterIDType id) const {
  return QString::fromStdString(curvdecim::text_of(filter_of(id).id).info);
}

QString FilterCurvDecimPlugin::filterScriptFunctionName(FilterIDType id) {
  return QString::fromStdString(curvdecim::text_of(filter_of(id).id).python_name);
}

MeshFilterInterface::FilterClass FilterCurvDecimPlugin::getClass(QAction* action) {
  return filter_of(ID(action)).menu_class;
}

MeshFilterInterface::FILTER_ARITY FilterCurvDecimPlugin::filterArity(QAction*) const {
  return SINGLE_MESH;
}

int FilterCurvDecimPlugin::getPreConditions(QAction* action) const {
  return filter_of(ID(action)).precondition;
}

int FilterCurvDecimPlugin::postCondition(QAction* action) const {
  return filter_of(ID(action)).postcondition;
}

void FilterCurvDecimPlugin::initParameterSet(QAction* action, MeshDocument& document,
                                             RichParameterList& parameters) {
  parameters = curvdecim::default_parameters(filter_of(ID(action)), document.mm());
}

bool FilterCurvDecimPlugin::applyFilter(QAction* action, MeshDocument& document,
                                        const RichParameterList& parameters,
                                        vcg::CallBackPos* callback) {
  try {
    const auto outcome =
        curvdecim::apply(filter_of(ID(action)), document.mm(), parameters, callback);
    for (const std::string& line : curvdecim::log_lines(outcome)) Log(line);
    return true;
  } catch (const std::exception& error) {
    errorMessage = QString::fromUtf8(error.what());
    Log(std::string("Error: ") +
        error.what());  // meshlabserver prints the log, but not errorMessage
    return false;
  }
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterCurvDecimPlugin)
