// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace curvdecim {

/// When what a metric knows of a vertex is computed anew after a face around it changed: at once for
/// ordinary valences; for a hub of thousands of faces when an eighth of them has changed, so that a
/// fan does not cost the square of its size.
class RefreshSchedule {
 public:
  explicit RefreshSchedule(int vertices) : skipped_(vertices, 0) {}

  bool due(int v, int valence) {
    if (valence > hub && ++skipped_[v] * part < valence) return false;
    skipped_[v] = 0;
    return true;
  }

 private:
  static constexpr int hub = 64;  // well above the valences of meshes made for any purpose
  static constexpr int part = 8;

  std::vector<int> skipped_;
};

}  // namespace curvdecim
