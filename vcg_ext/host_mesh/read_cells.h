// SPDX-License-Identifier: GPL-3.0-or-later
// What a clustering reads of the host's mesh beside its faces: weights and attributes.
#pragma once

#include <vcg/complex/complex.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/clustering/cell_texture.h"
#include "vcg_ext/clustering/clustering_operator.h"
#include "vcg_ext/curvature/curvature_field.h"
#include "vcg_ext/host_mesh/read_carried.h"
#include "vcg_ext/host_mesh/read_mesh.h"

namespace curvdecim::detail {

/// Spreads values of some vertices over all of the host's; 0 for the others.
inline std::vector<double> scattered(const std::vector<int>& vertices,
                                     const std::vector<double>& values, std::size_t count) {
  std::vector<double> result(values.empty() ? 0 : count, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) result[vertices[i]] = values[i];
  return result;
}

/// use: what asks for the quality.
template <class MeshType>
std::vector<double> quality_weights(const MeshType& mesh, const FlatMesh& flat, const char* use,
                                    const Parallel& parallel, DecimationReport& report) {
  const std::vector<int> vertices = vertices_in_use(flat, parallel);
  const std::vector<double> values = importance_from_quality(mesh, vertices);
  if (values.empty()) note_no_quality(use, report);
  return scattered(vertices, values, mesh.vert.size());
}

/// By area, or by area and curvature; above 0, so that every cell has a mean.
template <class MeshType>
std::vector<double> surface_weights(const MeshType& mesh, MeanWeight by, const Parallel& parallel) {
  constexpr double least = 1e-9;  // of the largest
  const WorkingCopy copy = read_mesh(mesh, false, parallel);
  const CurvatureField field = curvature_field(copy.mesh, CurvatureParams(), parallel);
  std::vector<double> values = field.area;
  for (std::size_t v = 0; v < values.size() && by == MeanWeight::Curvature; ++v)
    values[v] *= field.value[v];
  const double largest = *std::max_element(values.begin(), values.end());
  for (double& value : values) value = largest > 0.0 ? std::max(value / largest, least) : 1.0;
  std::vector<double> weights = scattered(copy.vertex_of, values, mesh.vert.size());
  for (double& weight : weights) weight = std::max(weight, least);
  return weights;
}

/// quality_weight: whether the quality weighs the quadrics.
template <class MeshType, class Run>
ClusteringWeights read_weights(const MeshType& mesh, const FlatMesh& flat, bool quality_weight,
                               const ClusteringPlan& plan, const Run& run) {
  ClusteringWeights weights;
  if (quality_weight && plan.representative == Representative::Quadric)
    weights.importance =
        quality_weights(mesh, flat, "The weight by quality", run.parallel, run.report);
  if (plan.representative != Representative::WeightedMean) return weights;
  weights.mean = plan.mean_weight == MeanWeight::Quality
                     ? quality_weights(mesh, flat, "The mean by quality", run.parallel, run.report)
                     : surface_weights(mesh, plan.mean_weight, run.parallel);
  return weights;
}

/// Where the attributes of a cell's vertex come from.
template <class MeshType>
CellBlend cell_blend(const MeshType& mesh, const FlatMesh& flat, const Clustering& clustering,
                     Representative representative, const ClusteringWeights& weights,
                     const Parallel& parallel) {
  const Clusters& clusters = clustering.clusters;
  const Representatives& representatives = clustering.representatives;
  const bool vary = has_varying_attributes(mesh, vertices_in_use(flat, parallel), parallel);
  if (!vary && !vcg::tri::HasPerVertexNormal(mesh))
    return CellBlend::of_vertices(representatives.vertex);
  switch (representative) {
    case Representative::Median: return CellBlend::of_vertices(representatives.vertex);
    case Representative::Mean: return CellBlend::of_members(clusters, {});
    case Representative::WeightedMean: return CellBlend::of_members(clusters, weights.mean);
    case Representative::Quadric:
    case Representative::CellCenter: break;
  }
  return vary ? CellBlend::of_surface(flat, clusters, representatives, parallel)
              : CellBlend::of_members(clusters, {});
}

template <class MeshType>
std::optional<std::vector<FaceWedges>> cell_wedges(const MeshType& mesh, const FlatMesh& flat,
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

/// Reads what the cells carry; notes what the user should know of it.
template <class MeshType, class Run>
CarriedByCells read_carried(const MeshType& mesh, const FlatMesh& flat,
                            const Clustering& clustering, const ClusteringPlan& plan,
                            const ClusteringWeights& weights, const Run& run) {
  note_dropped_attributes(mesh, run.parallel, run.report);
  return {cell_blend(mesh, flat, clustering, plan.representative, weights, run.parallel),
          cell_wedges(mesh, flat, clustering, run.parallel, run.report)};
}

}  // namespace curvdecim::detail
