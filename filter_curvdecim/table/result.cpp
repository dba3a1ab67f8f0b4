// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/table/result.h"

#include "vcg_ext/run/validation.h"

namespace curvdecim::glue {
namespace {

struct AsText {
  std::string operator()(std::int64_t number) const { return std::to_string(number); }
  std::string operator()(double number) const { return detail::decimal(number); }
  std::string operator()(const Constant& constant) const { return constant.label; }
};

struct IsZero {
  bool operator()(std::int64_t number) const { return number == 0; }
  bool operator()(double number) const { return number == 0.0; }
  bool operator()(const Constant& constant) const { return constant.number == 0; }
};

/// A run that did nothing has no figures, but perhaps a reason other than the first, the target.
bool is_worth_a_line(const Result& result, bool did_something) {
  const bool is_zero = std::visit(IsZero(), result.value);
  const bool is_constant = std::holds_alternative<Constant>(result.value);
  return is_constant ? did_something || !is_zero : did_something && !is_zero;
}

}  // namespace

std::vector<std::string> log_lines(const Outcome& outcome) {
  std::vector<std::string> lines;
  if (!outcome.headline.empty()) lines.push_back(outcome.headline);
  lines.insert(lines.end(), outcome.notes.begin(), outcome.notes.end());
  for (const Result& result : outcome.results)
    if (is_worth_a_line(result, !outcome.headline.empty()))
      lines.push_back(result.name + ": " + std::visit(AsText(), result.value));
  return lines;
}

}  // namespace curvdecim::glue
