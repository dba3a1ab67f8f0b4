// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/attributes/attribute_blend.h"
#include "vcg_ext/guard/limits.h"
#include "vcg_ext/metric/metric.h"
#include "vcg_ext/metric/placement.h"
#include "vcg_ext/passes/fan_corners.h"
#include "vcg_ext/passes/pass_surface.h"

namespace curvdecim::detail {

/// Looks at single edges between vertices with closed fans, as the surface is now. What it does not
/// allow waits: for another pass, or for the guards that have prices (guard/collapse_guards.h).
class FanCollapse {
 public:
  FanCollapse(const PassSurface& surface, const FanLists& fans, const FaceLimits& limits)
      : surface_(surface),
        fans_(fans),
        least_cosine_(static_cast<float>(least_cosine(limits, 1.0))) {}

  /// To be called some looks before that at an edge of v, so that what is read first is near by
  /// then.
  void fetch(int v) const {
    __builtin_prefetch(fans_.of(v).begin());
    __builtin_prefetch(&surface_.memory[v].xx), __builtin_prefetch(&surface_.memory[v].bz);
  }

  /// Neither a nor b has changed in this pass; into: by vertex, what it has become. nullopt: it
  /// costs more than `limit`, or is not allowed.
  std::optional<Candidate> look(int a, int b, const std::vector<int>& into, double limit) {
    if (!a_.gather(surface_, fans_, into, a, b) || !b_.gather(surface_, fans_, into, b, a))
      return std::nullopt;
    if (!keeps_topology()) return std::nullopt;
    const Vector3 half = 0.5 * (surface_.position[b] - surface_.position[a]);
    const Vector3 middle = surface_.position[a] + half;
    const FanFaces of_a(surface_, a_, middle, -half), of_b(surface_, b_, middle, half);
    const Minimum least = least_of(half, of_a, of_b);
    const double cost = least.value * surface_.weight_of(a, b);
    if (cost > limit || stands_off(least.offset, half)) return std::nullopt;
    if (of_a.are_spoiled(least.offset, least_cosine_)) return std::nullopt;
    if (of_b.are_spoiled(least.offset, least_cosine_)) return std::nullopt;
    return Candidate{cost, in_place(least.offset, a, b, half), parameter_along(half, least.offset)};
  }

  /// Where on the faces around the edge that was looked at last, before it collapses, x is nearest.
  /// along: the step on the edge.
  BlendStep nearest_step(const Vector3& x, const EdgeStep& along) const {
    NearestStep nearest(x, step_on_edge(along.keep, along.gone, along.t));
    look_at_faces(a_, nearest), look_at_faces(b_, nearest);
    return nearest.step();
  }

  /// What a merged vertex carries, and what that costs.
  struct Carrying {
    Vector2 texture = Vector2::Zero();
    Vector3 color = Vector3::Zero();
    double price = 0.0;
  };

  /// What deviates least for the ends of that edge, which go to x; nullopt: a face would be turned
  /// over in the texture.
  std::optional<Carrying> look_at_attributes(const Vector3& x) {
    points_.clear();
    for_each_face([&](const FanCorners& fan, int i) {
      points_.push_back(plane_point(triangle_of(surface_.position, face_of(fan, i)), x));
    });
    Carrying carrying;
    if (!surface_.texture.empty()) {
      const auto [texture, deviation] = least_deviation(surface_.texture, textures_);
      if (turns_over(texture)) return std::nullopt;
      carrying.texture = texture, carrying.price += surface_.texture_weight * deviation;
    }
    if (!surface_.color.empty()) {
      const auto [color, deviation] = least_deviation(surface_.color, colors_);
      carrying.color = color, carrying.price += surface_.color_weight * deviation;
    }
    return carrying;
  }

 private:
  /// use(fan, i): the edge's own faces come first.
  template <class Use>
  void for_each_face(Use use) const {
    for (int i = 0; i < a_.size(); ++i) use(a_, i);
    for (int i = FanCorners::wings; i < b_.size(); ++i) use(b_, i);
  }

  /// The value for the points, and how it deviates. carried: by carrier; leaves in at_faces what is
  /// carried at each face.
  template <class Value>
  std::pair<Value, double> least_deviation(const std::vector<Value>& carried,
                                           std::vector<AtCorners<Value>>& at_faces) const {
    at_faces.clear();
    EstimateFit<Value> fit;
    for_each_face([&](const FanCorners& fan, int i) {
      const Face face = face_of(fan, i);
      AtCorners<Value> at_face;
      for (int k = 0; k < 3; ++k) at_face[k] = carried[surface_.carrier(fan.face(i), face[k])];
      fit.add(face_estimate(points_[at_faces.size()], at_face), at_face);
      at_faces.push_back(at_face);
    });
    const Value value = fit.value(at_faces[0][0]);
    double deviation = 0.0;
    for (std::size_t i = 0; i < at_faces.size(); ++i)
      deviation += face_estimate(points_[i], at_faces[i]).deviation(value);
    return {value, deviation};
  }

  /// Whether the center at this place turns over one of the faces that are left.
  bool turns_over(const Vector2& place) const {
    for (std::size_t i = FanCorners::wings; i < textures_.size(); ++i) {
      TextureTriangle now = textures_[i];
      now[0] = place;
      if (is_turned_over(texture_area(textures_[i]), texture_area(now))) return true;
    }
    return false;
  }

  static Face face_of(const FanCorners& fan, int i) {
    return {fan.center(), fan.next(i), fan.last(i)};
  }

  void look_at_faces(const FanCorners& fan, NearestStep& nearest) const {
    for (int i = 0; i < fan.size(); ++i) {
      const Face face = face_of(fan, i);
      const Triangle triangle = triangle_of(surface_.position, face);
      Face carriers;
      for (int k = 0; k < 3; ++k) carriers[k] = surface_.carrier(fan.face(i), face[k]);
      nearest.look_at(triangle, face_plane(triangle).normal, carriers);
    }
  }

  /// Both ends have the edge's two faces, and no other neighbour in common.
  bool keeps_topology() const {
    if (a_.last(0) != b_.next(1) || a_.next(1) != b_.last(0)) return false;
    const int merged = a_.size() + b_.size() - 2 * FanCorners::wings;
    return merged >= 3 && merged <= FanLists::longest && !a_.meets(b_);
  }

  /// About the edge's middle. All that is in the surface, but for rounding, costs nothing.
  Minimum least_of(const Vector3& half, const FanFaces& of_a, const FanFaces& of_b) const {
    constexpr double rounding = 1e-6;  // part of the edge, in single precision
    Quadric around_a = surface_.memory[a_.center()].quadric();
    Quadric around_b = surface_.memory[b_.center()].quadric();
    around_a.a += of_a.matrix(), around_b.a += of_b.matrix();
    const QuadricOfEdge q = sum_about_midpoint(around_a, around_b, half);
    const KeepingPlane volume{of_a.area() + of_b.area() - of_a.area_of_wings(),
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

  /// An end itself is not rounded.
  Vector3 in_place(const Vector3& offset, int a, int b, const Vector3& half) const {
    if (offset == -half) return surface_.position[a];
    if (offset == half) return surface_.position[b];
    return surface_.position[a] + (half + offset);
  }

  const PassSurface& surface_;
  const FanLists& fans_;
  const float least_cosine_;
  FanCorners a_, b_;
  // By face around, each with the center first.
  std::vector<PlanePoint> points_;
  std::vector<TextureTriangle> textures_;
  std::vector<AtCorners<Vector3>> colors_;
};

}  // namespace curvdecim::detail
