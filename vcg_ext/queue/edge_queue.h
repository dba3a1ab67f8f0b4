// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tuple>
#include <vector>

#include "vcg_ext/connectivity/edge_neighborhood.h"
#include "vcg_ext/queue/indexed_heap.h"

namespace curvdecim {

/// Cheapest first; among the equally cheap, as on a plane, the shortest, so that a flat place is
/// thinned evenly and no vertex swallows all others.
struct Priority {
  double cost;
  float length2 = 0.0f;  // squared length, in the box of diagonal 1
};

/// The cheapest edge of every vertex, kept at the edge's lower vertex. One entry a vertex instead
/// of one an edge makes the heap a third as large and most updates free.
class EdgeQueue {
 public:
  explicit EdgeQueue(int vertices) : heap_(vertices), partner_(vertices, none) {}

  static constexpr int none = -1;

  bool empty() const { return heap_.empty(); }
  Edge top() const { return {heap_.top().index, partner_[heap_.top().index]}; }
  double top_cost() const { return heap_.top().key; }
  double second_cost() const { return heap_.second_key(); }

  /// The other end of the vertex's cheapest edge, or none.
  int partner(int owner) const { return heap_.contains(owner) ? partner_[owner] : none; }

  void set(Edge edge, const Priority& priority) {
    partner_[edge.a] = edge.b;
    heap_.set(edge.a, priority.cost, priority.length2);
  }

  /// Takes the edge if it comes before the one that its owner has.
  void offer(Edge edge, const Priority& priority) {
    if (!heap_.contains(edge.a)) return set(edge, priority);
    const IndexedHeap::Entry& known = heap_.entry(edge.a);
    if (std::tie(priority.cost, priority.length2, edge.b) <
        std::tie(known.key, known.tie, partner_[edge.a]))
      set(edge, priority);
  }

  void remove(int owner) { heap_.remove(owner); }

 private:
  IndexedHeap heap_;
  std::vector<int> partner_;
};

}  // namespace curvdecim
