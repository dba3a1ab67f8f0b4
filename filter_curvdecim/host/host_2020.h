// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "filter_curvdecim/host/host_api.h"

/// The plugin as MeshLab and meshlabserver 2020.09 load it.
class FilterCurvDecimPlugin : public QObject, public MeshFilterInterface {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(MESH_FILTER_INTERFACE_IID)
  Q_INTERFACES(MeshFilterInterface)

 public:
  FilterCurvDecimPlugin();

  QString pluginName() const override;
  QString filterName(FilterIDType id) const override;
  QString filterInfo(FilterIDType id) const override;
  QString filterScriptFunctionName(FilterIDType id) override;
  FilterClass getClass(QAction* action) override;
  FILTER_ARITY filterArity(QAction* action) const override;
  int getPreConditions(QAction* action) const override;
  int postCondition(QAction* action) const override;
  void initParameterSet(QAction* action, MeshDocument& document,
                        RichParameterList& parameters) override;
  bool applyFilter(QAction* action, MeshDocument& document, const RichParameterList& parameters,
                   vcg::CallBackPos* callback) override;
};
