// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "vcg_ext/attributes/attribute_blend.h"
#include "vcg_ext/guard/limits.h"
#include "vcg_ext/metric/metric.h"
#include "vcg_ext/metric/placement.h"
#include "vcg_ext/passes/fan_points.h"
#include "vcg_ext/passes/pass_surface.h"

namespace curvdecim::detail {

/// The neighbours of a vertex as a pass has left them so far, in order.
class Ring {
 public:
  /// The fan of a vertex that has not changed in this pass, from neighbour `first` on; into: by
  /// vertex, what it has become. False where that is no fan any more.
  bool gather(IndexRange fan, const std::vector<int>& into, int first) {
    size_ = 0;
    for (int u : fan)
      if (const int now = into[u]; size_ == 0 || last() != now) vertices_[size_++] = now;
    if (size_ > 1 && last() == vertices_[0]) --size_;
    const auto start = std::find(vertices_.begin(), vertices_.begin() + size_, first);
    if (size_ < 3 || start == vertices_.begin() + size_) return false;
    std::rotate(vertices_.begin(), start, vertices_.begin() + size_);
    return true;
  }

  int size() const { return size_; }
  int operator[](int i) const { return vertices_[i]; }
  int last() const { return vertices_[size_ - 1]; }

 private:
  std::array<int, FanLists::longest> vertices_;
  int size_ = 0;
};

/// Looks at single edges between vertices with closed fans, as the surface is now. What it does not
/// allow waits: for another pass, or for the guards that have prices (guard/collapse_guards.h).
class FanCollapse {
 public:
  FanCollapse(const PassSurface& surface, const FanLists& fans, const FaceLimits& limits)
      : surface_(surface),
        fans_(fans),
        least_cosine_(static_cast<float>(least_cosine(limits, 1.0))) {}

  /// Neither a nor b has changed in this pass; into: by vertex, what it has become. nullopt: it
  /// costs more than `limit`, or is not allowed.
  std::optional<Candidate> look(int a, int b, const std::vector<int>& into, double limit) {
    if (!a_.gather(fans_.of(a), into, b) || !b_.gather(fans_.of(b), into, a)) return std::nullopt;
    if (!keeps_topology()) return std::nullopt;
    const Vector3 half = 0.5 * (surface_.position[b] - surface_.position[a]);
    const Vector3 middle = surface_.position[a] + half;
    const FanPoints around_a = points_of(a_, middle), around_b = points_of(b_, middle);
    const FanFaces of_a(around_a, -half, surface_.weight[a].factor);
    const FanFaces of_b(around_b, half, surface_.weight[b].factor);
    const Minimum least = least_of(a, b, half, of_a, of_b);
    const double cost = least.value * surface_.weight_of(a, b);
    if (cost > limit || stands_off(least.offset, half)) return std::nullopt;
    if (spoils(around_a, of_a, least.offset) || spoils(around_b, of_b, least.offset))
      return std::nullopt;
    return Candidate{cost, in_place(least.offset, a, b, half), parameter_along(half, least.offset)};
  }

  /// Where on the faces around the edge that was looked at last, before it collapses, x is nearest,
  /// by the vertices' numbers before the passes. along: the step on the edge.
  BlendStep nearest_step(const Vector3& x, const EdgeStep& along) const {
    NearestStep nearest(x, step_on_edge(along.keep, along.gone, along.t));
    look_at_faces(b_[0], a_, nearest), look_at_faces(a_[0], b_, nearest);
    return nearest.step();
  }

 private:
  /// Those of the fan that a ring has with its centre.
  void look_at_faces(int center, const Ring& ring, NearestStep& nearest) const {
    for (int i = 0; i < ring.size(); ++i) {
      const Face face{center, ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]};
      const Triangle triangle = triangle_of(surface_.position, face);
      Face before;
      for (int k = 0; k < 3; ++k) before[k] = surface_.vertex_before[face[k]];
      nearest.look_at(triangle, face_plane(triangle).normal, before);
    }
  }

