// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/curvature/vertex_curvature.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// The curvature at the vertices of the mesh while it is decimated, brought up to date around each
/// collapse @cite pellizzoni2020.
class CurrentCurvature {
 public:
  explicit CurrentCurvature(const WorkingMesh& mesh) : mesh_(mesh) {}

  void initialize(const Parallel& parallel) {
    angles_.resize(mesh_.plane.size());
    sums_.resize(mesh_.position.size());
    parallel.for_each(static_cast<int>(angles_.size()),
                      [this](int f) { angles_[f] = corner_angles(mesh_, f); });
    parallel.for_each(static_cast<int>(sums_.size()), [this](int v) { sums_[v] = sums_around(v); });
  }

  VertexCurvature at(int v) const { return sums_[v].curvature(mesh_.kind[v]); }

  /// Before a collapse: the faces around the edge leave the vertices that will remain.
  void release(const EdgeNeighborhood& around) {
    for (const auto* faces : {&around.wings(), &around.star()})
      for (int f : *faces) leave(f, around.edge());
  }

  /// After it: the faces that remain are back in their new shape.
  void merge(int keep, const EdgeNeighborhood& around) {
    sums_[keep] = {};
    for (int f : around.star()) {
      if (!mesh_.connectivity.alive(f)) continue;
      angles_[f] = corner_angles(mesh_, f);
      for (int i = 0; i < 3; ++i) add(f, i, 1.0, sums_[mesh_.connectivity.face(f)[i]]);
    }
  }

  /// The faces around v are others now.
  void renew(int v) {
    for (int f : mesh_.connectivity.faces_of(v)) angles_[f] = corner_angles(mesh_, f);
    sums_[v] = sums_around(v);
  }

  void renumber(const Renumbering& numbers) { numbers.faces(angles_), numbers.vertices(sums_); }

 private:
  /// Takes face f from the sums of its corners that are not on the edge.
  void leave(int f, Edge edge) {
    for (int i = 0; i < 3; ++i)
      if (const int v = mesh_.connectivity.face(f)[i]; v != edge.a && v != edge.b)
        add(f, i, -1.0, sums_[v]);
  }

  CurvatureSums sums_around(int v) const {
    CurvatureSums sums;
    for (int f : mesh_.connectivity.faces_of(v)) add(f, mesh_.connectivity.corner(f, v), 1.0, sums);
    return sums;
  }

  void add(int f, int i, double sign, CurvatureSums& sums) const {
    sums.angles += sign * angles_[f][i];
    sums.add(FaceCorner(mesh_, f, mesh_.connectivity.face(f)[i]), sign);
  }

  const WorkingMesh& mesh_;
  std::vector<CornerAngles> angles_;  // by face
  std::vector<CurvatureSums> sums_;   // by vertex
};

}  // namespace curvdecim::detail
