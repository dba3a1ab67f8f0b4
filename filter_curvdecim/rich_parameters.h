// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_curvdecim/filter_parameters.h"
#include "filter_curvdecim/host/host_api.h"

namespace curvdecim {

/// The parameters of a filter for a host's dialog and scripts.
RichParameterList rich_parameters(FilterId filter, const MeshFacts& mesh);

/// Reads them back; a parameter that is not in the list has its default. Throws InputError.
Settings read_settings(FilterId filter, const RichParameterList& list, const MeshFacts& mesh);

}  // namespace curvdecim
