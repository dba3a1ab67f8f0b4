// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "vcg_ext/attributes/attribute_blend.h"
#include "vcg_ext/parallel/radix_sort.h"
#include "vcg_ext/passes/fan_collapse.h"
#include "vcg_ext/passes/pass_ranks.h"

namespace curvdecim::detail {

/// The collapses of one pass: of the proposed edges those that cost no more than a limit. A vertex
/// is merged once in a pass, so that the faces of one that was not are those of before, but for
/// neighbours that are others now.
///
/// Vertices that are numbered in a row lie close together. All cores work on blocks of them, on the
/// edges whose fans stay inside; then on larger blocks, with what reached across, up to the block
/// of all. The blocks do not depend on the number of threads.
///
/// MetricType: merged(PassWeight, PassWeight).
template <class MetricType>
class PassCollapses {
 public:
  PassCollapses(PassSurface& surface, const FanLists& fans, const PassRanks& ranks,
                const MetricType& metric, const FaceLimits& limits, const BlendRecord& record)
      : surface_(surface),
        fans_(fans),
        ranks_(ranks),
        metric_(metric),
        limits_(limits),
        record_(record),
        into_(surface.vertex_count()),
        merged_(surface.vertex_count(), 0) {
    std::iota(into_.begin(), into_.end(), 0);
  }

  /// Appends what was done to the steps, in an order in which it can be replayed.
  void run(double limit, const Parallel& parallel, BlendSteps& steps) {
    std::vector<int> left = proposers(parallel);
    for (int bits = least_bits; !left.empty(); bits += more_bits) {
      std::vector<Block> blocks = blocks_of(left, bits);
      const auto collapse_block = [&](int b) { collapse_inside(blocks[b], bits, limit); };
      parallel.for_each(static_cast<int>(blocks.size()), collapse_block, Grain{1, blocks_at_once});
      left.clear();
      steps.begin_stage();
      for (const Block& block : blocks) {
        steps.append(block.steps), steps.end_run();
        left.insert(left.end(), block.across.begin(), block.across.end());
        largest_cost_ = std::max(largest_cost_, block.largest_cost);
      }
    }
  }

  /// The cheapest ones in order, on one core, until so many are done. Appends them to the steps.
  void run_in_order(int most, double limit, const Parallel& parallel, BlendSteps& steps) {
    const Array<Keyed> order = by_rank(parallel);
    steps.begin_stage();
    FanCollapse collapse(surface_, fans_, limits_);
    for (auto v = order.begin(); v != order.end() && most > 0; ++v)
      most -= attempt(v->value, limit, collapse, steps, largest_cost_);
    steps.end_run();
  }

  /// By vertex: the one that it has become, or itself.
  const std::vector<int>& into() const { return into_; }

  double largest_cost() const { return largest_cost_; }

 private:
  static constexpr int least_bits = 12, more_bits = 2;  // of the numbers in a block
  static constexpr int blocks_at_once = 128;            // between two looks at whether to go on
  static constexpr int ahead = 8;                       // looks: about as long as memory takes

  struct Block {
    std::vector<int> proposers;
    std::vector<int> across;  // of these, proposers of edges that reach out of it
    BlendSteps steps;
    double largest_cost = 0.0;
  };

  std::vector<int> proposers(const Parallel& parallel) const {
    return indices_where(ranks_.count(), parallel,
                         [&](int v) { return ranks_.partner(v) != PassRanks::none; });
  }

  /// The proposers, the cheapest first.
  Array<Keyed> by_rank(const Parallel& parallel) const {
    constexpr int rank_bits = 32;
    const std::vector<int> all = proposers(parallel);
    return sorted_by_key(static_cast<int>(all.size()), rank_bits, parallel, [&](int i) {
      return Keyed{key_of(ranks_.rank(all[i])), all[i]};
    });
  }

