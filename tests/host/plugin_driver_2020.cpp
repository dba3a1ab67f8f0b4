// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin_driver.h"

RichParameterList default_parameters(HostFilter& plugin, QAction* action, MeshDocument& document) {
  RichParameterList parameters;
  plugin.initParameterSet(action, document, parameters);
  return parameters;
}

std::string run_filter(HostFilter& plugin, QAction* action, MeshDocument& document,
                       const RichParameterList& parameters, vcg::CallBackPos* callback) {
  return plugin.applyFilter(action, document, parameters, callback)
             ? ""
             : plugin.errorMsg().toStdString();
}
