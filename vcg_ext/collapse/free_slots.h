// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "vcg_ext/mesh/triangle_connectivity.h"

namespace curvdecim::detail {

/// Numbers of vertices and faces that are gone, to be used again.
class FreeSlots {
 public:
  explicit FreeSlots(const TriangleConnectivity& connectivity) : connectivity_(connectivity) {}

  /// The next ones after those taken last, in ascending order; nullopt: there are not so many.
  std::optional<std::vector<int>> vertices(int count) {
    return take(count, connectivity_.vertex_slots(), next_vertex_,
                [&](int v) { return connectivity_.faces_of(v).size() == 0; });
  }
  std::optional<std::vector<int>> faces(int count) {
    return take(count, connectivity_.face_slots(), next_face_,
                [&](int f) { return !connectivity_.alive(f); });
  }

 private:
  template <class IsFree>
  static std::optional<std::vector<int>> take(int count, int size, int& next, IsFree is_free) {
    std::vector<int> found;
    int place = next < size ? next : 0;
    for (int looked = 0; looked < size && static_cast<int>(found.size()) < count; ++looked) {
      if (is_free(place)) found.push_back(place);
      place = place + 1 < size ? place + 1 : 0;
    }
    if (static_cast<int>(found.size()) < count) return std::nullopt;
    next = place;
    return found;
  }

  const TriangleConnectivity& connectivity_;
  int next_vertex_ = 0, next_face_ = 0;
};

}  // namespace curvdecim::detail
