// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/geometry/mixed.h"

namespace curvdecim::detail {

inline std::uint64_t hash_of(std::uint64_t key) { return mixed(key); }
inline std::uint64_t hash_of(const std::array<int, 2>& key) {
  return mixed(std::uint64_t(std::uint32_t(key[0])) << 32 | std::uint32_t(key[1]));
}
inline std::uint64_t hash_of(const std::array<std::uint64_t, 3>& key) {
  return mixed(mixed(mixed(key[0]) + key[1]) + key[2]);
}

/// Numbers keys 0, 1, 2, ... in the order in which they come for the first time. Memory follows the
/// number of different keys.
template <class Key>
class FirstSeen {
 public:
  FirstSeen() : slots_(least_slots, empty) {}

  /// The key's number; a new one gets the next.
  int number(const Key& key) {
    std::size_t slot = find(key);
    if (slots_[slot] != empty) return slots_[slot];
    if (2 * keys_.size() >= slots_.size()) {
      grow();
      slot = find(key);
    }
    keys_.push_back(key);
    return slots_[slot] = size() - 1;
  }

  int size() const { return static_cast<int>(keys_.size()); }
  const std::vector<Key>& keys() const { return keys_; }

 private:
  static constexpr int empty = -1;
  static constexpr std::size_t least_slots = 64;  // a power of two

  /// The key's slot, or the one where it would go.
  std::size_t find(const Key& key) const {
    std::size_t slot = hash_of(key) & (slots_.size() - 1);
    while (slots_[slot] != empty && keys_[slots_[slot]] != key)
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  void grow() {
    slots_.assign(4 * slots_.size(), empty);
    for (int i = 0; i < size(); ++i) slots_[find(keys_[i])] = i;
  }

  std::vector<int> slots_;  // numbers; at most half of them in use
  std::vector<Key> keys_;   // by number
};

}  // namespace curvdecim::detail
