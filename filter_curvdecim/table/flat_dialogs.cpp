// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/table/flat_dialogs.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace curvdecim::glue {
namespace {

constexpr std::size_t most_rows = 16;  // of a dialog that is 720 pixels high

bool is_for_daily_use(const Parameter& parameter) {
  return parameter.place.audience != Audience::Papers;
}

bool is_for_papers(const Parameter& parameter) {
  return parameter.place.audience == Audience::Papers || parameter.place.opens_papers;
}

std::vector<Parameter> only(bool (*wanted)(const Parameter&), const FilterTable& filter) {
  std::vector<Parameter> found;
  std::copy_if(filter.parameters.begin(), filter.parameters.end(), std::back_inserter(found),
               wanted);
  return found;
}

}  // namespace

std::vector<FlatDialog> flat_dialogs(const FilterTable& filter) {
  const auto& [menu_name, python_name] = std::tie(filter.about.menu_name, filter.about.python_name);
  if (filter.parameters.size() <= most_rows) return {{menu_name, python_name, filter.parameters}};
  return {{menu_name, python_name, only(is_for_daily_use, filter)},
          {menu_name + " (Paper Settings)", python_name + "_paper", only(is_for_papers, filter)}};
}

}  // namespace curvdecim::glue
