// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

#include "vcg_ext/clustering/cell_members.h"
#include "vcg_ext/clustering/cell_quadrics.h"
#include "vcg_ext/clustering/cell_sums.h"
#include "vcg_ext/clustering/least_in_box.h"

namespace curvdecim::detail {

/// Where the vertices of each cell go, in the unit box.
struct Representatives {
  std::vector<Vector3> position;  // by cell
  std::vector<int> vertex;        // by cell: of its vertices, the one that stays
  double largest_cost = 0.0;      // of the quadrics
};

/// Places one vertex a cell, in the cell. A vertex that is alone in its cell stays where it is,
/// unless all go to the centres.
class RepresentativeSearch {
 public:
  RepresentativeSearch(const FlatMesh& mesh, const Clusters& clusters, const Parallel& parallel)
      : mesh_(mesh), clusters_(clusters), parallel_(parallel), centers_(clusters.cells()) {
    parallel_.for_each(cells(), [&](int c) { centers_[c] = box(c).center(); });
    find_first_vertices();
  }

  Representatives centers() const { return {centers_, first_, 0.0}; }

  /// weight: by vertex, above 0; empty: 1.
  Representatives means(const std::vector<double>& weight) const {
    const CellSums<PointSum> sums = point_sums(weight);
    Representatives result = start();
    for_shared_cells(
        [&](int c) { result.position[c] = box(c).clamped(centers_[c] + sums[c].mean()); });
    return result;
  }

  /// The median of every coordinate by itself; then the vertex nearest to that.
  Representatives medians() const {
    const Groups members = vertices_by_cell(clusters_);
    Representatives result = start();
    for_shared_cells([&](int c) {
      result.vertex[c] = nearest_member(members[c], median(members[c]));
      result.position[c] = mesh_.position[result.vertex[c]];
    });
    return result;
  }

  /// The point of the cell where the quadric is least. Where it is flat, the mean decides.
  Representatives quadric_minima(double boundary_weight,
                                 const std::vector<double>& importance) const {
    const CellSums<PointSum> sums = point_sums({});
    CellQuadrics planes(mesh_, clusters_, centers_, importance);
    const CellSums<Quadric> quadrics = planes.build(boundary_weight, parallel_);
    Representatives result = start();
    std::vector<double> cost(cells(), 0.0);
    for_shared_cells([&](int c) {
      const Vector3 offset = least_in_cell(quadrics[c], sums[c].mean(), c, planes.at_boundary(c));
      result.position[c] = box(c).clamped(centers_[c] + offset);
      cost[c] = quadrics[c].value(offset);
    });
    for (double each : cost) result.largest_cost = std::max(result.largest_cost, each);
    return result;
  }

 private:
  /// How strongly the mean pulls: to the trace, that is to the strongest direction.
  static constexpr double pull_of_mean = 1e-3;

  int cells() const { return clusters_.cells(); }
  CellBox box(int c) const { return clusters_.box(c, mesh_); }

  void find_first_vertices() {
    first_.resize(cells()), members_.assign(cells(), 0);
    for (int v = static_cast<int>(clusters_.cell_of.size()) - 1; v >= 0; --v)
      if (const int c = clusters_.cell_of[v]; c != Clusters::none) first_[c] = v, ++members_[c];
  }

  Representatives start() const {
    Representatives result{{}, first_, 0.0};
    for (int v : first_) result.position.push_back(mesh_.position[v]);
    return result;
  }

  template <class Work>
  void for_shared_cells(Work work) const {
    parallel_.for_each(cells(), [&](int c) {
      if (members_[c] > 1) work(c);
    });
  }

  CellSums<PointSum> point_sums(const std::vector<double>& weight) const {
    return sum_over<PointSum>(static_cast<int>(mesh_.position.size()), cells(), parallel_,
                              [&](CellSums<PointSum>& into, int v) {
                                const int c = clusters_.cell_of[v];
                                if (c == Clusters::none) return;
                                const double w = weight.empty() ? 1.0 : weight[v];
                                into[c] += PointSum{w, w * (mesh_.position[v] - centers_[c])};
                              });
  }

  /// About the centre. Where a boundary pulls the point out of its cell, it stops on the way there
  /// from the mean: a plane, on which both lie, stays a plane.
  Vector3 least_in_cell(const Quadric& q, const Vector3& mean, int c, bool at_boundary) const {
    const double trace = q.a.trace(), pull = pull_of_mean * trace;
    if (!(trace > std::numeric_limits<double>::min())) return mean;
    const Symmetric3 a = q.a.plus_diagonal(pull);
    const Vector3 b = q.b - pull * mean;
    const CellBox cell = box(c);
    const Vector3 low = cell.low - centers_[c], high = cell.high - centers_[c];
    if (!at_boundary) return LeastInBox(a, b, low, high).from(mean);
    const Vector3 least = -Factorization3(a).solve(b);
    return mean + part_inside(mean, least, low, high) * (least - mean);
  }

  Vector3 median(IndexRange members) const {
    Vector3 result;
    std::vector<double> along(members.size());
    for (int k = 0; k < 3; ++k) {
      std::transform(members.begin(), members.end(), along.begin(),
                     [&](int v) { return mesh_.position[v][k]; });
      const auto middle = along.begin() + along.size() / 2;
      std::nth_element(along.begin(), middle, along.end());
      result[k] = *middle;
      if (along.size() % 2 == 0)
        result[k] = 0.5 * (result[k] + *std::max_element(along.begin(), middle));
    }
    return result;
  }

  /// The member nearest to p; of equals that of the least coordinates, so that the order does not
  /// matter.
  int nearest_member(IndexRange members, const Vector3& p) const {
    const auto rank = [&](int v) {
      const Vector3& x = mesh_.position[v];
      return std::tuple((x - p).squaredNorm(), x[0], x[1], x[2]);
    };
    return *std::min_element(members.begin(), members.end(),
                             [&](int a, int b) { return rank(a) < rank(b); });
  }

  const FlatMesh& mesh_;
  const Clusters& clusters_;
  const Parallel& parallel_;
  std::vector<Vector3> centers_;  // by cell
  std::vector<int> first_;        // by cell: its first vertex
  std::vector<int> members_;      // by cell: how many vertices
};

}  // namespace curvdecim::detail
