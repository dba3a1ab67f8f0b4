// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin_driver.h"

RichParameterList default_parameters(HostFilter& plugin, QAction* action, MeshDocument& document) {
  return plugin.initParameterList(action, document);
}

std::string run_filter(HostFilter& plugin, QAction* action, MeshDocument& document,
                       const RichParameterList& parameters, vcg::CallBackPos* callback) {
  unsigned int changed = MeshModel::MM_UNKNOWN;
  try {
    plugin.applyFilter(action, parameters, document, changed, callback);
    return "";
  } catch (const MLException& error) {
    return error.what();
  }
}
