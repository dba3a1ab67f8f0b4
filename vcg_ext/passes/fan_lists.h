// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/parallel/pieces.h"

namespace curvdecim::detail {

/// The neighbours of every vertex in the order of the faces around it, from the least one on, where
/// these form one closed fan and are oriented alike. The lists lie one after the other.
class FanLists {
 public:
  static constexpr int longest = 16;  ///< neighbours: others have very many faces, and are left out

  /// wanted(v): whether v's list is.
  template <class Wanted>
  void build(const std::vector<Face>& faces, int vertices, const Parallel& parallel,
             Wanted wanted) {
    count(faces, vertices, parallel, wanted);
    corners_.resize(begin_.back() + 1);  // the last vertex may have none
    closed_.resize(vertices);
    fill(faces, parallel, wanted);
    parallel.for_each(vertices, [&](int v) { closed_[v] = put_in_order(v); });
  }

  /// Empty where there is none.
  IndexRange of(int v) const {
    const int* const first = corners_[begin_[v]].data();
    return {first, first + (closed_[v] != 0 ? begin_[v + 1] - begin_[v] : 0)};
  }

 private:
  /// The face's other corners, in its order: the next and the last.
  using Corner = std::array<int, 2>;

  static constexpr int most_pieces = 8;  // each has a counter a vertex

  /// Among a vertex's faces those of earlier pieces come first: the order is that of the faces.
  template <class Wanted>
  void count(const std::vector<Face>& faces, int vertices, const Parallel& parallel,
             Wanted wanted) {
    const int face_count = static_cast<int>(faces.size());
    const int pieces = std::min(most_pieces, pieces_of(face_count, parallel));
    place_.resize(pieces);
    for_pieces(face_count, pieces, parallel, [&](int piece, int begin, int end) {
      std::vector<int>& count = place_[piece];
      count.assign(vertices, 0);
      for (int f = begin; f < end; ++f)
        for (int v : faces[f]) count[v] += wanted(v);
    });
    begin_.resize(vertices + 1);
    int at = 0;
    for (int v = 0; v < vertices; ++v) {
      begin_[v] = at;
      for (std::vector<int>& place : place_) at += std::exchange(place[v], at);
    }
    begin_[vertices] = at;
  }

  template <class Wanted>
  void fill(const std::vector<Face>& faces, const Parallel& parallel, Wanted wanted) {
    const int face_count = static_cast<int>(faces.size()), pieces = static_cast<int>(place_.size());
    for_pieces(face_count, pieces, parallel, [&](int piece, int begin, int end) {
      std::vector<int>& place = place_[piece];
      for (int f = begin; f < end; ++f) {
        const auto [a, b, c] = faces[f];
        if (wanted(a)) corners_[place[a]++] = {b, c};
        if (wanted(b)) corners_[place[b]++] = {c, a};
        if (wanted(c)) corners_[place[c]++] = {a, b};
      }
    });
  }

  /// Writes the list where the corners were. False where they are no closed fan.
  bool put_in_order(int v) {
    const int size = begin_[v + 1] - begin_[v];
    if (size < 3 || size > longest) return false;
    std::array<Corner, longest> corners;
    std::copy_n(corners_.begin() + begin_[v], size, corners.begin());
    int at = 0;
    for (int i = 1; i < size; ++i)
      if (corners[i][0] < corners[at][0]) at = i;
    int* const fan = corners_[begin_[v]].data();
    for (int i = 0; i < size; ++i) {
      const auto [next, last] = corners[at];
      fan[i] = next;
      std::swap(corners[at], corners[i]);  // it is used up
      if (i + 1 == size) return last == fan[0] && are_different(fan, size);
      for (at = i + 1; at < size && corners[at][0] != last;) ++at;
      if (at == size) return false;
    }
    return false;
  }

  static bool are_different(const int* fan, int size) {
    for (int i = 1; i < size; ++i)
      if (std::find(fan, fan + i, fan[i]) != fan + i) return false;
    return true;
  }

  std::vector<int> begin_;               // by vertex, and the end
  std::vector<std::vector<int>> place_;  // by piece, then by vertex
  std::vector<Corner> corners_;          // by place; then the lists in the same memory
  std::vector<std::uint8_t> closed_;     // by vertex
};

}  // namespace curvdecim::detail
