// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/parallel/array.h"
#include "vcg_ext/parallel/bucket_places.h"

namespace curvdecim::detail {

/// A face between three different cells, with the face of the input that it comes from.
struct CellFace {
  Face cells;
  int origin;
};

/// Faces between cells of which several may have the same three: the one stays that comes first
/// among those of the more frequent orientation. Faces lie in buckets by their least cell, so that
/// all cores can compare them.
class DistinctFaces {
 public:
  DistinctFaces(const Array<CellFace>& faces, int cells, const Parallel& parallel)
      : faces_(faces), stays_(faces.size(), 0) {
    const int count = static_cast<int>(faces.size());
    const auto least = [&](int i) {
      const auto [a, b, c] = faces[i].cells;
      return std::min({a, b, c});
    };
    BucketPlaces places;
    places.count(count, cells, parallel, [&](int i, auto count_in) { count_in(least(i)); });
    Array<Entry> entries(count);
    places.fill(parallel, [&](int i, auto place_in) { entries[place_in(least(i))] = entry(i); });
    parallel.for_each(cells, [&](int c) {
      choose(entries.data() + places.begin()[c], entries.data() + places.begin()[c + 1]);
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
  struct Entry {
    int middle, largest;  // cells
    int face;
    bool even;  // whether an even number of swaps sorts the cells
  };

  Entry entry(int i) const {
    Face cells = faces_[i].cells;
    bool even = true;
    const auto order = [&](int& a, int& b) {
      if (a > b) std::swap(a, b), even = !even;
    };
    order(cells[0], cells[1]), order(cells[1], cells[2]), order(cells[0], cells[1]);
    return {cells[1], cells[2], i, even};
  }

  /// Of a bucket.
  void choose(Entry* begin, Entry* end) {
    const auto rank = [](const Entry& e) { return std::tuple(e.middle, e.largest, e.face); };
    std::sort(begin, end, [&](const Entry& a, const Entry& b) { return rank(a) < rank(b); });
    for (const Entry* at = begin; at != end;) {
      const Entry* const first = at;
      const auto is_other = [&](const Entry& e) {
        return e.middle != first->middle || e.largest != first->largest;
      };
      at = std::find_if(first, static_cast<const Entry*>(end), is_other);
      stays_[chosen(first, at)->face] = 1;
    }
  }

  /// Of faces between the same three, in the order in which they came; the first of all where both
  /// orientations are as frequent.
  static const Entry* chosen(const Entry* begin, const Entry* end) {
    const auto even = std::count_if(begin, end, [](const Entry& e) { return e.even; });
    const auto odd = end - begin - even;
    if (even == odd) return begin;
    return std::find_if(begin, end, [&](const Entry& e) { return e.even == (even > odd); });
  }

  const Array<CellFace>& faces_;
  std::vector<std::uint8_t> stays_;  // by face: 1 if it does
};

}  // namespace curvdecim::detail
