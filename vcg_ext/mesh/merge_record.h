// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numeric>
#include <vector>

namespace curvdecim::detail {

/// Which vertex became which other one, by numbers that are given once each
/// (WorkingMesh::vertex_origin). Empty, it notes nothing.
class MergeRecord {
 public:
  /// From now on merges are noted, of vertices with numbers below `count`.
  void begin(int count) { extend(count); }

  bool exists() const { return !into_.empty(); }

  /// `gone` became `keep`. A vertex does so once, so that several may be noted at the same time.
  void note(int gone, int keep) {
    if (exists()) into_[gone] = keep;
  }

  /// There are numbers up to `count` now.
  void make_room(int count) {
    if (exists()) extend(count);
  }

  /// By number: what it is in the end, itself if nothing else.
  std::vector<int> ends() const {
    std::vector<int> ends = into_;
    for (std::size_t v = 0; v < ends.size(); ++v) {
      int end = into_[v];
      while (ends[end] != end) end = ends[end];
      for (int i = static_cast<int>(v); ends[i] != end;) {
        const int next = ends[i];
        ends[i] = end, i = next;
      }
    }
    return ends;
  }

 private:
  void extend(int count) {
    const std::size_t before = into_.size();
    into_.resize(count);
    std::iota(into_.begin() + before, into_.end(), static_cast<int>(before));
  }

  std::vector<int> into_;  // by number
};

}  // namespace curvdecim::detail
