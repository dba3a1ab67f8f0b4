// SPDX-License-Identifier: GPL-3.0-or-later
// Dialogs for hosts that show every parameter of a filter at once.
#pragma once

#include <string>
#include <vector>

#include "filter_curvdecim/table/filter.h"

namespace curvdecim::glue {

/// A filter as such a host offers it; a parameter that is left out has its default.
struct FlatDialog {
  std::string menu_name;
  std::string python_name;
  std::vector<Parameter> parameters;
};

/// One dialog, or three where one would be too high for a screen: one for daily use, one with what
/// repeats a paper, and one with what keeps the parts of an assembly apart.
std::vector<FlatDialog> flat_dialogs(const FilterTable& filter);

}  // namespace curvdecim::glue
