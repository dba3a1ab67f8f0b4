// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "vcg_ext/collapse/edge_queue.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// The candidates of a round, and which of them can be collapsed at the same time: of the vertices'
/// choices the cheapest share, and from these, class by class from the cheapest, every edge whose
/// neighbourhood shares no vertex with that of an edge picked before. What lies too near to a pick
/// waits for the next one, unless an end of it has been merged meanwhile.
///
/// All cores work on blocks of vertices that are numbered in a row, and so lie close together, on
/// the edges whose neighbourhoods stay inside; what reaches across comes after these, block by
/// block. The blocks do not depend on the number of threads.
class RoundSelection {
 public:
  /// choices: by vertex of the mesh; they may change between rounds.
  RoundSelection(const TriangleConnectivity& connectivity, const EdgeChoices& choices)
      : connectivity_(connectivity),
        choices_(choices),
        taken_in_(connectivity.vertex_slots(), 0),
        merged_in_(connectivity.vertex_slots(), 0) {}

  /// A new round. share: of the choices, 0..1.
  void begin(double share, const Parallel& parallel) {
    ++round_;
    find_limits(share);
    cut_into_blocks();
    for_blocks(parallel, [&](Block& block) { sort_into_classes(block); });
  }

  /// Fills edges() with candidates that lie apart; they are candidates no more.
  void pick(const Parallel& parallel) {
    ++pick_;
    for_blocks(parallel, [&](Block& block) { pick_inside(block); });
    for (Block& block : blocks_) pick_across(block);
    for_blocks(parallel, [](Block& block) {
      std::sort(block.edges.begin(), block.edges.end(), [](Edge e, Edge o) { return e.a < o.a; });
    });
    edges_.clear();
    for (const Block& block : blocks_)
      edges_.insert(edges_.end(), block.edges.begin(), block.edges.end());
  }

  /// To be told of the collapses of the picks: the edges at both ends are others now.
  void set_merged(Edge edge) { merged_in_[edge.a] = merged_in_[edge.b] = round_; }

  /// Apart from each other, in the order of their owners: near in memory, near in time.
  const std::vector<Edge>& edges() const { return edges_; }
  int candidates() const {
    return std::accumulate(blocks_.begin(), blocks_.end(), 0, [](int sum, const Block& block) {
      return sum + static_cast<int>(block.owners.size());
    });
  }
  /// What an edge of this round may cost at most.
  Priority limit() const { return limit_.back(); }

  void renumber(const Renumbering& numbers) {
    numbers.vertices(taken_in_), numbers.vertices(merged_in_);
  }

 private:
  static constexpr int classes = 8;  // of equal size
  static constexpr int small_class = 128;
  static constexpr int samples = 256;  // they tell the share within a tenth of it
  static constexpr double golden_ratio = 1.618033988749895;  // its multiples are spread evenly
  static constexpr int block_size = 4096;  // vertices: in a large one few edges reach across

  struct Block {
    int begin, end;           // vertices
    std::vector<int> owners;  // of the candidates that have not been picked
    std::vector<int> across;  // of those that this pick looks at after the others
    std::vector<Edge> edges;  // picked

    bool has(int v) const { return begin <= v && v < end; }
  };

  enum class Fate { Apart, TooNear, Across };

  template <class Work>
  void for_blocks(const Parallel& parallel, Work work) {
    const int count = static_cast<int>(blocks_.size());
    parallel.for_each(
        count, [&](int b) { work(blocks_[b]); }, Grain{1, count});
  }

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

  /// From round to round elsewhere: what lies across always comes last.
  void cut_into_blocks() {
    const std::int64_t vertices = connectivity_.vertex_slots(),
                       cuts = std::max<std::int64_t>(1, vertices / block_size) - 1;
    class_of_.resize(vertices);
    blocks_.resize(cuts + 1);
    const double shift = std::fmod(golden_ratio * round_, 1.0);
    int begin = 0;
    for (std::int64_t b = 0; b <= cuts; ++b) {
      blocks_[b].begin = begin;
      begin = b == cuts ? static_cast<int>(vertices)
                        : static_cast<int>(vertices * (b + 0.5 + shift) / (cuts + 1.0));
      blocks_[b].end = begin;
    }
  }

  /// A small class is sorted by cost. In a large one single edges do not show in the result: its
  /// order is that of the vertices, so that memory is read in order.
  void sort_into_classes(Block& block) {
    std::array<std::size_t, classes + 2> end{};
    for (int v = block.begin; v < block.end; ++v) ++end[1 + (class_of_[v] = class_of(v))];
    std::partial_sum(end.begin(), end.end(), end.begin());
    const auto begin = end;
    block.owners.resize(end[classes]);
    for (int v = block.begin; v < block.end; ++v)
      if (class_of_[v] < classes) block.owners[end[class_of_[v]]++] = v;
    for (int c = 0; c < classes; ++c)
      if (end[c] - begin[c] <= small_class)
        std::sort(block.owners.begin() + begin[c], block.owners.begin() + end[c],
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

  Edge edge_of(int owner) const { return {owner, choices_.of(owner).partner}; }

  void pick_inside(Block& block) {
    block.edges.clear(), block.across.clear();
    std::size_t waiting = 0;
    for (int owner : block.owners) {
      const Edge edge = edge_of(owner);
      if (merged(edge.a) || merged(edge.b)) continue;
      switch (fate(edge, block)) {
        case Fate::Apart: take(edge, block); break;
        case Fate::TooNear: block.owners[waiting++] = owner; break;
        case Fate::Across: block.across.push_back(owner); break;
      }
    }
    block.owners.resize(waiting);
  }

  void pick_across(Block& block) {
    const Block everything{0, connectivity_.vertex_slots(), {}, {}, {}};
    for (int owner : block.across)
      if (const Edge edge = edge_of(owner); fate(edge, everything) == Fate::Apart)
        take(edge, block);
      else
        block.owners.push_back(owner);
  }

  /// The fate of an edge of the block; nothing outside of it is read.
  Fate fate(Edge edge, const Block& block) const {
    if (!block.has(edge.b)) return Fate::Across;
    if (taken(edge.a) || taken(edge.b)) return Fate::TooNear;  // mostly seen here
    for (int v : {edge.a, edge.b})
      for (int f : connectivity_.faces_of(v))
        for (int u : connectivity_.face(f)) {
          if (!block.has(u)) return Fate::Across;
          if (taken(u)) return Fate::TooNear;
        }
    return Fate::Apart;
  }

  void take(Edge edge, Block& block) {
    for (int v : {edge.a, edge.b})
      for (int f : connectivity_.faces_of(v))
        for (int u : connectivity_.face(f)) taken_in_[u] = pick_;
    block.edges.push_back(edge);
  }

  const TriangleConnectivity& connectivity_;
  const EdgeChoices& choices_;
  int round_ = 0, pick_ = 0;
  std::vector<int> taken_in_;   // by vertex: the last pick with it in a neighbourhood
  std::vector<int> merged_in_;  // by vertex: the last round in which it was an end of a collapse
  std::vector<Priority> sample_;
  std::array<Priority, classes> limit_;  // of each class
  std::vector<std::uint8_t> class_of_;   // by vertex
  std::vector<Block> blocks_;
  std::vector<Edge> edges_;
};

}  // namespace curvdecim::detail
