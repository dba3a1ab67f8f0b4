// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace curvdecim {

/// A set of vertices that is emptied in constant time.
class VertexMarks {
 public:
  explicit VertexMarks(int vertices) : stamp_(vertices, 0) {}

  void clear() { ++current_; }
  bool has(int v) const { return stamp_[v] == current_; }

  /// False if v was in the set.
  bool insert(int v) {
    if (has(v)) return false;
    stamp_[v] = current_;
    return true;
  }

  /// False if v was not in the set.
  bool erase(int v) {
    if (!has(v)) return false;
    stamp_[v] = 0;
    return true;
  }

 private:
  std::vector<unsigned> stamp_;
  unsigned current_ = 1;
};

}  // namespace curvdecim
