// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

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

}  // namespace curvdecim::detail
