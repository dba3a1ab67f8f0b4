// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/texture_triangle.h"
#include "vcg_ext/measure/face_tree.h"
#include "vcg_ext/measure/measured_surface.h"
#include "vcg_ext/mesh/wedge_coordinate.h"

namespace curvdecim::detail {

/// A point of a texture.
inline WedgeCoordinate at(const FaceWedges& t, const Barycentric& w) {
  return {w[0] * t[0].u + w[1] * t[1].u + w[2] * t[2].u,
          w[0] * t[0].v + w[1] * t[1].v + w[2] * t[2].v, t[0].page};
}

/// True where a face is drawn with an area: others show one colour of a palette, or nothing.
inline bool is_drawn(const FaceWedges& t) {
  const auto place = [&](int i) { return Vector2(t[i].u, t[i].v); };
  const double area = texture_area({place(0), place(1), place(2)});
  return std::isfinite(area) && area != 0.0;
}

/// The faces of a textured surface in the plane of their texture coordinates, a plane a page: tells
/// where on the surface something is drawn.
class TextureAtlas {
 public:
  /// wedges: by face of the surface.
  TextureAtlas(const MeasuredSurface& surface, const std::vector<FaceWedges>& wedges,
               const Parallel& parallel)
      : surface_(surface),
        drawn_(indices_where(surface.face_count(), parallel,
                             [&](int i) { return is_drawn(wedges[i]); })),
        corners_(drawn_.size()) {
    const int count = static_cast<int>(drawn_.size());
    parallel.for_each(count, [&](int i) {
      for (int k = 0; k < 3; ++k) corners_[i][k] = place_of(wedges[drawn_[i]][k]);
    });
    if (count > 0)
      tree_.emplace(
          count, [&](int i) { return corners_[i]; }, parallel);
  }

  /// How far p is from where the surface shows what is drawn at a coordinate: the nearest place of
  /// several. Beside all charts, their nearest point counts; nullopt: none is near.
  std::optional<double> drift(const WedgeCoordinate& coordinate, const Vector3& p) const {
    if (!tree_ || !std::isfinite(coordinate.u + coordinate.v)) return std::nullopt;
    const Vector3 place = place_of(coordinate);
    const double inside = distance_within(rounding, place, p);
    if (std::isfinite(inside)) return inside;
    const double outside = std::sqrt(tree_->nearest(place, SurfacePoint::none).distance2);
    if (outside > near_a_chart) return std::nullopt;
    return distance_within(outside * (1.0 + rounding), place, p);
  }

 private:
  static constexpr double near_a_chart = 1.0 / 256.0;  // of the atlas
  static constexpr double rounding = 1e-6;             // of the atlas: formats have seven digits

  /// The atlas from 0 to 1 lies around the origin; pages lie further apart than what is near.
  static Vector3 place_of(const WedgeCoordinate& c) {
    return {c.u - 0.5, c.v - 0.5, double(c.page)};
  }

  /// From p to the nearest place of those that are drawn within the limit; infinite: none is.
  double distance_within(double limit, const Vector3& place, const Vector3& p) const {
    double least2 = std::numeric_limits<double>::infinity();
    tree_->visit_near(place, limit * limit, [&](int i) {
      const Barycentric weight = closest_point(corners_[i], place);
      if ((at(corners_[i], weight) - place).squaredNorm() > limit * limit) return;
      const Vector3 there = at(surface_.triangle(drawn_[i]), weight);
      least2 = std::min(least2, (there - p).squaredNorm());
    });
    return std::sqrt(least2);
  }

  const MeasuredSurface& surface_;
  std::vector<int> drawn_;         // faces of the surface
  std::vector<Triangle> corners_;  // of these, in the plane of their page
  std::optional<FaceTree> tree_;   // of these
};

}  // namespace curvdecim::detail
