// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "vcg_ext/mesh/edge_charts.h"

namespace curvdecim::detail {

/// The texture in the surface's unit: the weight of its drift, times the squared ratio of lengths
/// on the surface to those in the texture; 0 where it has no area.
inline double texture_weight(const WorkingMesh& mesh, double attribute_weight) {
  double on_surface = 0.0, in_texture = 0.0;
  for (int f = 0; f < mesh.connectivity.face_slots() && !mesh.texture.empty(); ++f) {
    if (!mesh.connectivity.alive(f)) continue;
    on_surface += mesh.plane[f].area;
    in_texture += 0.5 * std::abs(texture_area(mesh.texture_triangle(f)));
  }
  return in_texture > 0.0 ? attribute_weight * on_surface / in_texture : 0.0;
}

/// What a collapse does in the texture.
class TextureGuard {
 public:
  TextureGuard(const WorkingMesh& mesh, double attribute_weight)
      : mesh_(mesh), weight_(texture_weight(mesh, attribute_weight)) {}

  /// How far the texture would drift where the edge is: area times squared distance on the surface.
  /// nullopt: a face would be turned over there, or come to lie outside of its chart. charts: of
  /// the collapse to x.
  std::optional<double> price(const EdgeNeighborhood& around, const EdgeCharts& charts,
                              const Vector3& x) const {
    if (!charts.fit_texture()) return std::nullopt;
    double sum = 0.0;
    for (std::size_t i = 0; i < around.star().size(); ++i) {
      const Vector2& now = charts.texture(charts.of_star(i));
      if (turns_over(around.star()[i], around.edge(), now)) return std::nullopt;
      sum += deviation(around.star()[i], x, now);
    }
    for (std::size_t i = 0; i < around.wings().size(); ++i)
      sum += deviation(around.wings()[i], x, charts.texture(charts.of_wing(i)));
    return weight_ * sum;
  }

 private:
  bool turns_over(int f, Edge edge, const Vector2& now) const {
    TextureTriangle triangle = mesh_.texture_triangle(f);
    const double before = texture_area(triangle);
    const TriangleConnectivity& connectivity = mesh_.connectivity;
    triangle[connectivity.corner(f, connectivity.face_has(f, edge.a) ? edge.a : edge.b)] = now;
    return is_turned_over(before, texture_area(triangle));
  }

  double deviation(int f, const Vector3& x, const Vector2& now) const {
    if (weight_ == 0.0) return 0.0;
    return texture_deviation(mesh_.triangle(f), mesh_.texture_triangle(f), x, now);
  }

  const WorkingMesh& mesh_;
  const double weight_;
};

}  // namespace curvdecim::detail
