// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "vcg_ext/passes/fan_lists.h"
#include "vcg_ext/passes/lanes.h"
#include "vcg_ext/passes/pass_surface.h"

namespace curvdecim::detail {

/// The faces around a vertex that has not merged in this pass, as the pass has left them so far, by
/// their two other vertices. Those at the edge to another vertex, the wings, come first: the one
/// that has the edge in its direction, and the one that has it against. Behind the last come, up to
/// the end of its group of as many as there are lanes, faces that are but the centre.
class FanCorners {
 public:
  static constexpr int wings = 2;

  /// into: by vertex, what it has become. False where the edge has no two wings any more.
  bool gather(const PassSurface& surface, const FanLists& fans, const std::vector<int>& into, int v,
              int other) {
    center_ = v, size_ = wings;
    next_[0] = next_[1] = none;
    for (int f : fans.of(v)) {
      const Face& face = surface.faces[f];
      const int after = next_in(face, v);
      const int next = into[after], last = into[face[0] ^ face[1] ^ face[2] ^ v ^ after];
      if (next == last) continue;  // it has become an edge
      const int with = next == other, against = last == other;
      const int at = with != 0 ? 0 : against != 0 ? 1 : size_;
      next_[at] = next, last_[at] = last, face_[at] = f;
      size_ += 1 - (with | against);
    }
    std::fill_n(&next_[size_], lane_count, v), std::fill_n(&last_[size_], lane_count, v);
    return next_[0] != none && next_[1] != none;
  }

  int center() const { return center_; }
  int size() const { return size_; }
  int groups() const { return lane_groups(size_); }

  /// The corners that follow the centre, and those before it.
  int next(int i) const { return next_[i]; }
  int last(int i) const { return last_[i]; }

  /// The number that the face has.
  int face(int i) const { return face_[i]; }

  /// Whether a neighbour, but for those in the wings, is one of the other's.
  bool meets(const FanCorners& other) const {
    LaneMask same{};
    for (int j = wings; j < other.size_; ++j)
      for (int i = wings; i < size_; i += lane_count) same |= load(&next_[i]) == other.next_[j];
    return any(same);
  }

 private:
  static constexpr int none = -1;
  static constexpr int room = FanLists::longest + wings + lane_count;

  int center_ = none, size_ = 0;
  std::array<int, room> next_, last_, face_;
};

/// The faces of such a fan, in groups of as many as there are lanes, and what their planes add up
/// to.
class FanFaces {
 public:
  /// center: where the fan's centre is, about the origin.
  FanFaces(const PassSurface& surface, const FanCorners& fan, const Vector3& origin,
           const Vector3& center)
      : size_(fan.size()), center_(lanes_of(center)) {
    const float factor = surface.weight[fan.center()].factor;
    Lanes xx{}, xy{}, xz{}, yy{}, yz{}, zz{}, nx{}, ny{}, nz{};
    for (int g = 0; g < fan.groups(); ++g) {
      const auto point = [&](int v) {
        return row(surface.position[v] - origin, surface.weight[v].factor);
      };
      const int first = lane_count * g;
      const auto next = Columns::of([&](int lane) { return point(fan.next(first + lane)); });
      const auto last = Columns::of([&](int lane) { return point(fan.last(first + lane)); });
      const VectorLanes n = (next.at - center_).cross(last.at - center_);
      const Lanes length = root(n.squared());
      const Lanes weight = PassSurface::half_a_third * (next.w + last.w + factor);
      const VectorLanes w = n * (length > 0.0f ? weight / length : Lanes{});
      xx += w.x * n.x, xy += w.x * n.y, xz += w.x * n.z;
      yy += w.y * n.y, yz += w.y * n.z, zz += w.z * n.z;
      nx += n.x, ny += n.y, nz += n.z;
      next_[g] = next.at, last_[g] = last.at, normal_[g] = n, length_[g] = length;
    }
    matrix_ = {sum(xx), sum(xy), sum(xz), sum(yy), sum(yz), sum(zz)};
    area_ = 0.5 * Vector3(sum(nx), sum(ny), sum(nz));
  }

  /// Sum of area n n^T, each times the mean of the factors at the face's corners.
  const Symmetric3& matrix() const { return matrix_; }

  /// Sum of the area vectors, and that of the wings.
  const Vector3& area() const { return area_; }
  Vector3 area_of_wings() const {
    const VectorLanes& n = normal_[0];
    return 0.5 * Vector3(n.x[0] + n.x[1], n.y[0] + n.y[1], n.z[0] + n.z[1]);
  }

  /// True if a face, but for the wings, would turn too far or become a sliver out of a better one,
  /// were the centre at x.
  bool are_spoiled(const Vector3& x, float least_cosine) const {
    const VectorLanes there = lanes_of(x);
    LaneMask bad = is_spoiled(0, there, least_cosine) & LaneMask{0, 0, -1, -1};  // not the wings
    for (int g = 1; lane_count * g < size_; ++g) bad |= is_spoiled(g, there, least_cosine);
    return any(bad);
  }

 private:
  static constexpr int most_groups = lane_groups(FanLists::longest);

  LaneMask is_spoiled(int group, const VectorLanes& x, float least_cosine) const {
    constexpr float fair = 0.01f;  // as FaceGuard has it, of shape_quality
    constexpr float fair_length = static_cast<float>(2.0 * fair / four_root_three);
    const VectorLanes &p = next_[group], &q = last_[group];
    const VectorLanes now = (p - x).cross(q - x);
    const Lanes length = root(now.squared()), before = length_[group];
    const Lanes third = (q - p).squared();
    const Lanes edges = (p - x).squared() + (q - x).squared() + third;
    const Lanes edges_before = (p - center_).squared() + (q - center_).squared() + third;
    const LaneMask turns = now.dot(normal_[group]) < least_cosine * length * before;
    const LaneMask is_sliver =
        (length < fair_length * edges) & (length * edges_before < before * edges);
    return turns | is_sliver;
  }

  const int size_;
  const VectorLanes center_;
  Symmetric3 matrix_;
  Vector3 area_;
  std::array<VectorLanes, most_groups> next_, last_, normal_;  // by group; normals: twice the area
  std::array<Lanes, most_groups> length_;                      // of normals
};

}  // namespace curvdecim::detail
