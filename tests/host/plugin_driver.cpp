// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin_driver.h"

#include <gtest/gtest.h>

#include <QPluginLoader>

HostFilter* load_plugin() {
  QPluginLoader loader(PLUGIN_FILE);
  HostFilter* plugin = qobject_cast<HostFilter*>(loader.instance());
  EXPECT_NE(plugin, nullptr) << loader.errorString().toStdString();
  return plugin;
}

QAction* find_action(HostFilter& plugin, const std::string& menu_name) {
  for (QAction* action : plugin.actions())
    if (action->text().toStdString() == menu_name) return action;
  return nullptr;
}
