// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace curvdecim::detail {

/// Numbers that are united step by step. The least of a set stands for it, so that the order of the
/// steps does not matter.
class DisjointSets {
 public:
  explicit DisjointSets(int count = 0) { reset(count); }

  /// Every number is a set of its own again.
  void reset(int count) {
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// Returns whether they were in two sets.
  bool unite(int i, int j) {
    i = root(i), j = root(j);
    parent_[std::max(i, j)] = std::min(i, j);
    return i != j;
  }

 private:
  std::vector<int> parent_;  // never larger than the number itself
};

}  // namespace curvdecim::detail
