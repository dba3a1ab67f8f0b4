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

}  // namespace

std::vector<std::string> log_lines(const Outcome& outcome) {
  std::vector<std::string> lines = outcome.notes;
  for (const auto& [name, value] : outcome.results)
    lines.push_back(name + ": " + std::visit(AsText(), value));
  return lines;
}

}  // namespace curvdecim::glue
