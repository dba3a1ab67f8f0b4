// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/clustering/cell_search.h"
#include "vcg_ext/clustering/cells_within.h"
#include "vcg_ext/clustering/manifold_edges.h"
#include "vcg_ext/clustering/representatives.h"
#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/params.h"

namespace curvdecim::detail {

/// Everything that a vertex clustering needs to know, lengths in the box of diagonal 1. It is made
/// once, from the parameters (run/plan_clustering.h), and never changes.
struct ClusteringPlan {
  int target = 0;         ///< faces to keep; 0: the cells have the diameter
  double diameter = 0.0;  ///< of a cell
  Representative representative = Representative::Quadric;
  MeanWeight mean_weight = MeanWeight::Area;
  double boundary_weight = 1.0;
  bool manifold_edges = false;  ///< drop faces until no edge has more than two
  double max_error = 0.0;       ///< two-sided distance to the input; 0: no bound
  double rounding = 0.0;        ///< of a vertex that is written, in the mesh's unit
};

/// What a vertex counts; empty: 1.
struct ClusteringWeights {
  std::vector<double> mean;        // by vertex, above 0: in WeightedMean
  std::vector<double> importance;  // by vertex, above 0: a factor on the planes
};

/// Makes one vertex of all in a cell of a grid @cite rossignac1993, ciolczyk:
///
///   grid <- cells of the given size, or of the size that leaves the target
///   every vertex into its cell
///   a face stays where its vertices are in three cells; one for each three
///   ManifoldEdges? drop faces at edges with more than two
///   one vertex a cell, at the representative
///   MaxError? the largest cells, up to that size, that keep it             (cells_within.h)
class ClusteringOperator {
 public:
  ClusteringOperator(const FlatMesh& mesh, const ClusteringPlan& plan,
                     const ClusteringWeights& weights, const Parallel& parallel)
      : mesh_(mesh), plan_(plan), weights_(weights), parallel_(parallel) {}

  /// Throws CancelRequest, and InputError where no face would be left.
  Clustering run() const {
    if (plan_.max_error == 0.0) return unbounded();
    const bool has_size = plan_.target > 0 || plan_.diameter > 0.0;
    const double most =
        has_size ? unbounded().clusters.diameter : CellGrid::largest_diameter(mesh_.half_size);
    const auto at = [this](double diameter) {
      return clustering_of(faces_between_cells(diameter));
    };
    std::optional<Clustering> clustering =
        CellsWithin(mesh_, plan_.max_error, parallel_, at).run(most);
    if (!clustering)
      throw InputError(
          "No size of the cells keeps max_error: thin parts vanish. Give a larger one.",
          {"max_error"});
    return *std::move(clustering);
  }

 private:
  static constexpr double searched = 0.3;  // part of the time

  Clustering unbounded() const {
    const auto cluster_at = [this](double size) { return faces_between_cells(size); };
    std::optional<Clusters> clusters =
        plan_.target > 0 ? CellSearch(mesh_, plan_.target, parallel_, cluster_at).run()
                         : faces_between_cells(plan_.diameter);
    if (!clusters || clusters->faces.empty())
      throw InputError(
          "No face would be left: the cells are too large for the mesh. Choose a smaller "
          "cell_size.",
          {"cell_size"});
    parallel_.progress().set(searched);
    std::optional<Clustering> clustering;
    parallel_.progress().along(searched, 1.0,
                               [&] { clustering = clustering_of(*std::move(clusters)); });
    return *std::move(clustering);
  }

  Clustering clustering_of(Clusters clusters) const {
    Representatives representatives = represent(clusters);
    return {std::move(clusters), std::move(representatives)};
  }

  Clusters faces_between_cells(double diameter) const {
    Clusters clusters = cluster(mesh_, diameter, parallel_);
    if (plan_.manifold_edges) drop_crowded(clusters);
    return clusters;
  }

  Representatives represent(const Clusters& clusters) const {
    const RepresentativeSearch search(mesh_, clusters, parallel_);
    switch (plan_.representative) {
      case Representative::Quadric:
        return search.quadric_minima(plan_.boundary_weight, weights_.importance);
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
  const ClusteringPlan& plan_;
  const ClusteringWeights& weights_;
  const Parallel& parallel_;
};

}  // namespace curvdecim::detail
