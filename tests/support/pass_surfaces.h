// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numeric>
#include <vector>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"
#include "vcg_ext/passes/collapse_in_passes.h"

namespace curvdecim::test {

using namespace detail;

inline const Parallel one_thread(1);

/// On which all may go that inner vertices have closed fans for.
inline PassSurface surface_of(const Shape& shape) {
  PassSurface surface;
  const WorkingMesh mesh = working_mesh(shape);
  surface.position = shape.vertices;
  surface.faces = shape.faces;
  surface.memory.resize(shape.vertices.size()), surface.weight.resize(shape.vertices.size());
  for (int v = 0; v < shape.vertex_count(); ++v)
    surface.held.push_back(is_closed_fan(mesh, v) ? 0 : 1);
  surface.vertex_before.resize(shape.vertices.size());
  surface.face_origin.resize(shape.faces.size());
  std::iota(surface.vertex_before.begin(), surface.vertex_before.end(), 0);
  std::iota(surface.face_origin.begin(), surface.face_origin.end(), 0);
  return surface;
}

inline std::vector<int> nothing_merged(const PassSurface& surface) {
  std::vector<int> into(surface.position.size());
  std::iota(into.begin(), into.end(), 0);
  return into;
}

/// A neighbour of v.
inline int first_neighbour(const PassSurface& surface, const FanLists& fans, int v) {
  return next_in(surface.faces[*fans.of(v).begin()], v);
}

inline FanLists fans_of(const PassSurface& surface) {
  FanLists fans;
  fans.build(surface.faces, surface.vertex_count(), one_thread,
             [&](int v) { return surface.held[v] == 0; });
  return fans;
}

}  // namespace curvdecim::test
