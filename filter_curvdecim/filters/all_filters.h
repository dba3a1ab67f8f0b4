// SPDX-License-Identifier: GPL-3.0-or-later
// The filters of the plugin. A new one gets its own file here, and a line in the list.
#pragma once

#include "filter_curvdecim/filters/algebraic_sphere.h"
#include "filter_curvdecim/filters/curvature_importance.h"
#include "filter_curvdecim/filters/edge_collapse.h"
#include "filter_curvdecim/filters/simplification_error.h"
#include "filter_curvdecim/filters/vertex_clustering.h"
#include "filter_curvdecim/filters/vertex_removal.h"
#include "filter_curvdecim/table/filter.h"

namespace curvdecim::glue {

/// In the order of the menu and of the documentation.
// clang-format off
using AllFilters = FilterList<
    EdgeCollapseFilter,
    AlgebraicSphereFilter,
    VertexRemovalFilter,
    VertexClusteringFilter,
    CurvatureImportanceFilter,
    SimplificationErrorFilter>;
// clang-format on

}  // namespace curvdecim::glue
