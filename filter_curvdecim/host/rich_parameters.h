// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filter_curvdecim/host/host_api.h"
#include "filter_curvdecim/table/parameter.h"

namespace curvdecim::glue {

/// The parameters of a filter for a host's dialog and scripts.
RichParameterList rich_parameters(const std::vector<Parameter>& parameters, const MeshFacts& mesh,
                                  const MeshDocument& document);

/// Their values in a host's list; a parameter that is not in the list has its default. Throws
/// InputError.
std::vector<Value> read_values(const std::vector<Parameter>& parameters,
                               const RichParameterList& list, const MeshFacts& mesh);

}  // namespace curvdecim::glue
