// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace curvdecim::detail {

/// 4-ary minimum heap of (key, index) with at most one entry per index; equal keys leave in the
/// order of the index, so that the sequence does not depend on the history. A default Key comes
/// after all others.
template <class Key>
class IndexedHeap {
 public:
  struct Entry {
    Key key;
    int index;
    bool operator<(const Entry& o) const { return key == o.key ? index < o.index : key < o.key; }
  };

  explicit IndexedHeap(std::size_t indices) : slot_(indices, absent) {}

  /// Room for indices below `indices`.
  void extend(std::size_t indices) { slot_.resize(indices, absent); }

  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  const Entry& top() const { return entries_.front(); }
  /// The least key but the top's.
  Key second_key() const {
    const int second = least_child(0);
    return second == absent ? Key() : entries_[second].key;
  }
  bool contains(int index) const { return slot_[index] != absent; }
  const Entry& entry(int index) const { return entries_[slot_[index]]; }

  /// Inserts the index or changes its key.
  void set(int index, const Key& key) {
    if (!contains(index)) {
      entries_.push_back({});
      place(static_cast<int>(entries_.size()) - 1, {key, index});
      sift_up(slot_[index]);
    } else {
      entries_[slot_[index]] = {key, index};
      sift_up(slot_[index]);
      sift_down(slot_[index]);
    }
  }

  void remove(int index) {
    if (!contains(index)) return;
    const int hole = slot_[index];
    const Entry last = entries_.back();
    entries_.pop_back();
    slot_[index] = absent;
    if (last.index == index) return;
    place(hole, last);
    sift_up(hole);
    sift_down(slot_[last.index]);
  }

 private:
  static constexpr int arity = 4;
  static constexpr int absent = -1;

  void place(int slot, const Entry& entry) {
    entries_[slot] = entry;
    slot_[entry.index] = slot;
  }

  void sift_up(int slot) {
    const Entry moving = entries_[slot];
    for (int parent; slot > 0 && moving < entries_[parent = (slot - 1) / arity]; slot = parent)
      place(slot, entries_[parent]);
    place(slot, moving);
  }

  void sift_down(int slot) {
    const Entry moving = entries_[slot];
    for (int child; (child = least_child(slot)) >= 0 && entries_[child] < moving; slot = child)
      place(slot, entries_[child]);
    place(slot, moving);
  }

  int least_child(int slot) const {
    const int first = arity * slot + 1, count = static_cast<int>(entries_.size());
    if (first >= count) return absent;
    int least = first;
    for (int child = first + 1; child < first + arity && child < count; ++child)
      if (entries_[child] < entries_[least]) least = child;
    return least;
  }

  std::vector<Entry> entries_;
  std::vector<int> slot_;  // by index
};

}  // namespace curvdecim::detail
