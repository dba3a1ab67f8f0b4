// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "vcg_ext/attributes/attribute_blend.h"
#include "vcg_ext/passes/fan_collapse.h"
#include "vcg_ext/passes/pass_ranks.h"

namespace curvdecim::detail {

/// The collapses of one pass: of the proposed edges those that cost no more than a limit. A vertex
/// is merged once in a pass, so that the fan of one that was not is its ring, but for neighbours
/// that are others now.
///
/// All cores work on blocks of vertices that are numbered in a row, and so lie close together, on
/// the edges whose fans stay inside; what reaches across blocks comes after these, one by one. The
/// blocks do not depend on the number of threads.
///
/// MetricType: merged(PassWeight, PassWeight).
template <class MetricType>
class PassCollapses {
 public:
  PassCollapses(PassSurface& surface, const FanLists& fans, const PassRanks& ranks,
                const MetricType& metric, const FaceLimits& limits, bool over_surface)
      : surface_(surface),
        fans_(fans),
        ranks_(ranks),
        metric_(metric),
        limits_(limits),
        over_surface_(over_surface),
        into_(surface.vertex_count()),
        merged_(surface.vertex_count(), 0),
        blocks_((surface.vertex_count() + block_size - 1) / block_size) {
    std::iota(into_.begin(), into_.end(), 0);
  }

  /// Appends what was done to the steps, in an order in which it can be replayed.
  void run(float limit, const Parallel& parallel, BlendSteps& steps) {
    const int count = static_cast<int>(blocks_.size());
    parallel.for_each(
        count, [&](int b) { collapse_inside(b, limit); }, Grain{1, blocks_at_once});
    FanCollapse collapse(surface_, fans_, limits_);
    for (const Block& block : blocks_) steps.append(block.steps);
    for (const Block& block : blocks_)
      for (int v : block.across) attempt(v, limit, collapse, steps);
  }

  /// By vertex: the one that it has become, or itself.
  const std::vector<int>& into() const { return into_; }

 private:
  static constexpr int block_size = 4096;     // vertices: in a large one few edges reach across
  static constexpr int blocks_at_once = 128;  // between two looks at whether to go on

  struct Block {
    std::vector<int> across;  // proposers of edges that reach out of it
    BlendSteps steps;
  };

  void collapse_inside(int b, float limit) {
    FanCollapse collapse(surface_, fans_, limits_);
    Block& block = blocks_[b];
    const int end = std::min(surface_.vertex_count(), (b + 1) * block_size);
    for (int v = b * block_size; v < end; ++v) {
      const int u = ranks_.partner(v);
      if (u == PassRanks::none || ranks_.rank(v) > limit) continue;
      if (is_inside(v, b) && is_inside(u, b))
        attempt(v, limit, collapse, block.steps);
      else
        block.across.push_back(v);
    }
  }

  /// v with its fan.
  bool is_inside(int v, int block) const {
    const auto in_block = [&](int u) { return u / block_size == block; };
    const IndexRange fan = fans_.of(v);
    return in_block(v) && std::all_of(fan.begin(), fan.end(), in_block);
  }

  void attempt(int v, float limit, FanCollapse& collapse, BlendSteps& steps) {
    const int u = ranks_.partner(v);
    if (merged_[v] != 0 || merged_[u] != 0) return;
    const auto candidate = collapse.look(v, u, into_, limit);
    if (candidate) merge(merge_of({v, u}, *candidate, surface_.position), collapse, steps);
  }

  void merge(const VertexMerge& merge, const FanCollapse& collapse, BlendSteps& steps) {
    const auto [keep, gone, keep_was, gone_was, now, t] = merge;
    surface_.memory[keep] =
        SmallQuadric(surface_.memory[keep].quadric().with_origin_moved(now - keep_was) +
                     surface_.memory[gone].quadric().with_origin_moved(now - gone_was));
    surface_.weight[keep] = metric_.merged(surface_.weight[keep], surface_.weight[gone]);
    if (!surface_.importance.empty())
      surface_.importance[keep] +=
          static_cast<float>(t) * (surface_.importance[gone] - surface_.importance[keep]);
    if (now != keep_was) note(merge, collapse, steps);
    surface_.position[keep] = now;
    into_[gone] = keep;
    merged_[keep] = merged_[gone] = 1;
  }

  /// By the numbers before the passes.
  void note(const VertexMerge& merge, const FanCollapse& collapse, BlendSteps& steps) const {
    const EdgeStep along{surface_.vertex_before[merge.keep], surface_.vertex_before[merge.gone],
                         float(merge.t)};
    if (over_surface_)
      steps.over_surface.push_back(collapse.nearest_step(merge.now, along));
    else
      steps.on_edge.push_back(along);
  }

  PassSurface& surface_;
  const FanLists& fans_;
  const PassRanks& ranks_;
  const MetricType& metric_;
  const FaceLimits& limits_;
  const bool over_surface_;           // that the steps go
  std::vector<int> into_;             // by vertex
  std::vector<std::uint8_t> merged_;  // by vertex: 1 if it is part of a collapse of this pass
  std::vector<Block> blocks_;
};

}  // namespace curvdecim::detail
