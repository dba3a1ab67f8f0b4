// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "vcg_ext/geometry/symmetric3.h"
#include "vcg_ext/geometry/vector3.h"
#include "vcg_ext/passes/fan_lists.h"
#include "vcg_ext/passes/lanes.h"

namespace curvdecim::detail {

/// The points of a closed fan about an origin, and their factors, in groups of as many as there are
/// lanes: each point stands for the face between it, the one that follows, and the fan's centre.
/// Behind the last comes the first again, up to the end of its group: those faces are empty.
class FanPoints {
 public:
  explicit FanPoints(const Vector3& origin) : origin_(origin) { set(0, Vector3::Zero(), 0.0f); }

  /// FanLists::longest at most.
  void add(const Vector3& p, float factor) { set(size_++, p - origin_, factor); }

  /// To be called after the last one.
  void close() {
    const Vector3 first = point(0);
    for (int i = size_; i <= groups() * lane_count; ++i) set(i, first, factor_[0]);
  }

  int size() const { return size_; }
  int groups() const { return (size_ + lane_count - 1) / lane_count; }

  Vector3 point(int i) const { return {x_[i], y_[i], z_[i]}; }
  VectorLanes points(int group) const { return from(lane_count * group); }
  VectorLanes following(int group) const { return from(lane_count * group + 1); }

  /// Factors of a point and of the following one, summed.
  Lanes factors(int group) const {
    const float* const first = &factor_[lane_count * group];
    return load(first) + load(first + 1);
  }

 private:
  static constexpr int room = FanLists::longest + lane_count + 1;

  void set(int i, const Vector3& p, float factor) {
    x_[i] = static_cast<float>(p.x());
    y_[i] = static_cast<float>(p.y());
    z_[i] = static_cast<float>(p.z());
    factor_[i] = factor;
  }

  VectorLanes from(int i) const { return {load(&x_[i]), load(&y_[i]), load(&z_[i])}; }

  const Vector3 origin_;
  int size_ = 0;
  std::array<float, room> x_, y_, z_, factor_;
};

/// The faces of a closed fan around its centre, and what their planes add up to.
class FanFaces {
 public:
  /// center: about the origin of the points; factor: of the centre.
  FanFaces(const FanPoints& fan, const Vector3& center, float factor) : center_(lanes_of(center)) {
    Lanes xx{}, xy{}, xz{}, yy{}, yz{}, zz{}, nx{}, ny{}, nz{};
    for (int g = 0; g < fan.groups(); ++g) {
      const VectorLanes n = (fan.points(g) - center_).cross(fan.following(g) - center_);
      const Lanes length = root(n.squared());
      const Lanes sum_of_factors = fan.factors(g) + factor;
      const VectorLanes w = n * (length > 0.0f ? half_a_third * sum_of_factors / length : Lanes{});
      xx += w.x * n.x, xy += w.x * n.y, xz += w.x * n.z;
      yy += w.y * n.y, yz += w.y * n.z, zz += w.z * n.z;
      nx += n.x, ny += n.y, nz += n.z;
      normal_[g] = n, length_[g] = length;
    }
    matrix_ = {sum(xx), sum(xy), sum(xz), sum(yy), sum(yz), sum(zz)};
    area_ = 0.5 * Vector3(sum(nx), sum(ny), sum(nz));
  }

  const VectorLanes& center() const { return center_; }

  /// Sum of area n n^T, each times the mean of the face's factors.
  const Symmetric3& matrix() const { return matrix_; }

  /// Sum of the area vectors.
  const Vector3& area() const { return area_; }

  /// The area vector of the face at point i.
  Vector3 area_of(int i) const {
    const VectorLanes& n = normal_[i / lane_count];
    const int lane = i % lane_count;
    return 0.5 * Vector3(n.x[lane], n.y[lane], n.z[lane]);
  }

  /// Twice the area vectors of a group, and their lengths.
  const VectorLanes& normals(int group) const { return normal_[group]; }
  Lanes lengths(int group) const { return length_[group]; }

 private:
  static constexpr int groups = FanLists::longest / lane_count;
  static constexpr float half_a_third = 0.5f / 3.0f;  // area of a double one, mean of three factors

  VectorLanes center_;
  Symmetric3 matrix_;
  Vector3 area_;
  std::array<VectorLanes, groups> normal_;
  std::array<Lanes, groups> length_;
};

}  // namespace curvdecim::detail
