// SPDX-License-Identifier: GPL-3.0-or-later
// A metric of your own. What each call is for, and when it comes: vcg_ext/metric/metric.h.
#include "vcg_ext/own_metric.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <optional>
#include <vector>

#include "bumpy_grid.h"

using namespace curvdecim::metric_api;

/// Costs the squared length of an edge times the turn of the faces around: what is flat goes first.
class LengthTimesTurn {
 public:
  explicit LengthTimesTurn(const WorkingMesh& mesh) : mesh_(mesh) {}

  std::optional<Candidate> evaluate(Edge edge, Allowed allowed, const Vector3&) const {
    // The turn says nothing about the shape of a border, so this metric leaves border edges alone.
    if (mesh_.connectivity.edge_valence(edge.a, edge.b) == 1) return std::nullopt;
    const Vector3 &a = mesh_.position[edge.a], &b = mesh_.position[edge.b];
    if (allowed == Allowed::OntoA) return Candidate{cost(edge), a, 0.0};
    if (allowed == Allowed::OntoB) return Candidate{cost(edge), b, 1.0};
    return Candidate{cost(edge), 0.5 * (a + b), 0.5};
  }

  void estimate(int v, const std::vector<int>& others, std::vector<double>& costs) const {
    costs.resize(others.size());
    for (std::size_t i = 0; i < others.size(); ++i) costs[i] = cost({v, others[i]});
  }

  // All is read from the mesh as it is; a metric that keeps numbers brings them up to date here.
  void initialize(const Parallel&) {}
  void release(const EdgeNeighborhood&, const std::vector<FacePlane>&) {}
  void merge(const VertexMerge&, const EdgeNeighborhood&) {}
  void renew(int, int) {}
  void renumber(const Renumbering&) {}

 private:
  double cost(Edge edge) const {
    return turn(edge) * (mesh_.position[edge.b] - mesh_.position[edge.a]).squaredNorm();
  }

  /// 1 - cosine of the largest angle between a face around the edge and all of them together.
  double turn(Edge edge) const {
    Vector3 sum = Vector3::Zero();
    for (int v : {edge.a, edge.b})
      for (int f : mesh_.connectivity.faces_of(v)) sum += mesh_.plane[f].area_vector();
    const Vector3 together = sum.normalized();
    double cosine = 1.0;
    for (int v : {edge.a, edge.b})
      for (int f : mesh_.connectivity.faces_of(v))
        cosine = std::min(cosine, mesh_.plane[f].normal.dot(together));
    return 1.0 - cosine;
  }

  const WorkingMesh& mesh_;
};

int main() try {
  Mesh mesh;
  make_bumpy_grid(mesh, 32);

  curvdecim::DecimationParams params;
  params.target_faces = 500;
  const curvdecim::DecimationReport report = curvdecim::decimate_by_metric(
      mesh, params, [](const WorkingMesh& working) { return LengthTimesTurn(working); });

  std::cout << report.faces_before << " faces became " << report.faces << " faces\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
