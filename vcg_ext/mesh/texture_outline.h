// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "vcg_ext/geometry/texture_triangle.h"
#include "vcg_ext/mesh/seams.h"

namespace curvdecim::detail {

/// Where in its texture a chart may have a vertex of its outline, so that the outline comes to lie
/// inside of what it was: on the inner sides of lines along old edges. Reused.
class TextureOutline {
 public:
  /// sign: 1 or -1: whether the chart's faces run around in the texture as on the surface, or the
  /// other way.
  void clear(double sign) { sign_ = sign, lines_.clear(); }

  /// The line along an edge of the outline, in the direction in which it runs around the chart.
  void add(const Vector2& from, const Vector2& to) {
    if (from != to) lines_.push_back({from, to - from});
  }

  /// The nearest such place to x; nullopt: there is none near by.
  std::optional<Vector2> nearest(const Vector2& x) const {
    if (is_inside(x)) return x;
    std::optional<Vector2> best;
    double least2 = reach2();
    const auto offer = [&](const Vector2& place) {
      const double distance2 = (place - x).squaredNorm();
      if (distance2 < least2 && is_inside(place)) least2 = distance2, best = place;
    };
    for (const Line& line : lines_) {
      offer(line.from + line.along * (line.along.dot(x - line.from) / line.along.squaredNorm()));
      for (const Line& other : lines_)
        if (const double turn = cross(line.along, other.along); turn != 0.0)
          offer(line.from + line.along * (cross(other.from - line.from, other.along) / turn));
    }
    return best;
  }

 private:
  struct Line {
    Vector2 from, along;
  };

  bool is_inside(const Vector2& x) const {
    constexpr double rounding = 1e-9;  // of the edge
    for (const Line& line : lines_)
      if (sign_ * cross(line.along, x - line.from) < -rounding * line.along.squaredNorm())
        return false;
    return true;
  }

  /// Squared: as far as the longest of the edges. A vertex does not go further.
  double reach2() const {
    double reach2 = 0.0;
    for (const Line& line : lines_) reach2 = std::max(reach2, line.along.squaredNorm());
    return reach2;
  }

  double sign_ = 1.0;
  std::vector<Line> lines_;
};

/// Adds the edges of face f that are on the outline of its chart and wanted(a, b).
template <class Wanted>
void add_outline_edges(const WorkingMesh& mesh, int f, Wanted wanted, TextureOutline& outline) {
  const TextureTriangle triangle = mesh.texture_triangle(f);
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    const int a = mesh.connectivity.face(f)[i], b = mesh.connectivity.face(f)[next];
    if (wanted(a, b) && is_outline(mesh, f, a, b)) outline.add(triangle[i], triangle[next]);
  }
}

}  // namespace curvdecim::detail
