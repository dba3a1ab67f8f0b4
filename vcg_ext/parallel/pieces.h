// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// Where work in the order of the elements can be cut, so that each thread has one piece.
inline int pieces_of(int count, const Parallel& parallel) {
  return count < 2 * Parallel::light.least ? 1 : parallel.threads();
}

/// work(piece, begin, end) for consecutive pieces of 0..count.
template <class Work>
void for_pieces(int count, int pieces, const Parallel& parallel, Work work) {
  const auto bound = [&](int piece) {
    return static_cast<int>(static_cast<std::int64_t>(count) * piece / pieces);
  };
  parallel.for_each(
      pieces, [&](int piece) { work(piece, bound(piece), bound(piece + 1)); }, Grain{1, pieces});
}

/// The indices below count for which holds(i), ascending.
template <class Holds>
std::vector<int> indices_where(int count, const Parallel& parallel, Holds holds) {
  const int pieces = pieces_of(count, parallel);
  std::vector<std::vector<int>> of_piece(pieces);
  for_pieces(count, pieces, parallel, [&](int piece, int begin, int end) {
    of_piece[piece].reserve(end - begin);
    for (int i = begin; i < end; ++i)
      if (holds(i)) of_piece[piece].push_back(i);
  });
  std::vector<int> all = std::move(of_piece[0]);
  for (int piece = 1; piece < pieces; ++piece)
    all.insert(all.end(), of_piece[piece].begin(), of_piece[piece].end());
  return all;
}

/// True if holds(i) for an index below count.
template <class Holds>
bool any_where(int count, const Parallel& parallel, Holds holds) {
  std::atomic<bool> any{false};
  parallel.for_ranges(count, [&](int begin, int end, int) {
    for (int i = begin; i < end && !any.load(std::memory_order_relaxed); ++i)
      if (holds(i)) any = true;
  });
  return any;
}

}  // namespace curvdecim::detail
