// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/table/flat_dialogs.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

namespace curvdecim::glue {
namespace {

constexpr std::size_t most_rows = 16;  // of a dialog that is 720 pixels high

bool is_for_daily_use(const Parameter& parameter) {
  const Audience audience = parameter.place.audience;
  return audience == Audience::Everyone || audience == Audience::Tuning;
}

bool is_for(Audience audience, const Parameter& parameter) {
  const std::vector<Audience>& others = parameter.place.also_for;
  return parameter.place.audience == audience ||
         std::find(others.begin(), others.end(), audience) != others.end();
}

template <class Wanted>
std::vector<Parameter> only(const FilterTable& filter, Wanted wanted) {
  std::vector<Parameter> found;
  std::copy_if(filter.parameters.begin(), filter.parameters.end(), std::back_inserter(found),
               wanted);
  return found;
}

/// A dialog beside that for daily use, where a filter has parameters for these users.
struct SpecialDialog {
  Audience audience;
  const char *title, *suffix;
};

constexpr SpecialDialog special_dialogs[] = {{Audience::Papers, "Paper Settings", "paper"},
                                             {Audience::Assemblies, "Assemblies", "assemblies"}};

}  // namespace

std::vector<FlatDialog> flat_dialogs(const FilterTable& filter) {
  const auto& [menu_name, python_name] = std::tie(filter.about.menu_name, filter.about.python_name);
  if (filter.parameters.size() <= most_rows) return {{menu_name, python_name, filter.parameters}};
  std::vector<FlatDialog> all = {{menu_name, python_name, only(filter, is_for_daily_use)}};
  for (const auto& [audience, title, suffix] : special_dialogs) {
    const auto is_wanted = [who = audience](const Parameter& each) { return is_for(who, each); };
    const auto is_theirs = [who = audience](const Parameter& each) {
      return each.place.audience == who;
    };
    if (!only(filter, is_theirs).empty())
      all.push_back(
          {menu_name + " (" + title + ")", python_name + "_" + suffix, only(filter, is_wanted)});
  }
  return all;
}

}  // namespace curvdecim::glue
