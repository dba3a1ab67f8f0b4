// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "vcg_ext/mesh/face_keys.h"

namespace curvdecim::detail {

/// A face between three different cells, with the face of the input that it comes from.
struct CellFace {
  Face cells;
  int origin;
};

/// Faces between cells of which several may have the same three: the one stays that comes first
/// among those of the more frequent orientation.
class DistinctFaces {
 public:
  DistinctFaces(const Array<CellFace>& faces, int cells, const Parallel& parallel)
      : faces_(faces), stays_(faces.size(), 0) {
    const int count = static_cast<int>(faces.size());
    const auto cells_of = [&](int i) -> const Face& { return faces[i].cells; };
    const Array<FaceKey> keys =
        ordered_keys(count, cells, parallel, cells_of, [](int) { return true; });
    parallel.for_each(count, [&](int i) {
      if (i == 0 || !have_the_same_vertices(keys[i - 1], keys[i]))
        stays_[chosen(&keys[i], keys.data() + count)] = 1;
    });
  }

  /// In the order in which they came.
  std::vector<CellFace> left() const {
    std::vector<CellFace> left;
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (stays_[i] != 0) left.push_back(faces_[i]);
    return left;
  }

 private:
  /// The face that stays of those that have the same cells as the first one; the first of all where
  /// both orientations are as frequent.
  int chosen(const FaceKey* first, const FaceKey* end) const {
    const auto ascends = [&](const FaceKey& key) {
      return next_in(faces_[key.back()].cells, key[0]) == key[1];
    };
    const FaceKey* const last = std::find_if_not(
        first, end, [&](const FaceKey& key) { return have_the_same_vertices(*first, key); });
    const auto up = std::count_if(first, last, ascends), down = last - first - up;
    if (up == down) return first->back();
    return std::find_if(first, last,
                        [&](const FaceKey& key) { return ascends(key) == (up > down); })
        ->back();
  }

  const Array<CellFace>& faces_;
  std::vector<std::uint8_t> stays_;  // by face: 1 if it does
};

}  // namespace curvdecim::detail
