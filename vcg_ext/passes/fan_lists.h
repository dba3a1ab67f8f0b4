// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/parallel/array.h"
#include "vcg_ext/parallel/bucket_places.h"

namespace curvdecim::detail {

/// The faces around every vertex, in the order of their numbers. The lists lie one after the other.
class FanLists {
 public:
  static constexpr int longest = 16;  ///< faces: others have very many, and are left out

  /// wanted(v): whether v's list is.
  template <class Wanted>
  void build(const std::vector<Face>& faces, int vertices, const Parallel& parallel,
             Wanted wanted) {
    places_.count(static_cast<int>(faces.size()), vertices, parallel, [&](int f, auto count_in) {
      for (int v : faces[f])
        if (wanted(v)) count_in(v);
    });
    faces_.resize(places_.begin().back());
    places_.fill(parallel, [&](int f, auto place_in) {
      for (int v : faces[f])
        if (wanted(v)) faces_[place_in(v)] = f;
    });
  }

  /// Empty where there is none.
  IndexRange of(int v) const {
    const int begin = places_.begin()[v], size = places_.begin()[v + 1] - begin;
    const int* const first = faces_.data() + begin;
    return {first, first + (size <= longest ? size : 0)};
  }

  bool has(int v) const { return of(v).size() > 0; }

 private:
  BucketPlaces places_;  // a bucket a vertex
  Array<int> faces_;     // around the first vertex, then around the next
};

}  // namespace curvdecim::detail
