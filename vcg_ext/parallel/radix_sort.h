// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <utility>

#include "vcg_ext/parallel/array.h"
#include "vcg_ext/parallel/bucket_places.h"

namespace curvdecim::detail {

/// Something with a key to be sorted by.
struct Keyed {
  std::uint64_t key;
  int value;
};

/// A key of 32 bits in the order of numbers that are not negative.
inline std::uint32_t key_of(float x) {
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

/// Sorts by keys of so many bits, from the lowest digit up, on all cores; equal ones stay in their
/// order.
inline void radix_sort(Array<Keyed>& items, int key_bits, const Parallel& parallel) {
  constexpr int digit_bits = 11;  // the counters of a digit fit the first cache
  constexpr int digits = 1 << digit_bits;
  const int count = static_cast<int>(items.size());
  Array<Keyed> sorted(items.size());
  BucketPlaces places;
  for (int shift = 0; shift < key_bits; shift += digit_bits) {
    const auto digit = [&](int i) {
      return static_cast<int>(items[i].key >> shift) & (digits - 1);
    };
    places.count(count, digits, parallel, [&](int i, auto count_in) { count_in(digit(i)); });
    places.fill(parallel, [&](int i, auto place_in) { sorted[place_in(digit(i))] = items[i]; });
    items.swap(sorted);
  }
}

/// The items below count by their keys. item_of(i): the i-th.
template <class ItemOf>
Array<Keyed> sorted_by_key(int count, int key_bits, const Parallel& parallel, ItemOf item_of) {
  Array<Keyed> items(count);
  parallel.for_each(count, [&](int i) { items[i] = item_of(i); });
  radix_sort(items, key_bits, parallel);
  return items;
}

}  // namespace curvdecim::detail