  /// The proposers, ascending, by their numbers without the lowest bits.
  static std::vector<Block> blocks_of(const std::vector<int>& proposers, int bits) {
    std::vector<Block> blocks;
    for (auto first = proposers.begin(); first != proposers.end();) {
      const auto last = std::upper_bound(first, proposers.end(), *first | ((1 << bits) - 1));
      blocks.emplace_back();
      blocks.back().proposers.assign(first, last);
      first = last;
    }
    return blocks;
  }

  void collapse_inside(Block& block, int bits, double limit) {
    FanCollapse collapse(surface_, fans_, limits_);
    const int count = static_cast<int>(block.proposers.size());
    for (int i = 0; i < count; ++i) {
      const int v = block.proposers[i], later = block.proposers[std::min(i + ahead, count - 1)];
      collapse.fetch(later), collapse.fetch(ranks_.partner(later));
      if (ranks_.reach(v) <= bits)
        attempt(v, limit, collapse, block.steps, block.largest_cost);
      else
        block.across.push_back(v);
    }
  }

  bool attempt(int v, double limit, FanCollapse& collapse, BlendSteps& steps,
               double& largest_cost) {
    const int u = ranks_.partner(v);
    if (merged_[v] != 0 || merged_[u] != 0) return false;
    const auto candidate = collapse.look(v, u, into_, limit);
    if (!candidate) return false;
    const VertexMerge done = merge_of({v, u}, *candidate, surface_.position);
    if (surface_.weighs_attributes() && !suits_attributes(done, limit - candidate->cost, collapse))
      return false;
    if (done.now != done.keep_was) note(done, collapse, steps);
    merge(done);
    largest_cost = std::max(largest_cost, candidate->cost);
    return true;
  }

  /// May the merge be done at a price of no more than `most`? Then it is, in what is carried.
  bool suits_attributes(const VertexMerge& merge, double most, FanCollapse& collapse) {
    const auto now = collapse.look_at_attributes(merge.now);
    if (!now || now->price * surface_.importance_of(merge.keep, merge.gone) > most) return false;
    const int carrier = surface_.vertex_before[merge.keep];
    if (!surface_.texture.empty()) surface_.texture[carrier] = now->texture;
    if (!surface_.color.empty()) surface_.color[carrier] = now->color;
    return true;
  }

  void merge(const VertexMerge& merge) {
    const auto [keep, gone, keep_was, gone_was, now, t] = merge;
    surface_.memory[keep] =
        SmallQuadric(surface_.memory[keep].quadric().with_origin_moved(now - keep_was) +
                     surface_.memory[gone].quadric().with_origin_moved(now - gone_was));
    surface_.weight[keep] = metric_.merged(surface_.weight[keep], surface_.weight[gone]);
    if (!surface_.importance.empty())
      surface_.importance[keep] +=
          static_cast<float>(t) * (surface_.importance[gone] - surface_.importance[keep]);
    surface_.position[keep] = now;
    surface_.merges.note(surface_.vertex_before[gone], surface_.vertex_before[keep]);
    into_[gone] = keep;
    merged_[keep] = merged_[gone] = 1;
  }

  /// By the numbers before the passes.
  EdgeStep along(const VertexMerge& merge) const {
    return {surface_.vertex_before[merge.keep], surface_.vertex_before[merge.gone], float(merge.t)};
  }

  /// As the record asks for it.
  void note(const VertexMerge& merge, const FanCollapse& collapse, BlendSteps& steps) const {
    const EdgeStep on_edge = along(merge);
    if (!record_.is_over_surface()) return steps.on_edge.push_back(on_edge);
    steps.over_surface.push_back(record_.is_nearest()
                                     ? collapse.nearest_step(merge.now, on_edge)
                                     : step_on_edge(on_edge.keep, on_edge.gone, on_edge.t));
  }

  PassSurface& surface_;
  const FanLists& fans_;
  const PassRanks& ranks_;
  const MetricType& metric_;
  const FaceLimits& limits_;
  const BlendRecord& record_;
  std::vector<int> into_;             // by vertex
  std::vector<std::uint8_t> merged_;  // by vertex: 1 if it is part of a collapse of this pass
  double largest_cost_ = 0.0;
};

}  // namespace curvdecim::detail
