// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "vcg_ext/parallel/pieces.h"

namespace curvdecim::detail {

/// A counting sort on all cores: where entries go that belong into buckets, so that in each bucket
/// they are in the order of the items that they are of. An item may have any number of entries.
class BucketPlaces {
 public:
  /// visit(item, count): calls count(bucket) for every entry of the item.
  template <class Visit>
  void count(int items, int buckets, const Parallel& parallel, Visit visit) {
    items_ = items;
    next_.resize(std::min(most_pieces, pieces_of(items, parallel)));
    for_items(parallel, [&](int begin, int end, std::vector<int>& counts) {
      counts.assign(buckets, 0);
      const auto count_in = [&](int bucket) { ++counts[bucket]; };
      for (int item = begin; item < end; ++item) visit(item, count_in);
    });
    begin_.resize(buckets + 1);
    int at = 0;
    for (int bucket = 0; bucket < buckets; ++bucket) {
      begin_[bucket] = at;
      for (std::vector<int>& next : next_) at += std::exchange(next[bucket], at);
    }
    begin_[buckets] = at;
  }

  /// By bucket: where its entries begin; and the end of all.
  const std::vector<int>& begin() const { return begin_; }

  /// visit(item, place_in): has to call place_in(bucket), which returns where the entry goes, for
  /// the same entries. Once after every count.
  template <class Visit>
  void fill(const Parallel& parallel, Visit visit) {
    for_items(parallel, [&](int begin, int end, std::vector<int>& next) {
      const auto place_in = [&](int bucket) { return next[bucket]++; };
      for (int item = begin; item < end; ++item) visit(item, place_in);
    });
  }

 private:
  static constexpr int most_pieces = 8;  // each has a counter a bucket

  template <class Work>
  void for_items(const Parallel& parallel, Work work) {
    for_pieces(items_, static_cast<int>(next_.size()), parallel,
               [&](int piece, int begin, int end) { work(begin, end, next_[piece]); });
  }

  int items_ = 0;
  std::vector<int> begin_;              // by bucket, and the end
  std::vector<std::vector<int>> next_;  // by piece of the items, then by bucket
};

}  // namespace curvdecim::detail
