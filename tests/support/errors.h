// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/mesh_types.h"
#include "support/shape.h"
#include "vcg_ext/error_params.h"
#include "vcg_ext/error_report.h"
#include "vcg_ext/report.h"

namespace curvdecim::test {

// The core's template, compiled once for all suites.
ErrorReport error_between(RichMesh& original, RichMesh& simplified, const ErrorParams& params = {},
                          const Progress& progress = {});

ErrorReport error_between(const Shape& original, const Shape& simplified,
                          const ErrorParams& params = {});  ///< double coordinates
ErrorReport error_between_float(const Shape& original, const Shape& simplified,
                                const ErrorParams& params = {});  ///< single coordinates

/// The figures of a surface by itself.
SurfaceFigures figures_of(const Shape& shape);

}  // namespace curvdecim::test
