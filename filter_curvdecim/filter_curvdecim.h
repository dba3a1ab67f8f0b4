// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "filter_curvdecim/decimation_task.h"
#include "filter_curvdecim/filter_parameters.h"
#include "filter_curvdecim/host/host_api.h"

namespace curvdecim {

/// What a host asks of a filter besides its texts and parameters.
struct Filter {
  FilterId id;
  HostFilter::FilterClass menu_class;
  int precondition;   ///< mask of MeshModel::MeshElement
  int postcondition;  ///< mask of what may have changed afterwards
  Outcome (*run)(MeshModel&, const Settings&, const Progress&);
};

/// One row a filter, in the order of the menu.
const std::vector<Filter>& filters();

/// By the host's number of the action.
const Filter& filter_of(int id);

/// Parameters with defaults for this mesh; `mesh` may be null.
RichParameterList default_parameters(const Filter& filter, const MeshModel* mesh);

/// Runs a filter on the current mesh of the host; `callback` may be null. Throws InputError; the
/// mesh is then as it was.
Outcome apply(const Filter& filter, MeshModel* mesh, const RichParameterList& parameters,
              vcg::CallBackPos* callback);

/// The log of a run: notes first, then the results.
std::vector<std::string> log_lines(const Outcome& outcome);

}  // namespace curvdecim
