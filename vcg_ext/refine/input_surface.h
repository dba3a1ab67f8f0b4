// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/collapse/collapse_plan.h"
#include "vcg_ext/geometry/blend.h"
#include "vcg_ext/mesh/charts.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/metric/error_weights.h"
#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/refine/match.h"
#include "vcg_ext/refine/surface_curve.h"

namespace curvdecim::detail {

/// What the corners of the input carry, where they are told apart; empty elsewhere.
struct InputCharts {
  std::vector<int> of_face;      // by face: its chart
  std::vector<int> of_origin;    // by WorkingMesh::face_origin: the same
  std::vector<Face> wedges;      // by face
  std::vector<Vector2> texture;  // by wedge; empty: there is none

  /// Whether an input face is in the chart that face f of the mesh, made of the input, is in.
  bool has(const WorkingMesh& mesh, int f, int input_face) const {
    const auto origin = static_cast<std::size_t>(mesh.face_origin[f]);
    return origin < of_origin.size() && of_origin[origin] == of_face[input_face];
  }

  /// How far a sample on a face of the chart of face f, its corners drawn at `corners`, is from
  /// where its match is drawn; nullopt: that one lies beyond a seam, or is drawn nowhere.
  std::optional<Vector2> texture_pull(const WorkingMesh& mesh, int f,
                                      const TextureTriangle& corners, const Match& match) const {
    if (!has(mesh, f, match.input_face)) return std::nullopt;
    const auto [a, b, c] = wedges[match.input_face];
    const Vector2 pull =
        interpolated<Vector2>({texture[a], texture[b], texture[c]}, match.on_input) -
        interpolated(corners, match.at);
    if (!is_finite(pull)) return std::nullopt;
    return pull;
  }
};

/// What the refinement keeps of the input while the mesh is decimated: no more than it needs.
struct InputCopy {
  std::vector<Vector3> position;  // by vertex
  std::vector<Face> faces;
  std::vector<float> weight;  // by face: how much its error counts, 1 in the mean
  std::vector<Edge> border;   // edges of one face
  std::vector<Edge> seams;
  InputCharts charts;

  Triangle triangle(int f) const { return triangle_of(position, faces[f]); }
};

/// The input as a surface, in the box of diagonal 1.
struct InputSurface {
  std::vector<Vector3> position;
  TriangleConnectivity connectivity;
  std::vector<float> weight;
  std::vector<Edge> border, seams;
  InputCharts charts;

  explicit InputSurface(InputCopy copy)
      : position(std::move(copy.position)),
        connectivity(std::move(copy.faces), static_cast<int>(position.size())),
        weight(std::move(copy.weight)),
        border(std::move(copy.border)),
        seams(std::move(copy.seams)),
        charts(std::move(copy.charts)) {}

  int face_count() const { return connectivity.face_slots(); }
  Triangle triangle(int f) const { return triangle_of(position, connectivity.face(f)); }
  double area(int f) const { return area_vector(triangle(f)).norm(); }
};

inline double total_area(const InputSurface& surface) {
  double sum = 0.0;
  for (int f = 0; f < surface.face_count(); ++f) sum += surface.area(f);
  return sum;
}

/// A face has the mean of its corners' weights, over the mean of the surface.
inline void set_face_weights(const std::vector<double>& of_vertex, const Parallel& parallel,
                             InputCopy& input) {
  double sum = 0.0, area = 0.0;
  input.weight.reserve(input.faces.size());
  parallel.in_order(static_cast<int>(input.faces.size()), [&](int f) {
    const auto [a, b, c] = input.faces[f];
    const double weight = (of_vertex[a] + of_vertex[b] + of_vertex[c]) / 3.0;
    input.weight.push_back(static_cast<float>(weight));
    const double face_area = area_vector(input.triangle(f)).norm();
    sum += weight * face_area, area += face_area;
  });
  for (float& weight : input.weight)
    weight = sum > 0.0 ? static_cast<float>(weight * (area / sum)) : 1.0f;
}

/// mesh: before the first collapse.
inline InputCharts copy_charts(const WorkingMesh& mesh) {
  InputCharts charts;
  if (!mesh.wedges.exist()) return charts;
  charts.of_face = find_charts(mesh).of_face;
  charts.of_origin.resize(mesh.face_origins, Wedges::none);
  charts.wedges.reserve(charts.of_face.size());
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f) {
    charts.of_origin[mesh.face_origin[f]] = charts.of_face[f];
    charts.wedges.push_back(mesh.wedges.of_face(f));
  }
  charts.texture = mesh.texture;
  return charts;
}

/// mesh: before the first collapse.
inline InputCopy copy_input(const WorkingMesh& mesh, const MetricPlan& metric,
                            const Parallel& parallel) {
  std::vector<double> weights = error_weights(mesh, metric, parallel);
  for (std::size_t v = 0; v < mesh.importance.size(); ++v) weights[v] *= mesh.importance[v];
  InputCopy input;
  input.position = mesh.position;
  input.faces.resize(mesh.connectivity.face_slots());
  parallel.for_each(mesh.connectivity.face_slots(),
                    [&](int f) { input.faces[f] = mesh.connectivity.face(f); });
  input.border = border_edges(mesh), input.seams = seam_edges(mesh);
  input.charts = copy_charts(mesh);
  set_face_weights(weights, parallel, input);
  return input;
}

}  // namespace curvdecim::detail