  /// Both ends have the edge's two faces, and no other neighbour in common.
  bool keeps_topology() const {
    if (a_[1] != b_.last() || a_.last() != b_[1]) return false;
    const int merged = a_.size() + b_.size() - 4;
    if (merged < 3 || merged > FanLists::longest) return false;
    for (int i = 2; i + 1 < a_.size(); ++i)
      for (int j = 2; j + 1 < b_.size(); ++j)
        if (a_[i] == b_[j]) return false;
    return true;
  }

  FanPoints points_of(const Ring& ring, const Vector3& origin) const {
    FanPoints points(origin);
    for (int i = 0; i < ring.size(); ++i)
      points.add(surface_.position[ring[i]], surface_.weight[ring[i]].factor);
    points.close();
    return points;
  }

  /// About the edge's middle. All that is in the surface, but for rounding, costs nothing.
  Minimum least_of(int a, int b, const Vector3& half, const FanFaces& of_a,
                   const FanFaces& of_b) const {
    constexpr double rounding = 1e-6;  // part of the edge, in single precision
    Quadric around_a = surface_.memory[a].quadric(), around_b = surface_.memory[b].quadric();
    around_a.a += of_a.matrix(), around_b.a += of_b.matrix();
    const QuadricOfEdge q = sum_about_midpoint(around_a, around_b, half);
    const Vector3 wings = of_a.area_of(0) + of_a.area_of(a_.size() - 1);
    const KeepingPlane volume{of_a.area() + of_b.area() - wings,
                              half.dot(of_b.area() - of_a.area())};
    Minimum least = optimal_minimum(q, volume, half);
    if (least.value <= rounding * rounding * half.squaredNorm() * q.sum.a.trace())
      least.value = 0.0;
    return least;
  }

  /// Where a quadric is no measure any more (guard/spike.h).
  static bool stands_off(const Vector3& offset, const Vector3& half) {
    constexpr double near = 2.0;
    return offset.squaredNorm() > near * half.squaredNorm();
  }

  /// True if a face of the fan, but for the edge's two at its ends, would turn too far or become a
  /// sliver out of a better one, were the centre at x.
  bool spoils(const FanPoints& fan, const FanFaces& faces, const Vector3& x) const {
    for (int g = 0; g < fan.groups(); ++g) {
      const LaneMask bad = is_spoiled(fan.points(g), fan.following(g), faces, g, lanes_of(x));
      for (int lane = 0; lane < lane_count; ++lane) {
        const int i = lane_count * g + lane;
        if (bad[lane] != 0 && i > 0 && i + 1 < fan.size()) return true;
      }
    }
    return false;
  }

  /// By lane.
  LaneMask is_spoiled(const VectorLanes& p, const VectorLanes& q, const FanFaces& faces, int group,
                      const VectorLanes& x) const {
    constexpr float fair = 0.01f;  // as FaceGuard has it, of shape_quality
    constexpr float fair_length = static_cast<float>(2.0 * fair / four_root_three);
    const VectorLanes now = (p - x).cross(q - x);
    const Lanes length = root(now.squared()), before = faces.lengths(group);
    const Lanes third = (q - p).squared();
    const Lanes edges = (p - x).squared() + (q - x).squared() + third;
    const Lanes edges_before =
        (p - faces.center()).squared() + (q - faces.center()).squared() + third;
    const LaneMask turns = now.dot(faces.normals(group)) < least_cosine_ * length * before;
    const LaneMask is_sliver =
        (length < fair_length * edges) & (length * edges_before < before * edges);
    return turns | is_sliver;
  }

  /// An end itself is not rounded.
  Vector3 in_place(const Vector3& offset, int a, int b, const Vector3& half) const {
    if (offset == -half) return surface_.position[a];
    if (offset == half) return surface_.position[b];
    return surface_.position[a] + (half + offset);
  }

  const PassSurface& surface_;
  const FanLists& fans_;
  const float least_cosine_;
  Ring a_, b_;
};

}  // namespace curvdecim::detail
