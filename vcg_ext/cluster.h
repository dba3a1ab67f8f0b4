// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/clustering/cell_texture.h"
#include "vcg_ext/curvature/curvature_field.h"
#include "vcg_ext/mesh/attribute_notes.h"
#include "vcg_ext/mesh/cluster_write_back.h"
#include "vcg_ext/mesh/decimation_setup.h"
#include "vcg_ext/operators/vertex_clustering.h"
#include "vcg_ext/validation.h"

namespace curvdecim {

struct ClusteringReport : DecimationReport {
  double cell_size = 0.0;       ///< diameter of the cells, in the mesh's unit
  std::int64_t degenerate = 0;  ///< faces with two vertices in one cell
  std::int64_t duplicate = 0;   ///< faces between the same three cells as another
  std::int64_t crowded = 0;     ///< faces dropped by manifold_edges
};

inline std::vector<int> vertices_in_use(const FlatMesh& flat) {
  std::vector<int> vertices;
  for (std::size_t v = 0; v < flat.role.size(); ++v)
    if (flat.role[v] != VertexRole::Unused) vertices.push_back(static_cast<int>(v));
  return vertices;
}

/// By vcg vertex, from values of some of them; 0 for the others.
inline std::vector<double> scattered(const std::vector<int>& vertices,
                                     const std::vector<double>& values, std::size_t count) {
  std::vector<double> result(values.empty() ? 0 : count, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) result[vertices[i]] = values[i];
  return result;
}

template <class MeshType>
std::vector<double> quality_weights(const MeshType& mesh, const FlatMesh& flat, const char* use,
                                    DecimationReport& report) {
  const std::vector<int> vertices = vertices_in_use(flat);
  const std::vector<double> values = importance_from_quality(mesh, vertices);
  if (values.empty()) note_no_quality(use, report);
  return scattered(vertices, values, mesh.vert.size());
}

/// By area, or by area and curvature; above 0, so that every cell has a mean.
template <class MeshType>
std::vector<double> surface_weights(const MeshType& mesh, MeanWeight by, const Parallel& parallel) {
  constexpr double least = 1e-9;  // of the largest
  const Snapshot snapshot = take_snapshot(mesh, parallel);
  const CurvatureField field = curvature_field(snapshot.mesh, CurvatureParams(), parallel);
  std::vector<double> values = field.area;
  for (std::size_t v = 0; v < values.size() && by == MeanWeight::Curvature; ++v)
    values[v] *= field.value[v];
  const double largest = *std::max_element(values.begin(), values.end());
  for (double& value : values) value = largest > 0.0 ? std::max(value / largest, least) : 1.0;
  std::vector<double> weights = scattered(snapshot.vertex_of, values, mesh.vert.size());
  for (double& weight : weights) weight = std::max(weight, least);
  return weights;
}

template <class MeshType>
ClusteringWeights clustering_weights(const MeshType& mesh, const FlatMesh& flat,
                                     const ClusteringParams& params, const Parallel& parallel,
                                     DecimationReport& report) {
  ClusteringWeights weights;
  if (params.quality_weight && params.representative == Representative::Quadric)
    weights.importance = quality_weights(mesh, flat, "QualityWeight", report);
  if (params.representative != Representative::WeightedMean) return weights;
  weights.mean = params.mean_weight == MeanWeight::Quality
                     ? quality_weights(mesh, flat, "MeanWeight Quality", report)
                     : surface_weights(mesh, params.mean_weight, parallel);
  return weights;
}

/// Where the attributes of a cell's vertex come from.
template <class MeshType>
CellBlend cell_blend(const MeshType& mesh, const FlatMesh& flat, const Clustering& clustering,
                     const ClusteringParams& params, const ClusteringWeights& weights,
                     const Parallel& parallel) {
  const auto& [clusters, representatives] = clustering;
  const bool vary = has_varying_attributes(mesh, vertices_in_use(flat));
  if (!vary && !vcg::tri::HasPerVertexNormal(mesh))
    return CellBlend::of_vertices(representatives.vertex);
  switch (params.representative) {
    case Representative::Median: return CellBlend::of_vertices(representatives.vertex);
    case Representative::Mean: return CellBlend::of_members(clusters, {});
    case Representative::WeightedMean: return CellBlend::of_members(clusters, weights.mean);
    case Representative::Quadric:
    case Representative::CellCenter: break;
  }
  return vary ? CellBlend::of_surface(flat, clusters, representatives, parallel)
              : CellBlend::of_members(clusters, {});
}

/// Faces to keep of those that may change; 0: the size of the cells rules.
inline int clustering_target(const ClusteringParams& params, int candidates) {
  return params.target_fraction > 0.0 ? faces_of_fraction(params.target_fraction, candidates)
                                      : params.target_faces;
}

/// In the unit box. Throws InputError where the grid would have too many cells.
inline double cell_diameter(const ClusteringParams& params, const FlatMesh& flat) {
  const double least = CellGrid::least_diameter(flat.half_size);
  const double diameter = params.cell_size / flat.box.diagonal;
  if (diameter >= least) return diameter;
  std::ostringstream message;
  message << "CellSize is " << params.cell_size << ", but must be at least "
          << least * flat.box.diagonal << ": an axis of the grid holds 2^" << CellGrid::bits
          << " cells.";
  throw InputError(message.str());
}

inline void judge_target(int target, int left, ClusteringReport& report) {
  constexpr double tolerance = 0.02;  // of the target
  if (target == 0 || std::abs(left - target) <= tolerance * target) return;
  report.stopped_by = StopReason::NothingLeft;
  report.notes.push_back("No size of the cells leaves a number of faces nearer to the target " +
                         std::to_string(target) + " than " + std::to_string(left) +
                         ": many come and go together.");
}

inline void count_losses(const FlatMesh& flat, const Clusters& clusters, ClusteringReport& report) {
  report.degenerate = flat.face_count - clusters.crossing;
  report.crowded = clusters.crowded;
  report.duplicate =
      clusters.crossing - clusters.crowded - static_cast<std::int64_t>(clusters.faces.size());
}

template <class MeshType>
std::optional<std::vector<FaceWedges>> carried_wedges(const MeshType& mesh, const FlatMesh& flat,
                                                      const Clustering& clustering,
                                                      const Parallel& parallel,
                                                      DecimationReport& report) {
  if (!vcg::tri::HasPerWedgeTexCoord(mesh)) return std::nullopt;
  std::vector<FaceWedges> wedges;
  for (const auto& face : mesh.face) wedges.push_back(wedges_of(face));
  const CellTexture texture(flat, clustering.clusters, std::move(wedges));
  if (texture.has_seams()) note_seams(report);
  return texture.at(clustering.representatives, parallel);
}

/// The run itself; the mesh changes at its end only. Throws InputError and CancelRequest.
template <class MeshType>
void run_vertex_clustering(MeshType& mesh, const ClusteringParams& params, ProgressMeter& progress,
                           ClusteringReport& report) {
  const Parallel parallel(params.threads, [&] { progress.ask(); });
  const FlatMesh flat = read_flat(mesh, params.selected_only, parallel);
  const int target = clustering_target(params, flat.face_count);
  if (target >= flat.face_count) return note_small_enough(report);
  const ClusteringWeights weights = clustering_weights(mesh, flat, params, parallel, report);
  const double diameter = target > 0 ? 0.0 : cell_diameter(params, flat);
  const std::optional<Clustering> clustering =
      VertexClustering(flat, params, weights, parallel).run(diameter, target, progress);
  if (!clustering)
    throw InputError(
        "No face would be left: the cells are too large for the mesh. Choose a smaller CellSize.");
  note_dropped_attributes(mesh, report);
  const CellBlend blend = cell_blend(mesh, flat, *clustering, params, weights, parallel);
  const auto wedges = carried_wedges(mesh, flat, *clustering, parallel, report);
  ClusterWriteBack<MeshType> write_back(mesh, flat, clustering->clusters,
                                        clustering->representatives, parallel);
  report.max_error = write_back.furthest_move();
  report.cell_size = clustering->clusters.diameter * flat.box.diagonal;
  report.cost_last = clustering->representatives.largest_cost;
  judge_target(target, static_cast<int>(clustering->clusters.faces.size()), report);
  count_losses(flat, clustering->clusters, report);
  progress.set(1.0);
  progress.ask();
  write_back.run(blend, wedges);
}

/// Decimates a vcg triangle mesh by vertex clustering, in place.
///
/// The mesh needs faces with vertex references and selection flags; no adjacency. Whatever
/// attributes it has are carried. It is left exactly as it was when the parameters or the mesh
/// cannot be used (throws InputError), when it is already small enough, and when `progress` asks to
/// stop (the report says Cancelled). No vertex moves further than max_error of the report, which is
/// at most cell_size; what is thinner than a cell may vanish, and edges may get more than two
/// faces.
///
/// Time O(n), 100 bytes of memory a vertex and 200 an occupied cell.
template <class MeshType>
ClusteringReport decimate_vertex_clustering(MeshType& mesh, const ClusteringParams& params,
                                            const Progress& progress = {}) {
  const auto start = std::chrono::steady_clock::now();
  validate(params);
  ProgressMeter meter(progress);
  ClusteringReport report;
  static_cast<DecimationReport&>(report) = initial_report(mesh);
  try {
    run_vertex_clustering(mesh, params, meter, report);
  } catch (const CancelRequest&) {
    report = {};
    static_cast<DecimationReport&>(report) = initial_report(mesh);
    report.stopped_by = StopReason::Cancelled;
    report.notes.push_back("Cancelled: the mesh is unchanged.");
  }
  report.faces = mesh.fn;
  report.vertices = mesh.vn;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace curvdecim
