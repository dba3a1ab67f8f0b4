// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "vcg_ext/clustering/clusters.h"
#include "vcg_ext/clustering/representatives.h"
#include "vcg_ext/guard/distances_to_surface.h"

namespace curvdecim::detail {

/// What a clustering leaves of a mesh.
struct Clustering {
  Clusters clusters;
  Representatives representatives;
  double distance = 0.0;    ///< with a bound: the two-sided one to the input, in the unit box
  bool is_bounded = false;  ///< larger cells would have left the bound

  /// As a surface.
  Triangle triangle(int f) const {
    return triangle_of(representatives.position, clusters.faces[f].cells);
  }
  int face_count() const { return static_cast<int>(clusters.faces.size()); }
};

/// Looks for the largest cells that leave a surface within a distance to the input, both ways.
///
///   halve the diameter until the surface is within, or double it as long as it is
///   narrow down what lies between                                 (guard/distances_to_surface.h)
///
/// Thin parts that vanish, and cells that end elsewhere, may bring a smaller diameter too far, too:
/// what is found is within, but need not be the largest of all.
template <class ClusteringAt>
class CellsWithin {
 public:
  /// limit: in the unit box. clustering_at(diameter): the Clustering.
  CellsWithin(const FlatMesh& mesh, double limit, const Parallel& parallel,
              ClusteringAt clustering_at)
      : mesh_(mesh),
        limit_(limit),
        parallel_(parallel),
        clustering_at_(clustering_at),
        living_(indices_where(static_cast<int>(mesh.faces.size()), parallel,
                              [&](int f) { return FlatMesh::is_face(mesh.faces[f]); })),
        input_{mesh, living_},
        tree_(input_, static_cast<int>(living_.size()), parallel) {}

  /// most: the largest diameter that is asked for. nullopt: none that the grid may have is within.
  std::optional<Clustering> run(double most) {
    constexpr double start = 4.0;  // times the limit: most meshes bear more
    const double least = CellGrid::least_diameter(mesh_.half_size);
    double good = std::clamp(start * limit_, least, most), bad = good;
    if (try_at(good)) {
      while (good < most && try_at(bad = std::min(most, 2.0 * good))) good = bad;
    } else {
      do {
        if (bad == least) return std::nullopt;
        bad = good, good = std::max(least, 0.5 * good);
      } while (!try_at(good));
    }
    if (good == most) return std::move(best_);
    narrow(good, bad);
    best_->is_bounded = true;
    return std::move(best_);
  }

 private:
  struct Input {
    const FlatMesh& mesh;
    const std::vector<int>& living;

    Triangle triangle(int i) const { return mesh.triangle(living[i]); }
  };

  void narrow(double good, double bad) {
    constexpr int steps = 4;  // a twentieth of the diameter is left
    for (int step = 0; step < steps; ++step) {
      const double between = std::sqrt(good * bad);
      (try_at(between) ? good : bad) = between;
    }
  }

  /// Keeps the clustering where it is within the limit.
  bool try_at(double diameter) {
    Clustering tried = clustering_at_(diameter);
    parallel_.progress().ask();
    if (tried.face_count() == 0) return false;
    tried.distance = largest(tried, tried.face_count(), tree_);
    if (!(tried.distance <= limit_)) return false;
    tried.distance = std::max(tried.distance, from_input(tried));
    if (!(tried.distance <= limit_)) return false;
    best_ = std::move(tried);
    return true;
  }

  double from_input(const Clustering& tried) const {
    const TriangleTree<Clustering> tree(tried, tried.face_count(), parallel_);
    return largest(input_, static_cast<int>(living_.size()), tree);
  }

  template <class From, class To>
  double largest(const From& from, int count, const TriangleTree<To>& to) const {
    const auto distances = distances_to_surface(from, count, to, limit_, nullptr, parallel_);
    return *std::max_element(distances.begin(), distances.end());
  }

  const FlatMesh& mesh_;
  const double limit_;
  const Parallel& parallel_;
  const ClusteringAt clustering_at_;
  const std::vector<int> living_;  // faces
  const Input input_;
  const TriangleTree<Input> tree_;
  std::optional<Clustering> best_;
};

}  // namespace curvdecim::detail
