// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/clustering/cell_search.h"
#include "vcg_ext/clustering/manifold_edges.h"
#include "vcg_ext/clustering/representatives.h"
#include "vcg_ext/parallel.h"
#include "vcg_ext/params.h"
#include "vcg_ext/progress_meter.h"

namespace curvdecim {

/// What a vertex counts; empty: 1.
struct ClusteringWeights {
  std::vector<double> mean;        // by vertex, above 0: in WeightedMean
  std::vector<double> importance;  // by vertex, above 0: a factor on the planes
};

/// What is left of a mesh.
struct Clustering {
  Clusters clusters;
  Representatives representatives;
};

/// Vertex clustering @cite rossignac1993, ciolczyk:
///
///   grid <- cells of the given size, or of the size that leaves the target
///   every vertex into its cell
///   a face stays where its vertices are in three cells; one for each three
///   ManifoldEdges? drop faces at edges with more than two
///   one vertex a cell, at the representative
class VertexClustering {
 public:
  VertexClustering(const FlatMesh& mesh, const ClusteringParams& params,
                   const ClusteringWeights& weights, const Parallel& parallel)
      : mesh_(mesh), params_(params), weights_(weights), parallel_(parallel) {}

  /// target: faces; 0: cells have the diameter, in the unit box. nullopt: no face would be left.
  /// Throws CancelRequest.
  std::optional<Clustering> run(double diameter, int target, ProgressMeter& progress) const {
    progress.begin("Clustering vertices");
    const auto cluster_at = [this](double size) { return faces_between_cells(size); };
    std::optional<Clusters> clusters =
        target > 0 ? CellSearch(mesh_, target, cluster_at).run() : faces_between_cells(diameter);
    if (!clusters || clusters->faces.empty()) return std::nullopt;
    progress.set(0.5);
    progress.ask();
    Representatives representatives = represent(*clusters);
    return Clustering{std::move(*clusters), std::move(representatives)};
  }

 private:
  Clusters faces_between_cells(double diameter) const {
    Clusters clusters = cluster(mesh_, diameter, parallel_);
    if (params_.manifold_edges) drop_crowded(clusters);
    return clusters;
  }

  Representatives represent(const Clusters& clusters) const {
    const RepresentativeSearch search(mesh_, clusters, parallel_);
    switch (params_.representative) {
      case Representative::Quadric:
        return search.quadric_minima(params_.boundary_weight, weights_.importance);
      case Representative::Mean: return search.means({});
      case Representative::WeightedMean: return search.means(weights_.mean);
      case Representative::Median: return search.medians();
      case Representative::CellCenter: break;
    }
    return search.centers();
  }

  void drop_crowded(Clusters& clusters) const {
    std::vector<Face> staying;
    for (const Face& face : mesh_.staying)
      if (face[0] >= 0 && face[1] >= 0 && face[2] >= 0) staying.push_back(clusters.cells_of(face));
    const std::vector<bool> kept = ManifoldEdges(clusters.faces, staying).run();
    std::vector<CellFace> left;
    for (std::size_t f = 0; f < kept.size(); ++f)
      if (kept[f]) left.push_back(clusters.faces[f]);
    clusters.crowded = static_cast<int>(clusters.faces.size() - left.size());
    clusters.faces.swap(left);
  }

  const FlatMesh& mesh_;
  const ClusteringParams& params_;
  const ClusteringWeights& weights_;
  const Parallel& parallel_;
};

}  // namespace curvdecim
