// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "vcg_ext/queue/edge_choices.h"

namespace curvdecim {

/// The candidates of a round, and which of them can be collapsed at the same time: of the vertices'
/// choices the cheapest share, and from these, class by class from the cheapest, every edge whose
/// neighbourhood shares no vertex with that of an edge picked before. What lies too near to a pick
/// waits for the next one, unless an end of it has been merged meanwhile.
class RoundSelection {
 public:
  /// choices: by vertex of the mesh; they may change between rounds.
  RoundSelection(const TriangleConnectivity& connectivity, const EdgeChoices& choices)
      : connectivity_(connectivity),
        choices_(choices),
        taken_in_(connectivity.vertex_slots(), 0),
        merged_in_(connectivity.vertex_slots(), 0) {}

  /// A new round. share: of the choices, 0..1.
  void begin(double share) {
    ++round_;
    find_limits(share);
    sort_into_classes();
  }

  /// Fills edges() with candidates that lie apart; they are candidates no more.
  void pick() {
    ++pick_;
    edges_.clear();
    std::size_t waiting = 0;
    for (int owner : candidates_) {
      const Edge edge{owner, choices_.of(owner).partner};
      if (merged(edge.a) || merged(edge.b)) continue;
      if (taken(edge.a) || taken(edge.b) || !is_apart(edge))
        candidates_[waiting++] = owner;
      else
        take(edge);
    }
    candidates_.resize(waiting);
  }

  /// To be told of the collapses of the picks: the edges at both ends are others now.
  void set_merged(Edge edge) { merged_in_[edge.a] = merged_in_[edge.b] = round_; }

  /// Apart from each other.
  const std::vector<Edge>& edges() const { return edges_; }
  int candidates() const { return static_cast<int>(candidates_.size()); }
  /// What an edge of this round may cost at most.
  Priority limit() const { return limit_.back(); }

  void renumber(const Renumbering& numbers) {
    numbers.vertices(taken_in_), numbers.vertices(merged_in_);
  }

 private:
  static constexpr int classes = 8;  // of equal size
  static constexpr int small_class = 128;
  static constexpr int samples = 256;  // they tell the share within a tenth of it

  /// From every n-th vertex.
  void find_limits(double share) {
    const int stride = std::max(1, connectivity_.vertex_count() / samples);
    sample_.clear();
    for (int v = 0; v < connectivity_.vertex_slots(); v += stride)
      if (choices_.exists(v)) sample_.push_back(choices_.priority(v));
    limit_.fill(Priority(0.0, 0.0));
    if (sample_.empty()) return;
    const auto last = static_cast<std::size_t>(share * sample_.size());
    std::nth_element(sample_.begin(), sample_.begin() + last, sample_.end());
    std::sort(sample_.begin(), sample_.begin() + last);
    for (int c = 0; c < classes; ++c) limit_[c] = sample_[last * (c + 1) / classes];
  }

  /// A small class is sorted by cost. In a large one single edges do not show in the result: its
  /// order is that of the vertices, so that memory is read in order.
  void sort_into_classes() {
    const int vertices = connectivity_.vertex_slots();
    std::array<std::size_t, classes + 2> end{};
    class_of_.resize(vertices);
    for (int v = 0; v < vertices; ++v) ++end[1 + (class_of_[v] = class_of(v))];
    std::partial_sum(end.begin(), end.end(), end.begin());
    const auto begin = end;
    candidates_.resize(end[classes]);
    for (int v = 0; v < vertices; ++v)
      if (class_of_[v] < classes) candidates_[end[class_of_[v]]++] = v;
    for (int c = 0; c < classes; ++c)
      if (end[c] - begin[c] <= small_class)
        std::sort(candidates_.begin() + begin[c], candidates_.begin() + end[c],
                  [this](int u, int v) { return comes_before(u, v); });
  }

  bool comes_before(int u, int v) const {
    const Priority of_u = choices_.priority(u), of_v = choices_.priority(v);
    return of_u == of_v ? u < v : of_u < of_v;
  }

  /// `classes` for what is no candidate.
  std::uint8_t class_of(int v) const {
    const Priority priority = choices_.priority(v);
    if (limit() < priority || !choices_.exists(v)) return classes;
    int c = 0;
    while (limit_[c] < priority) ++c;
    return static_cast<std::uint8_t>(c);
  }

  bool merged(int v) const { return merged_in_[v] == round_; }
  bool taken(int v) const { return taken_in_[v] == pick_; }

  bool is_apart(Edge edge) const {
    for (int v : {edge.a, edge.b})
      for (int f : connectivity_.faces_of(v))
        for (int u : connectivity_.face(f))
          if (taken(u)) return false;
    return true;
  }

  void take(Edge edge) {
    for (int v : {edge.a, edge.b})
      for (int f : connectivity_.faces_of(v))
        for (int u : connectivity_.face(f)) taken_in_[u] = pick_;
    edges_.push_back(edge);
  }

  const TriangleConnectivity& connectivity_;
  const EdgeChoices& choices_;
  int round_ = 0, pick_ = 0;
  std::vector<int> taken_in_;   // by vertex: the last pick with it in a neighbourhood
  std::vector<int> merged_in_;  // by vertex: the last round in which it was an end of a collapse
  std::vector<Priority> sample_;
  std::array<Priority, classes> limit_;  // of each class
  std::vector<std::uint8_t> class_of_;   // by vertex
  std::vector<int> candidates_;          // that have not been picked, by their owners
  std::vector<Edge> edges_;
};

}  // namespace curvdecim
