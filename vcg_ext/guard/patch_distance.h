// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "vcg_ext/geometry/triangle.h"

namespace curvdecim::detail {

/// Bounds the distance between two small triangle patches over the same outline. Seen along a
/// direction in which no triangle of either is turned away, both are height fields over one plane
/// domain; the difference of two piecewise linear functions is largest at a vertex of their
/// overlay, and every overlay vertex is a vertex of a patch or a crossing of two edges. What both
/// have, their outline above all, is no such place. The vertical difference bounds the two-sided
/// distance @cite cohen1997.
class PatchDistance {
 public:
  using Patch = std::vector<Triangle>;

  /// fan: triangles around `apex` (bitwise). nullopt where the patches are no height fields along
  /// the sum of their area vectors.
  static std::optional<double> bound(const Patch& patch, const Patch& fan, const Vector3& apex) {
    Vector3 up = Vector3::Zero();
    for (const Triangle& t : patch) up += area_vector(t);
    const double length = up.norm();
    if (!(length > 0.0)) return std::nullopt;
    const PatchDistance frame(up / length);
    const std::optional<Patch> p = frame.flatten(patch), q = frame.flatten(fan);
    if (!p || !q || !frame.winds_once(fan, apex)) return std::nullopt;
    return std::max(
        {vertices_over(*p, *q), vertices_over(*q, *p), crossings(*p, *q, frame.flatten(apex))});
  }

 private:
  explicit PatchDistance(const Vector3& up) : z_(up) {
    x_ = up.unitOrthogonal();
    y_ = up.cross(x_);
  }

  /// Into the frame with z upwards; nullopt if a triangle does not face up.
  std::optional<Patch> flatten(const Patch& patch) const {
    Patch flat;
    for (const Triangle& t : patch) {
      Triangle f;
      for (int i = 0; i < 3; ++i) f[i] = flatten(t[i]);
      if (!(plane_area(f[0], f[1], f[2]) > 0.0)) return std::nullopt;
      flat.push_back(f);
    }
    return flat;
  }

  Vector3 flatten(const Vector3& p) const { return {x_.dot(p), y_.dot(p), z_.dot(p)}; }

  /// A fan of triangles that face up and go around once has a simple outline; then the other patch,
  /// whose triangles face up too, lies over it once.
  bool winds_once(const Patch& fan, const Vector3& apex) const {
    constexpr double rounding = 1e-6;  // radians, against a second turn of 2 pi
    double angles = 0.0;
    for (const Triangle& t : fan)
      for (int i = 0; i < 3; ++i)
        if (t[i] == apex)
          angles += corner_angle(flat(t[i]), flat(t[(i + 1) % 3]), flat(t[(i + 2) % 3]));
    return angles <= 2.0 * M_PI + rounding;
  }

  Vector3 flat(const Vector3& p) const { return {x_.dot(p), y_.dot(p), 0.0}; }

  /// Twice the signed area in the plane.
  static double plane_area(const Vector3& a, const Vector3& b, const Vector3& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  }

  using Place = Patch::const_iterator;

  static double vertices_over(const Patch& from, const Patch& onto) {
    double largest = 0.0;
    for (Place t = from.begin(); t != from.end(); ++t)
      for (const Vector3& p : *t) {
        if (have_corner(onto.begin(), onto.end(), p) || have_corner(from.begin(), t, p)) continue;
        largest = std::max(largest, std::abs(p.z() - height(onto, p)));
      }
    return largest;
  }

  static bool have_corner(Place begin, Place end, const Vector3& p) {
    return std::any_of(begin, end,
                       [&](const Triangle& t) { return t[0] == p || t[1] == p || t[2] == p; });
  }

  /// The height of the triangle that p lies in, or lies least outside of by rounding.
  static double height(const Patch& patch, const Vector3& p) {
    double best = -HUGE_VAL, z = 0.0;
    for (const Triangle& t : patch) {
      const double area = plane_area(t[0], t[1], t[2]);
      const double w0 = plane_area(p, t[1], t[2]) / area, w1 = plane_area(t[0], p, t[2]) / area;
      const double inside = std::min({w0, w1, 1.0 - w0 - w1});
      if (inside > best)
        best = inside, z = w0 * t[0].z() + w1 * t[1].z() + (1.0 - w0 - w1) * t[2].z();
    }
    return z;
  }

  /// The largest gap where an edge of the fan at its apex crosses an edge of the patch.
  static double crossings(const Patch& patch, const Patch& fan, const Vector3& apex) {
    double largest = 0.0;
    for (Place blade = fan.begin(); blade != fan.end(); ++blade)
      for (const Vector3& end : *blade)
        if (end != apex && !have_corner(fan.begin(), blade, end))
          for (const Triangle& t : patch)
            for (int i = 0; i < 3; ++i)
              largest = std::max(largest, gap_at_crossing(apex, end, t[i], t[(i + 1) % 3]));
    return largest;
  }

  /// 0 where the edges do not cross, or run along each other: then their ends tell.
  static double gap_at_crossing(const Vector3& a, const Vector3& b, const Vector3& c,
                                const Vector3& d) {
    const double side_c = plane_area(a, b, c), side_d = plane_area(a, b, d);
    if (side_c * side_d >= 0.0) return 0.0;
    const double side_a = plane_area(c, d, a), side_b = plane_area(c, d, b);
    if (side_a * side_b >= 0.0) return 0.0;
    const double s = side_a / (side_a - side_b), t = side_c / (side_c - side_d);
    return std::abs(a.z() + s * (b.z() - a.z()) - c.z() - t * (d.z() - c.z()));
  }

  Vector3 x_, y_, z_;
};

}  // namespace curvdecim::detail
