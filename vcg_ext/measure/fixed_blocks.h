// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// combine(a, value(i)) over every i below count, from 0.0. Blocks of one length are combined by
/// themselves and then in their order, so that the number of threads cannot show in a sum.
template <class Value, class Combine>
double combined(int count, const Parallel& parallel, Value value, Combine combine) {
  constexpr int length = 4096;  // some tens of microseconds of light work
  const int blocks = count / length + (count % length != 0);
  std::vector<double> part(blocks, 0.0);
  parallel.for_each(
      blocks,
      [&](int block) {
        const int begin = block * length, end = begin + std::min(length, count - begin);
        double all = 0.0;
        for (int i = begin; i < end; ++i) all = combine(all, value(i));
        part[block] = all;
      },
      Parallel::heavy);
  double all = 0.0;
  for (double each : part) all = combine(all, each);
  return all;
}

template <class Value>
double sum_of(int count, const Parallel& parallel, Value value) {
  return combined(count, parallel, value, [](double a, double b) { return a + b; });
}

/// 0 where there is none.
template <class Value>
double largest_of(int count, const Parallel& parallel, Value value) {
  return combined(count, parallel, value, [](double a, double b) { return std::max(a, b); });
}

}  // namespace curvdecim::detail
