// SPDX-License-Identifier: GPL-3.0-or-later
// The filters as a host sees them: actions with a number, which is the place in the list.
#pragma once

#include <vector>

#include "filter_curvdecim/host/host_api.h"
#include "filter_curvdecim/table/filter.h"

namespace curvdecim::glue {

struct Action : Filter<CMeshO> {
  std::vector<Parameter> offered;  ///< in the host's dialog and scripts
};

const std::vector<Action>& actions();

const Action& action_of(int number);

HostFilter::FilterClass menu_class(const Action& action);

/// What a mesh must have; as below, a mask of MeshModel::MeshElement.
constexpr int precondition = MeshModel::MM_FACENUMBER;

/// What may have changed afterwards.
int postcondition(const Action& action);

/// True if its parameters say which layers it works on; else on the current one.
bool names_its_layers(const Action& action);

/// Parameters with defaults for this document and its current mesh, if there is one.
RichParameterList default_parameters(const Action& action, const MeshDocument& document);

/// Runs a filter; `callback` may be null. With KeepMap there is one more layer afterwards. Throws
/// InputError; the document is then as it was.
Outcome apply(const Action& action, MeshDocument& document, const RichParameterList& parameters,
              vcg::CallBackPos* callback);

}  // namespace curvdecim::glue
