// SPDX-License-Identifier: GPL-3.0-or-later
// What a filter returns: an entry of PyMeshLab's dictionary and a line of the log for each result.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "vcg_ext/field.h"

namespace curvdecim::glue {

/// A constant of an enum of the core.
struct Constant {
  int number;
  std::string label;
};

using ResultValue = std::variant<std::int64_t, double, Constant>;

/// A result as it is documented.
struct ResultText {
  std::string name, unit, meaning;
  std::vector<std::string> labels = {};  ///< those of an enum, by number
};

struct Result {
  std::string name;
  ResultValue value;
};

/// What a host has to bring up to date.
struct Changes {
  bool shape = false;
  bool quality_and_color = false;  ///< those of the vertices
};

/// What a filter tells its host.
struct Outcome {
  std::string headline;            ///< what it did, in a sentence; empty: nothing
  std::vector<std::string> notes;  ///< repairs and warnings
  std::vector<Result> results;
  Changes changed;
};

/// The log of a run: the headline, the notes, then "name: value" for each result that is not 0.
std::vector<std::string> log_lines(const Outcome& outcome);

/// A row of a filter's results; one without a value after a run is left out.
template <class Report, class Params>
struct ResultRow : ResultText {
  std::function<std::optional<ResultValue>(const Report&, const Params&)> value;
};

template <class Report, class Params>
using ResultRows = std::vector<ResultRow<Report, Params>>;

/// The row of a member of the report.
template <class Report, class Params, class Owner, class Member>
ResultRow<Report, Params> result(std::string name, std::string unit, std::string meaning,
                                 Member Owner::*member) {
  return {{std::move(name), std::move(unit), std::move(meaning)},
          [member](const Report& report, const Params&) { return report.*member; }};
}

/// The row of a member that is an enum of the core.
template <class Report, class Params, class Owner, class Enum>
ResultRow<Report, Params> enum_result(std::string name, std::string meaning, Enum Owner::*member) {
  constexpr auto names = labels(Enum());
  return {{std::move(name), "", std::move(meaning), {names.begin(), names.end()}},
          [member](const Report& report, const Params&) {
            return Constant{static_cast<int>(report.*member), label_of(report.*member)};
          }};
}

/// The row, with a value only where it makes sense.
template <class Report, class Params, class Condition>
ResultRow<Report, Params> only_if(Condition makes_sense, ResultRow<Report, Params> row) {
  row.value = [makes_sense, value = std::move(row.value)](const Report& report,
                                                          const Params& params) {
    return makes_sense(report, params) ? value(report, params) : std::nullopt;
  };
  return row;
}

/// The results that have a value, in the order of the rows.
template <class Report, class Params>
std::vector<Result> results_of(const ResultRows<Report, Params>& rows, const Report& report,
                               const Params& params) {
  std::vector<Result> results;
  for (const auto& row : rows)
    if (auto value = row.value(report, params)) results.push_back({row.name, *std::move(value)});
  return results;
}

}  // namespace curvdecim::glue
