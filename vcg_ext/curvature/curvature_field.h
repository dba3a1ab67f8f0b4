// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/curvature/vertex_curvature.h"
#include "vcg_ext/parallel.h"

namespace curvdecim {

/// Curvature of one kind over a mesh, in the unit of its positions.
struct CurvatureField {
  std::vector<double> value, area;  // by vertex

  /// Area-weighted; 0 where there is no area.
  double mean() const {
    double sum = 0.0, total = 0.0;
    for (std::size_t v = 0; v < value.size(); ++v) sum += value[v] * area[v], total += area[v];
    return total > 0.0 ? sum / total : 0.0;
  }
};

inline CurvatureField curvature_field(const WorkingMesh& mesh, CurvatureKind kind,
                                      const Parallel& parallel) {
  const std::size_t count = mesh.position.size();
  CurvatureField field{std::vector<double>(count), std::vector<double>(count)};
  parallel.for_each(static_cast<int>(count), [&](int v) {
    const VertexCurvature curvature = vertex_curvature(mesh, v);
    field.value[v] = curvature.of_kind(kind), field.area[v] = curvature.area;
  });
  return field;
}

/// Each vertex gets the mean of its own value and its neighbours', which count by the faces that
/// they share with it: the curvature of single vertices is mostly noise. Only inner vertices count,
/// where there are any: on a boundary the angles tell how the boundary turns, not the surface.
inline void average_over_rings(const WorkingMesh& mesh, CurvatureField& field,
                               const Parallel& parallel) {
  const std::vector<double> value = field.value;
  parallel.for_each(static_cast<int>(value.size()), [&](int v) {
    double sum = 0.0, weight = 0.0;
    const auto add = [&](int u, double part) {
      if (mesh.kind[u] == VertexKind::Interior) sum += part * value[u], weight += part;
    };
    add(v, 1.0);
    for (int f : mesh.connectivity.faces_of(v))
      for (int u : mesh.connectivity.face(f))
        if (u != v) add(u, 0.5);  // inside, each neighbour is in two faces
    if (weight > 0.0) field.value[v] = sum / weight;
  });
}

/// What the parameters make of the mesh as it is.
inline CurvatureField curvature_field(const WorkingMesh& mesh, const CurvatureParams& params,
                                      const Parallel& parallel) {
  CurvatureField field = curvature_field(mesh, params.curvature_kind, parallel);
  if (params.curvature_of == CurvatureOf::Input) average_over_rings(mesh, field, parallel);
  return field;
}

}  // namespace curvdecim
