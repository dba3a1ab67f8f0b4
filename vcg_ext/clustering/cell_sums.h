// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "vcg_ext/clustering/clusters.h"
#include "vcg_ext/geometry/quadric.h"
#include "vcg_ext/parallel/pieces.h"

namespace curvdecim::detail {

/// Weighted sum of the points of a cell, about its centre.
struct PointSum {
  double weight = 0.0;
  Vector3 sum = Vector3::Zero();

  Vector3 mean() const { return sum / weight; }

  PointSum& operator+=(const PointSum& o) {
    weight += o.weight, sum += o.sum;
    return *this;
  }
};

/// What the elements of a mesh leave in its cells, by cell. Elements come in blocks; the sums of
/// two blocks add up to those of both.
template <class Sum>
using CellSums = std::vector<Sum>;

/// How many blocks are summed on their own: never by the threads, for the order of a sum shows in
/// its last bits. Together their sums take no more room than the elements.
inline int blocks_of(int elements, int cells) {
  constexpr int most = 8, elements_a_cell = 4;
  return std::clamp(elements / (elements_a_cell * std::max(1, cells)), 1, most);
}

/// add(sums, i) for every element i below count.
template <class Sum, class Add>
CellSums<Sum> sum_over(int count, int cells, const Parallel& parallel, Add add) {
  const int blocks = blocks_of(count, cells);
  std::vector<CellSums<Sum>> sums(blocks, CellSums<Sum>(cells));
  for_pieces(count, blocks, parallel, [&](int block, int begin, int end) {
    for (int i = begin; i < end; ++i) add(sums[block], i);
  });
  parallel.for_ranges(cells, [&](int begin, int end, int) {
    for (int block = 1; block < blocks; ++block)
      for (int cell = begin; cell < end; ++cell) sums[0][cell] += sums[block][cell];
  });
  return std::move(sums[0]);
}

}  // namespace curvdecim::detail
