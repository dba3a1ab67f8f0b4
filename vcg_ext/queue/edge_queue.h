// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/connectivity/edge_neighborhood.h"
#include "vcg_ext/queue/indexed_heap.h"

namespace curvdecim {

/// The cheapest edge of every vertex, kept at the edge's lower vertex. One entry a vertex instead
/// of one an edge makes the heap a third as large and most updates free.
class EdgeQueue {
 public:
  explicit EdgeQueue(int vertices) : heap_(vertices), partner_(vertices, none) {}

  static constexpr int none = -1;

  bool empty() const { return heap_.empty(); }
  Edge top() const { return {heap_.top().index, partner_[heap_.top().index]}; }
  double top_cost() const { return heap_.top().key; }

  /// The other end of the vertex's cheapest edge, or none.
  int partner(int owner) const { return heap_.contains(owner) ? partner_[owner] : none; }

  void set(Edge edge, double cost) {
    partner_[edge.a] = edge.b;
    heap_.set(edge.a, cost);
  }

  /// Takes the edge if it is cheaper than what its owner has.
  void offer(Edge edge, double cost) {
    const double known = heap_.key(edge.a);
    if (cost < known || (cost == known && edge.b < partner_[edge.a])) set(edge, cost);
  }

  void remove(int owner) { heap_.remove(owner); }

 private:
  IndexedHeap heap_;
  std::vector<int> partner_;
};

}  // namespace curvdecim
