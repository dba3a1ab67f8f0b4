// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/renumbering.h"
#include "vcg_ext/queue/indexed_heap.h"
#include "vcg_ext/queue/priority.h"

namespace curvdecim::detail {

/// An edge from a vertex to a neighbour of higher index.
struct EdgeChoice {
  static constexpr int none = -1;

  Priority priority;
  int partner = none;
  bool has_price = false;  ///< beside its cost: it was asked about, and is not free

  bool exists() const { return partner != none; }
  bool operator<(const EdgeChoice& o) const {
    return priority == o.priority ? partner < o.partner : priority < o.priority;
  }
};

/// The cheapest edge of every vertex, kept at the edge's lower vertex, as last known.
class EdgeChoices {
 public:
  explicit EdgeChoices(int vertices) : priority_(vertices), partner_(vertices, EdgeChoice::none) {}

  EdgeChoice of(int owner) const { return {priority_[owner], partner_[owner]}; }
  Priority priority(int owner) const { return priority_[owner]; }
  bool exists(int owner) const { return partner_[owner] != EdgeChoice::none; }

  void set(int owner, const EdgeChoice& choice) {
    priority_[owner] = choice.priority;
    partner_[owner] = choice.partner;
  }

  /// A partner that is gone becomes none; its owner has to choose again.
  void renumber(const Renumbering& numbers) {
    numbers.vertices(priority_), numbers.vertices(partner_);
    for (int& partner : partner_)
      if (partner != EdgeChoice::none) partner = numbers.vertex(partner);
  }

 private:
  std::vector<Priority> priority_;  // by vertex
  std::vector<int> partner_;        // by vertex
};

/// The cheapest edge of every vertex, kept at the edge's lower vertex, cheapest first. One entry a
/// vertex instead of one an edge makes the heap a third as large and most updates free.
class EdgeQueue {
 public:
  explicit EdgeQueue(int vertices)
      : heap_(vertices), partner_(vertices, EdgeChoice::none), has_price_(vertices, 0) {}

  /// Room for so many vertices in all.
  void extend(int vertices) {
    heap_.extend(vertices);
    partner_.resize(vertices, EdgeChoice::none), has_price_.resize(vertices, 0);
  }

  bool empty() const { return heap_.empty(); }
  int size() const { return static_cast<int>(heap_.size()); }
  Edge top() const { return {heap_.top().index, partner_[heap_.top().index]}; }
  bool top_has_price() const { return has_price_[heap_.top().index] != 0; }
  Priority top_priority() const { return heap_.top().key; }
  Priority second_priority() const { return heap_.second_key(); }

  bool contains(int owner) const { return heap_.contains(owner); }

  EdgeChoice of(int owner) const {
    if (!contains(owner)) return {};
    return {heap_.entry(owner).key, partner_[owner], has_price_[owner] != 0};
  }

  /// No edge: the owner leaves the queue.
  void set(int owner, const EdgeChoice& choice) {
    if (!choice.exists()) return heap_.remove(owner);
    partner_[owner] = choice.partner;
    has_price_[owner] = choice.has_price;
    heap_.set(owner, choice.priority);
  }

  /// Takes the edge, if there is one, where it comes before the one that its owner has.
  void offer(int owner, const EdgeChoice& choice) {
    if (choice.exists() && (!contains(owner) || choice < of(owner))) set(owner, choice);
  }

  void remove(int owner) { heap_.remove(owner); }

 private:
  IndexedHeap<Priority> heap_;
  std::vector<int> partner_;             // by vertex
  std::vector<std::uint8_t> has_price_;  // by vertex
};

}  // namespace curvdecim::detail
