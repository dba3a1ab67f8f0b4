// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "vcg_ext/metric/least_cost.h"
#include "vcg_ext/metric/placement.h"
#include "vcg_ext/parallel/array.h"
#include "vcg_ext/parallel/radix_sort.h"
#include "vcg_ext/passes/fan_lists.h"
#include "vcg_ext/passes/lanes.h"
#include "vcg_ext/passes/pass_surface.h"

namespace curvdecim::detail {

/// What the edges of a surface cost about, at the start of a pass: each vertex proposes the one to
/// the neighbour that lies nearest to its planes. All in single precision, positions too: what
/// comes of a rank is looked at again.
class PassRanks {
 public:
  static constexpr int none = -1;

  void measure(const PassSurface& surface, const FanLists& fans, const Parallel& parallel) {
    const int vertices = surface.vertex_count();
    point_.resize(vertices), matrix_.resize(vertices);
    partner_.resize(vertices), rank_.resize(vertices), reach_.resize(vertices);
    parallel.for_each(vertices, [&](int v) {
      point_[v].lanes = row(surface.position[v], surface.weight[v].factor);
    });
    propose(surface, fans, parallel);
    parallel.for_each(lane_groups(vertices), [&](int group) { rank(surface, group); });
  }

  /// none: v proposes no edge.
  int partner(int v) const { return partner_[v]; }
  float rank(int v) const { return rank_[v]; }
  int count() const { return static_cast<int>(rank_.size()); }

  /// The edge that v proposes and the faces at its ends have only vertices whose numbers agree with
  /// v's but for the lowest bits, so many.
  int reach(int v) const { return std::max(reach_[v], reach_[partner_[v]]); }

  /// Takes the cheapest proposals, so many and at most this share of them, and drops the others. Of
  /// those that cost the same some are left out evenly. Returns the highest rank.
  float choose(int wanted, double share) {
    std::vector<int> of_bucket(buckets, 0);
    int proposals = 0;
    for (int v = 0; v < count(); ++v)
      if (partner_[v] != none) ++of_bucket[bucket(rank_[v])], ++proposals;
    int left = std::min(wanted, static_cast<int>(share * proposals)), last = 0;
    for (; last + 1 < buckets && left > of_bucket[last]; ++last) left -= of_bucket[last];
    drop_above(last, left, of_bucket[last]);
    return end_of(last);
  }

 private:
  /// Four numbers of a vertex or a face.
  struct Row {
    Lanes lanes;
  };

  struct Matrix {
    float xx, yy, zz, xy, yz, xz;
  };

  static std::uint8_t bits_of(std::uint32_t x) {
    std::uint8_t bits = 0;
    for (; x != 0; x >>= 1) ++bits;
    return bits;
  }

  /// With the roots of the faces' matrices: each is the outer product of a vector with itself.
  void propose(const PassSurface& surface, const FanLists& fans, const Parallel& parallel) {
    Array<Row> roots(surface.face_count());
    parallel.for_each(lane_groups(surface.face_count()),
                      [&](int group) { measure_roots(surface, group, roots); });
    parallel.for_each(surface.vertex_count(), [&](int v) { propose(surface, fans, roots, v); });
  }

  void measure_roots(const PassSurface& surface, int group, Array<Row>& roots) const {
    const int first = lane_count * group;
    const auto face = [&](int lane) -> const Face& {
      return surface.faces[std::min(first + lane, surface.face_count() - 1)];
    };
    const auto corners = [&](int i) {
      return Columns::of([&](int lane) { return point_[face(lane)[i]].lanes; });
    };
    const Columns a = corners(0), b = corners(1), c = corners(2);
    const VectorLanes n = (b.at - a.at).cross(c.at - a.at);
    const Lanes length = root(n.squared()), weight = PassSurface::half_a_third * (a.w + b.w + c.w);
    const VectorLanes m = n * (length > 0.0f ? root(weight / length) : Lanes{});
    const Columns rows(m.x, m.y, m.z, Lanes{});
    const std::array<Lanes, lane_count> of_lane = {rows.at.x, rows.at.y, rows.at.z, rows.w};
    for (int lane = 0; lane < lane_count && first + lane < surface.face_count(); ++lane)
      roots[first + lane].lanes = of_lane[lane];
  }

