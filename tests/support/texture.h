// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/mesh/seams.h"

namespace curvdecim::test {

using namespace detail;

/// Gives the mesh texture coordinates by corner: coordinate(f, i). Corners at a vertex with the
/// same ones are a wedge.
template <class Coordinate>
void give_texture(WorkingMesh& mesh, Coordinate coordinate) {
  const int vertices = static_cast<int>(mesh.position.size());
  std::vector<std::vector<int>> at(vertices);  // by vertex: its wedges
  std::vector<Face> wedges(mesh.connectivity.face_slots());
  mesh.texture.assign(vertices, {0.0, 0.0});
  const auto wedge_of = [&](int v, const Vector2& is) {
    for (int wedge : at[v])
      if (mesh.texture[wedge] == is) return wedge;
    at[v].push_back(at[v].empty() ? v : static_cast<int>(mesh.texture.size()));
    if (at[v].size() > 1) mesh.texture.emplace_back();
    mesh.texture[at[v].back()] = is;
    return at[v].back();
  };
  for (std::size_t f = 0; f < wedges.size(); ++f)
    for (int i = 0; i < 3; ++i)
      wedges[f][i] = wedge_of(mesh.connectivity.face(static_cast<int>(f))[i],
                              coordinate(static_cast<int>(f), i));
  mesh.wedges = Wedges(std::move(wedges), static_cast<int>(mesh.texture.size()));
  find_seams(mesh, Parallel(1));
}

inline constexpr double other_chart = 10.0;  ///< added to u beyond the cut

/// u = x and v = y, in one chart, or cut at x = `cut` (an edge line of the mesh).
inline void give_plane_texture(WorkingMesh& mesh, double cut = 1e9) {
  give_texture(mesh, [&](int f, int i) {
    const Triangle t = mesh.triangle(f);
    const bool is_beyond = center_of(t).x() > cut;
    return Vector2(t[i].x() + (is_beyond ? other_chart : 0.0), t[i].y());
  });
}

/// The same in one chart, cut from y = 0 to the middle of the unit square.
inline void give_slit_texture(WorkingMesh& mesh) {
  give_texture(mesh, [&](int f, int i) {
    const Triangle t = mesh.triangle(f);
    const bool is_cut = t[i].x() == 0.5 && t[i].y() < 0.5 && center_of(t).x() > 0.5;
    return Vector2(t[i].x() + (is_cut ? 0.1 : 0.0), t[i].y());
  });
}

}  // namespace curvdecim::test
