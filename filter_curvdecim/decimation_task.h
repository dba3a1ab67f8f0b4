// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <vcg/complex/algorithms/update/color.h>
#include <vcg/complex/complex.h>

#include "filter_curvdecim/filter_parameters.h"
#include "vcg_ext/cluster.h"
#include "vcg_ext/decimate.h"
#include "vcg_ext/remove_vertices.h"

namespace curvdecim {

/// One entry of the dictionary that a filter returns.
struct Result {
  std::string name;
  std::variant<std::int64_t, double, StopReason> value;
};

/// What a filter tells its host.
struct Outcome {
  std::vector<Result> results;     ///< in the order of the log
  std::vector<std::string> notes;  ///< repairs and warnings, for the log
  bool mesh_changed = false;
};

/// "name: value"
std::string log_line(const Result& result);

Outcome outcome_of(const DecimationReport& report, const DecimationParams& params,
                   double pair_distance = 0.0);
Outcome outcome_of(const ClusteringReport& report);
Outcome outcome_of_removal(const DecimationReport& report);

/// Of a class of vertices, where it is shown.
vcg::Color4b color_of(VertexClass vertex_class);

/// The value below which a fraction of them lies; there must be one.
double percentile(const std::vector<double>& sorted, double fraction);

template <class MeshType>
Outcome decimate_by_edge_collapse(MeshType& mesh, const EdgeCollapseParams& params,
                                  const Progress& progress) {
  return outcome_of(decimate_edge_collapse(mesh, params, progress), params, params.pair_distance);
}

template <class MeshType>
Outcome decimate_by_spheres(MeshType& mesh, const SphereParams& params, const Progress& progress) {
  return outcome_of(decimate_algebraic_sphere(mesh, params, progress), params);
}

template <class MeshType>
Outcome decimate_by_clustering(MeshType& mesh, const ClusteringParams& params,
                               const Progress& progress) {
  return outcome_of(decimate_vertex_clustering(mesh, params, progress));
}

/// Writes the class of every vertex of a face to its quality, by number, and to its colour; adds
/// the counts to the results.
template <class MeshType>
void show_classes(MeshType& mesh, const VertexRemovalParams& params, Outcome& outcome) {
  const auto classes = vertex_classes(mesh, params);
  std::array<std::int64_t, vertex_class_names.size()> counts{};
  for (std::size_t v = 0; v < classes.size(); ++v) {
    if (!classes[v]) continue;
    ++counts[static_cast<std::size_t>(*classes[v])];
    mesh.vert[v].Q() = static_cast<typename MeshType::ScalarType>(*classes[v]);
    mesh.vert[v].C() = color_of(*classes[v]);
  }
  for (std::size_t i = 0; i < counts.size(); ++i)
    outcome.results.push_back({std::string("vertices_") + vertex_class_names[i], counts[i]});
}

template <class MeshType>
Outcome decimate_by_removal(MeshType& mesh, const VertexRemovalTask& task,
                            const Progress& progress) {
  const DecimationReport report = decimate_vertex_removal(mesh, task, progress);
  Outcome outcome = outcome_of_removal(report);
  if (task.show_classes && report.stopped_by != StopReason::Cancelled)
    show_classes(mesh, task, outcome);
  return outcome;
}

/// The qualities of the vertices that faces use, ascending.
template <class MeshType>
std::vector<double> sorted_qualities(const MeshType& mesh) {
  std::vector<bool> used(mesh.vert.size(), false);
  for (const auto& face : mesh.face)
    for (int i = 0; i < 3 && !face.IsD(); ++i) used[vcg::tri::Index(mesh, face.cV(i))] = true;
  std::vector<double> qualities;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) qualities.push_back(static_cast<double>(mesh.vert[v].cQ()));
  std::sort(qualities.begin(), qualities.end());
  return qualities;
}

/// Writes the importance to quality and colour of the vertices.
template <class MeshType>
Outcome show_curvature_importance(MeshType& mesh, const ImportanceParams& params,
                                  const Progress& progress) {
  if (progress && !progress(0, "Computing curvature"))
    return {{{"stopped_by", StopReason::Cancelled}}, {"Cancelled: the mesh is unchanged."}, false};
  curvature_importance(mesh, params);
  const std::vector<double> sorted = sorted_qualities(mesh);
  // A few spikes of curvature would make the rest one colour; the factor keeps one scale for all
  // meshes.
  const double red = params.as_factor ? 0.0 : percentile(sorted, 0.05);
  const double blue = params.as_factor ? 1.0 : percentile(sorted, 0.95);
  vcg::tri::UpdateColor<MeshType>::PerVertexQualityRamp(mesh, red, blue);
  return {{{"minimum", sorted.front()},
           {"median", percentile(sorted, 0.5)},
           {"maximum", sorted.back()}},
          {},
          true};
}

}  // namespace curvdecim
