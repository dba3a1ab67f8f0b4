// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <vector>

namespace curvdecim::glue {

/// Groups of rows, one after the other.
template <class Row>
std::vector<Row> joined(std::initializer_list<std::vector<Row>> groups) {
  std::vector<Row> rows;
  for (const std::vector<Row>& group : groups) rows.insert(rows.end(), group.begin(), group.end());
  return rows;
}

}  // namespace curvdecim::glue
