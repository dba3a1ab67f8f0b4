// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "vcg_ext/mesh/blend_step.h"
#include "vcg_ext/mesh/seams.h"
#include "vcg_ext/mesh/texture_outline.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// Lets wedges follow their vertices, which move over the mesh: each takes what was carried at the
/// nearest point of its own faces. In the texture no face turns over, and no chart gets larger;
/// where one would, the wedge stays.
class WedgeMoves {
 public:
  WedgeMoves(WorkingMesh& mesh, const Parallel& parallel) : mesh_(mesh), parallel_(parallel) {}

  /// Before the vertices go from the mesh's positions to `now`. Appends what was done to the steps.
  void follow(const std::vector<Vector3>& now, std::vector<BlendStep>& steps) {
    std::vector<std::vector<BlendStep>> of_vertex(now.size());
    parallel_.for_each(
        static_cast<int>(now.size()),
        [&](int v) {
          if (now[v] != mesh_.position[v]) of_vertex[v] = steps_to(v, now[v]);
        },
        Parallel::heavy);
    const std::vector<Vector2> before = mesh_.texture;
    for (std::size_t v = 0; v < now.size(); ++v)
      for (const BlendStep& step : of_vertex[v]) {
        steps.push_back(step);
        if (!before.empty()) move_in_texture(static_cast<int>(v), step, before);
      }
  }

 private:
  /// The steps of the wedges at v.
  std::vector<BlendStep> steps_to(int v, const Vector3& x) const {
    std::vector<BlendStep> steps;
    for (int f : mesh_.connectivity.faces_of(v)) {
      const int wedge = mesh_.wedges.at(mesh_.connectivity, f, v);
      const auto is_of_wedge = [&](const BlendStep& step) { return step.keep == wedge; };
      if (std::none_of(steps.begin(), steps.end(), is_of_wedge))
        steps.push_back(nearest(v, wedge, x));
    }
    return steps;
  }

  template <class Use>
  void for_faces(int v, int wedge, Use use) const {
    for (int f : mesh_.connectivity.faces_of(v))
      if (mesh_.wedges.at(mesh_.connectivity, f, v) == wedge) use(f);
  }

  BlendStep nearest(int v, int wedge, const Vector3& x) const {
    NearestStep nearest(x, step_on_edge(wedge, wedge, 0.0));
    for_faces(v, wedge, [&](int f) {
      nearest.look_at(mesh_.triangle(f), mesh_.plane[f].normal, mesh_.wedges.of_face(f));
    });
    return nearest.step();
  }

  void move_in_texture(int v, const BlendStep& step, const std::vector<Vector2>& before) {
    Vector2& texture = mesh_.texture[step.keep];
    const Vector2 was = texture;
    double area = 0.0;
    for_faces(v, step.keep, [&](int f) { area += texture_area(mesh_.texture_triangle(f)); });
    gather_outline(v, step.keep, area);
    const std::optional<Vector2> place = outline_.nearest(blended(step, before, was));
    if (!place) return;
    bool turns = false;
    for_faces(v, step.keep, [&](int f) {
      const double area_before = texture_area(mesh_.texture_triangle(f));
      texture = *place;
      turns = turns || is_turned_over(area_before, texture_area(mesh_.texture_triangle(f)));
      texture = was;
    });
    if (!turns) texture = *place;
  }

  /// The edges at v of the outline of the wedge's chart. area: of the chart around v in the
  /// texture.
  void gather_outline(int v, int wedge, double area) {
    outline_.clear(area > 0.0 ? 1.0 : -1.0);
    if (is_inside_chart(mesh_, v) || area == 0.0) return;
    const auto is_at_v = [&](int a, int b) { return a == v || b == v; };
    for_faces(v, wedge, [&](int f) { add_outline_edges(mesh_, f, is_at_v, outline_); });
  }

  WorkingMesh& mesh_;
  const Parallel& parallel_;
  TextureOutline outline_;
};

}  // namespace curvdecim::detail
