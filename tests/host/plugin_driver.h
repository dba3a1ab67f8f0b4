// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "filter_curvdecim/host/host_api.h"

/// Drives the plugin as its host does; one implementation for each generation of the interface.

/// The plugin in PLUGIN_FILE, loaded by Qt; null and a test failure when it cannot be loaded.
HostFilter* load_plugin();

QAction* find_action(HostFilter& plugin, const std::string& menu_name);

RichParameterList default_parameters(HostFilter& plugin, QAction* action, MeshDocument& document);

/// Runs a filter. Returns the error's message, or "" on success.
std::string run_filter(HostFilter& plugin, QAction* action, MeshDocument& document,
                       const RichParameterList& parameters, vcg::CallBackPos* callback);
