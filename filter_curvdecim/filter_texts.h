// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace curvdecim {

/// The filters of the plugin; the number is the host's id of the action.
enum class FilterId {
  CurvatureEdgeCollapse,
  CurvatureImportance,
  VertexClustering,
  VertexRemoval,
  AlgebraicSphere
};

/// The submenu of a host's Filters menu.
enum class Category { Remeshing, QualityMeasure };

struct FilterText {
  FilterId id;
  std::string menu_name;
  std::string python_name;
  Category category;
  std::string info;  ///< HTML, as hosts show it above the parameters
};

/// One row a filter, in the order of the menu.
const std::vector<FilterText>& filter_texts();

const FilterText& text_of(FilterId id);

}  // namespace curvdecim