  /// Adds the planes of the faces around v to what it remembers.
  void propose(const PassSurface& surface, const FanLists& fans, const Array<Row>& roots, int v) {
    partner_[v] = none;
    const IndexRange fan = fans.of(v);
    if (fan.size() == 0) return;
    const SmallQuadric& memory = surface.memory[v];
    Lanes diagonal = load(&memory.xx), others = load(&memory.xy);  // the last are other numbers
    for (int f : fan) {
      const Lanes m = roots[f].lanes;
      diagonal += m * m, others += m * yzx(m);
    }
    matrix_[v] = {diagonal[0], diagonal[1], diagonal[2], others[0], others[1], others[2]};
    float least = std::numeric_limits<float>::infinity();
    std::uint32_t differences = 0;
    for (int f : fan) {
      const int next = next_in(surface.faces[f], v);
      differences |= static_cast<std::uint32_t>(next ^ v);
      const Lanes step = point_[next].lanes - point_[v].lanes;
      const float lift = sum3(diagonal * (step * step) + 2.0f * others * (step * yzx(step)));
      if (lift < least && fans.has(next)) least = lift, partner_[v] = next;
    }
    reach_[v] = bits_of(differences);
  }

  /// Short edges first where nothing else tells them apart.
  void rank(const PassSurface& surface, int group) {
    constexpr float tie = 1e-8f;  // to the trace and the squared length
    const int first = lane_count * group;
    std::array<int, lane_count> v, u;
    for (int lane = 0; lane < lane_count; ++lane) {
      v[lane] = std::min(first + lane, count() - 1);
      u[lane] = partner_[v[lane]] == none ? v[lane] : partner_[v[lane]];
    }
    const Columns at_v = Columns::of([&](int lane) { return point_[v[lane]].lanes; });
    const Columns at_u = Columns::of([&](int lane) { return point_[u[lane]].lanes; });
    const VectorLanes step = at_u.at - at_v.at;
    const VertexLanes<Lanes> p = lanes_at(surface, v, VectorLanes{}),
                             q = lanes_at(surface, u, step);
    const Lanes cost = least_costs(p, q, scale);
    const Lanes trace = p.xx + p.yy + p.zz + q.xx + q.yy + q.zz;
    const Lanes factor = 0.5f * (at_v.w + at_u.w);
    const Lanes ranks = factor * ((cost > 0.0f ? cost : Lanes{}) + tie * trace * step.squared());
    for (int lane = 0; lane < lane_count && first + lane < count(); ++lane)
      rank_[v[lane]] = partner_[v[lane]] == none
                           ? std::numeric_limits<float>::infinity()
                           : ranks[lane] * surface.importance_of(v[lane], u[lane]);
  }

  /// The vertices `which`, at `at`.
  VertexLanes<Lanes> lanes_at(const PassSurface& surface, const std::array<int, lane_count>& which,
                              const VectorLanes& at) const {
    const auto columns = [&](auto first_of) {
      return Columns::of([&](int lane) { return load(first_of(which[lane])); });
    };
    const Columns first = columns([&](int v) { return &matrix_[v].xx; });
    const Columns last = columns([&](int v) { return &matrix_[v].zz; });
    const Columns linear = columns([&](int v) { return &surface.memory[v].xz; });    // and b
    const Columns constant = columns([&](int v) { return &surface.memory[v].xx; });  // the last: c
    return {at.x,      at.y,       at.z,        first.at.x,  first.w,  last.w,    first.at.y,
            last.at.z, first.at.z, linear.at.y, linear.at.z, linear.w, constant.w};
  }

  static constexpr CostScale<float> scale{float(relative_pull), 1e-12f};  // a millionth of the edge

  // Each has a 32nd of an octave.
  static constexpr int buckets = 1 << 13, dropped_bits = 32 - 13;

  static int bucket(float rank) { return static_cast<int>(key_of(rank) >> dropped_bits); }

  static float end_of(int bucket) {
    const std::uint32_t bits = ((static_cast<std::uint32_t>(bucket) + 1) << dropped_bits) - 1;
    float end;
    std::memcpy(&end, &bits, sizeof end);
    return end;
  }

  /// In the last bucket `left` of its `all` stay.
  void drop_above(int last, int left, int all) {
    std::int64_t due = 0;
    for (int v = 0; v < count(); ++v) {
      if (partner_[v] == none) continue;
      const int its = bucket(rank_[v]);
      if (its == last) due += left;
      if (its > last || (its == last && due < all)) partner_[v] = none;
      if (its == last && due >= all) due -= all;
    }
  }

  Array<Row> point_;           // by vertex: its position, and the factor on its planes
  Array<Matrix> matrix_;       // by vertex: of its faces and its memory
  Array<int> partner_;         // by vertex
  Array<float> rank_;          // by vertex
  Array<std::uint8_t> reach_;  // by vertex: bits in which a neighbour's number differs
};

}  // namespace curvdecim::detail
