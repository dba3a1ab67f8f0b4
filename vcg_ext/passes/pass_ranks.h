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
#include "vcg_ext/passes/fan_points.h"
#include "vcg_ext/passes/pass_surface.h"

namespace curvdecim::detail {

/// What the edges of a surface cost about, at the start of a pass: each vertex proposes the one to
/// the neighbour that lies nearest to its planes.
class PassRanks {
 public:
  static constexpr int none = -1;

  void measure(const PassSurface& surface, const FanLists& fans, const Parallel& parallel) {
    const int count = surface.vertex_count();
    quadric_.resize(count), partner_.resize(count), rank_.resize(count);
    parallel.for_each(count, [&](int v) { propose(surface, fans, v); });
    const int groups = (count + lane_count - 1) / lane_count;
    parallel.for_each(groups, [&](int group) { rank(surface, lane_count * group); });
  }

  /// none: v proposes no edge.
  int partner(int v) const { return partner_[v]; }
  float rank(int v) const { return rank_[v]; }
  int count() const { return static_cast<int>(rank_.size()); }

  /// A rank that about so many of the proposals do not exceed, and at most this share of them.
  float limit(int wanted, double share) const {
    std::vector<int> of_bucket(buckets, 0);
    int proposals = 0;
    for (int v = 0; v < count(); ++v)
      if (partner_[v] != none) ++of_bucket[bucket(rank_[v])], ++proposals;
    int left = std::min(wanted, static_cast<int>(share * proposals)), last = 0;
    for (; last + 1 < buckets && left > of_bucket[last]; ++last) left -= of_bucket[last];
    return end_of(last);
  }

 private:
  /// Adds the planes of the faces around v to what it remembers.
  void propose(const PassSurface& surface, const FanLists& fans, int v) {
    const IndexRange fan = fans.of(v);
    partner_[v] = none;
    if (fan.size() == 0) return;
    FanPoints points(surface.position[v]);
    for (int u : fan) points.add(surface.position[u], surface.weight[u].factor);
    points.close();
    Quadric q = surface.memory[v].quadric();
    q.a += FanFaces(points, Vector3::Zero(), surface.weight[v].factor).matrix();
    quadric_[v] = SmallQuadric(q);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < fan.size(); ++i) {
      const Vector3 step = points.point(i);
      const double lift = step.dot(q.a * step);
      if (lift < least && fans.of(fan.first[i]).size() > 0)
        least = lift, partner_[v] = fan.first[i];
    }
  }

  /// Ranks as many vertices as there are lanes, from `first` on.
  void rank(const PassSurface& surface, int first) {
    std::array<int, lane_count> v, u;
    for (int lane = 0; lane < lane_count; ++lane) {
      v[lane] = std::min(first + lane, count() - 1);
      u[lane] = partner_[v[lane]] == none ? v[lane] : partner_[v[lane]];
    }
    const Lanes cost = least_costs(lanes_at(surface, v, v), lanes_at(surface, u, v), scale);
    for (int lane = 0; lane < lane_count && first + lane < count(); ++lane)
      rank_[v[lane]] = partner_[v[lane]] == none ? std::numeric_limits<float>::infinity()
                                                 : weighted(surface, cost[lane], v[lane], u[lane]);
  }

  /// Short edges first where nothing else tells them apart.
  float weighted(const PassSurface& surface, float cost, int a, int b) const {
    constexpr double tie = 1e-8;  // to the trace and the squared length
    const double length2 = (surface.position[a] - surface.position[b]).squaredNorm();
    const double between = tie * (quadric_[a].trace() + quadric_[b].trace()) * length2;
    return static_cast<float>(surface.weight_of(a, b) * (std::max(0.0f, cost) + between));
  }

  /// The vertices `which`, about the vertices `origin`.
  VertexLanes<Lanes> lanes_at(const PassSurface& surface, const std::array<int, lane_count>& which,
                              const std::array<int, lane_count>& origin) const {
    VertexLanes<Lanes> lanes;
    for (int i = 0; i < lane_count; ++i) {
      const SmallQuadric& q = quadric_[which[i]];
      const Vector3 at = surface.position[which[i]] - surface.position[origin[i]];
      lanes.x[i] = float(at.x()), lanes.y[i] = float(at.y()), lanes.z[i] = float(at.z());
      lanes.xx[i] = q.xx, lanes.xy[i] = q.xy, lanes.xz[i] = q.xz;
      lanes.yy[i] = q.yy, lanes.yz[i] = q.yz, lanes.zz[i] = q.zz;
      lanes.bx[i] = q.bx, lanes.by[i] = q.by, lanes.bz[i] = q.bz, lanes.c[i] = q.c;
    }
    return lanes;
  }

  static constexpr CostScale<float> scale{float(relative_pull), 1e-12f};  // a millionth of the edge

  // The bits of a float that is not negative are in its order: a bucket has a 32nd of an octave.
  static constexpr int buckets = 1 << 13, dropped_bits = 32 - 13;

  static int bucket(float rank) {
    std::uint32_t bits;
    std::memcpy(&bits, &rank, sizeof bits);
    return static_cast<int>(bits >> dropped_bits);
  }

  static float end_of(int bucket) {
    const std::uint32_t bits = ((static_cast<std::uint32_t>(bucket) + 1) << dropped_bits) - 1;
    float end;
    std::memcpy(&end, &bits, sizeof end);
    return end;
  }

  std::vector<SmallQuadric> quadric_;  // by vertex: of its faces and its memory
  std::vector<int> partner_;           // by vertex
  std::vector<float> rank_;            // by vertex
};

}  // namespace curvdecim::detail
