// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "vcg_ext/connectivity/edge_neighborhood.h"
#include "vcg_ext/curvature/curvature_field.h"
#include "vcg_ext/curvature/curvature_weight.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel.h"
#include "vcg_ext/params.h"
#include "vcg_ext/refine/border_curve.h"

namespace curvdecim {

/// The input as it was before the collapses, in the box of diagonal 1.
struct InputSurface {
  std::vector<Vector3> position;  // by vertex
  TriangleConnectivity connectivity;
  std::vector<float> weight;  // by face: how much its error counts, 1 in the mean
  std::vector<Edge> border;   // edges of one face

  int face_count() const { return connectivity.face_slots(); }
  Triangle triangle(int f) const {
    const auto [a, b, c] = connectivity.face(f);
    return {position[a], position[b], position[c]};
  }
  double area(int f) const { return area_vector(triangle(f)).norm(); }
};

inline double total_area(const InputSurface& surface) {
  double sum = 0.0;
  for (int f = 0; f < surface.face_count(); ++f) sum += surface.area(f);
  return sum;
}

/// By vertex: how much an error there counts, as it does in the collapses, but for its importance.
inline std::vector<double> metric_weights(const WorkingMesh& mesh, const EdgeCollapseParams& params,
                                          double diagonal, const Parallel& parallel) {
  std::vector<double> weights(mesh.position.size(), 1.0);
  if (params.metric != Metric::CurvatureWeighted) return weights;
  const CurvatureField field = curvature_field(mesh, params, parallel);
  const CurvatureWeight weight = curvature_weight(params, field, diagonal);
  for (std::size_t v = 0; v < weights.size(); ++v) {
    const double saturation = weight.saturation(field.value[v]);
    weights[v] = weight.of_edge(saturation, saturation);
  }
  return weights;
}

inline std::vector<double> metric_weights(const WorkingMesh& mesh, const SphereParams&, double,
                                          const Parallel&) {
  return std::vector<double>(mesh.position.size(), 1.0);
}

/// The mean of the corners' weights, over the mean of the surface.
inline void set_face_weights(const std::vector<double>& of_vertex, InputSurface& surface) {
  double sum = 0.0, area = 0.0;
  for (int f = 0; f < surface.face_count(); ++f) {
    const auto [a, b, c] = surface.connectivity.face(f);
    const double weight = (of_vertex[a] + of_vertex[b] + of_vertex[c]) / 3.0;
    surface.weight.push_back(static_cast<float>(weight));
    const double face_area = surface.area(f);
    sum += weight * face_area, area += face_area;
  }
  for (float& weight : surface.weight)
    weight = sum > 0.0 ? static_cast<float>(weight * (area / sum)) : 1.0f;
}

/// mesh: without collapses; diagonal: of the input in its own unit.
template <class Params>
InputSurface input_surface(WorkingMesh mesh, const Params& params, double diagonal,
                           const Parallel& parallel) {
  std::vector<double> weights = metric_weights(mesh, params, diagonal, parallel);
  for (std::size_t v = 0; v < mesh.importance.size(); ++v) weights[v] *= mesh.importance[v];
  InputSurface surface;
  surface.weight.reserve(mesh.connectivity.face_slots());
  surface.border = border_edges(mesh);
  surface.position = std::move(mesh.position);
  surface.connectivity = std::move(mesh.connectivity);
  set_face_weights(weights, surface);
  return surface;
}

}  // namespace curvdecim
