// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/box_tree.h"
#include "vcg_ext/guard/crossing_guard.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// Collapses that are to be done at the same time, and were each allowed as the surface was before:
/// which of them would make faces cross with those of another one.
class RoundCrossings {
 public:
  void begin(int picks) {
    if (static_cast<int>(stars_.size()) < picks) stars_.resize(picks);
  }

  /// Takes what pick i changes. Different picks may be kept at the same time.
  void keep(int i, CrossingGuard::Star& star) { std::swap(stars_[i], star); }

  /// Of these picks, ascending, those that are in conflict with one before them that is done.
  std::vector<int> to_drop(const std::vector<int>& picks, const CrossingGuard& guard,
                           const Parallel& parallel) const {
    const std::vector<std::vector<int>> earlier = conflicts(picks, guard, parallel);
    std::vector<int> dropped;
    const auto is_done = [&](int i) {
      return !std::binary_search(dropped.begin(), dropped.end(), picks[i]);
    };
    for (std::size_t i = 0; i < picks.size(); ++i)
      if (std::any_of(earlier[i].begin(), earlier[i].end(), is_done)) dropped.push_back(picks[i]);
    return dropped;
  }

 private:
  /// By place among the picks: the places before it that are in conflict with it.
  std::vector<std::vector<int>> conflicts(const std::vector<int>& picks, const CrossingGuard& guard,
                                          const Parallel& parallel) const {
    const int count = static_cast<int>(picks.size());
    std::vector<std::vector<int>> earlier(count);
    if (count == 0) return earlier;
    std::vector<Box> box(count);
    parallel.for_each(count, [&](int i) { box[i] = stars_[picks[i]].box(); });
    BoxTree tree(count);
    tree.fit([&](int nodes, auto work) { parallel.for_each(nodes, work); },
             [&](int i) { return box[i]; });
    const auto look = [&](int i) {
      tree.any_meeting(box[i], [&](int k) {
        if (k < i && guard.are_in_conflict(stars_[picks[i]], stars_[picks[k]]))
          earlier[i].push_back(k);
        return false;
      });
    };
    parallel.for_each(count, look, Parallel::heavy);
    return earlier;
  }

  std::vector<CrossingGuard::Star> stars_;  // by pick
};

}  // namespace curvdecim::detail
