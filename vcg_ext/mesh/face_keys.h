// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/parallel/array.h"
#include "vcg_ext/parallel/bucket_places.h"

namespace curvdecim::detail {

/// The vertices of a face in ascending order, and its number.
using FaceKey = std::array<int, 4>;

inline int least_vertex(const Face& face) { return std::min({face[0], face[1], face[2]}); }

inline FaceKey face_key(const Face& face, int f) {
  const auto [a, b, c] = face;
  const int least = least_vertex(face), largest = std::max({a, b, c});
  return {least, a ^ b ^ c ^ least ^ largest, largest, f};
}

inline bool have_the_same_vertices(const FaceKey& a, const FaceKey& b) {
  return std::equal(a.begin(), a.end() - 1, b.begin());
}

/// The keys of the wanted faces below count, in their order: buckets by the least vertex, each
/// sorted. face_of(f): the face; wanted(f): whether its key is.
template <class FaceOf, class Wanted>
Array<FaceKey> ordered_keys(int count, int vertices, const Parallel& parallel, FaceOf face_of,
                            Wanted wanted) {
  BucketPlaces places;
  places.count(count, vertices, parallel, [&](int f, auto count_in) {
    if (wanted(f)) count_in(least_vertex(face_of(f)));
  });
  Array<FaceKey> keys(places.begin().back());
  places.fill(parallel, [&](int f, auto place_in) {
    if (wanted(f)) keys[place_in(least_vertex(face_of(f)))] = face_key(face_of(f), f);
  });
  const auto bound = [&](int v) { return keys.begin() + places.begin()[v]; };
  parallel.for_each(vertices, [&](int v) { std::sort(bound(v), bound(v + 1)); });
  return keys;
}

}  // namespace curvdecim::detail
