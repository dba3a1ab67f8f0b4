// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "vcg_ext/mesh/edge_charts.h"

namespace curvdecim::detail {

/// What a collapse does to what corners carry: in the texture, and to colours.
class AttributeGuard {
 public:
  /// attribute_weight: of their errors against that of the surface.
  AttributeGuard(const WorkingMesh& mesh, double attribute_weight)
      : mesh_(mesh),
        texture_weight_(attribute_weight * mesh.texture_scale2),
        color_weight_(attribute_weight * mesh.color_scale2) {}

  /// How far the texture and the colours would be off where the edge is: area times squared
  /// distance on the surface. nullopt: a face would be turned over in the texture, or come to lie
  /// outside of its chart.
  std::optional<double> price(const EdgeNeighborhood& around, const EdgeCharts& charts) const {
    if (!mesh_.texture.empty() && spoils_texture(around, charts)) return std::nullopt;
    double price = 0.0;
    if (texture_weight_ > 0.0) price += texture_weight_ * charts.texture_deviation();
    if (color_weight_ > 0.0) price += color_weight_ * charts.color_deviation();
    return price;
  }

 private:
  bool spoils_texture(const EdgeNeighborhood& around, const EdgeCharts& charts) const {
    if (!charts.fit_texture()) return true;
    for (std::size_t i = 0; i < around.star().size(); ++i)
      if (turns_over(around.star()[i], around.edge(), charts.texture(charts.of_star(i))))
        return true;
    return false;
  }

  bool turns_over(int f, Edge edge, const Vector2& now) const {
    TextureTriangle triangle = mesh_.texture_triangle(f);
    const double before = texture_area(triangle);
    const TriangleConnectivity& connectivity = mesh_.connectivity;
    triangle[connectivity.corner(f, connectivity.face_has(f, edge.a) ? edge.a : edge.b)] = now;
    return is_turned_over(before, texture_area(triangle));
  }

  const WorkingMesh& mesh_;
  const double texture_weight_, color_weight_;
};

}  // namespace curvdecim::detail
