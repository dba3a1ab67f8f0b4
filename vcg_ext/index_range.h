// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace curvdecim {

/// Numbers of elements, one after the other in an array that something else owns; valid until that
/// changes.
struct IndexRange {
  const int* first;
  const int* last;
  const int* begin() const { return first; }
  const int* end() const { return last; }
  int size() const { return static_cast<int>(last - first); }
};

}  // namespace curvdecim
