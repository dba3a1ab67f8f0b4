// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/collapse/collapse_observer.h"

namespace curvdecim::detail {

/// The faces that were made where the topology gave way: each carries what a face beside it does.
class FaceCopies : public CollapseObserver {
 public:
  /// Numbers in the mesh that the working mesh was taken from.
  struct Copy {
    int to, from;
  };

  void make_room(int) override {}
  void before(const WorkingMesh&, const EdgeNeighborhood&, const EdgeCharts&, const VertexMerge&,
              int) override {}
  void renumber(const Renumbering&) override {}

  void added(const WorkingMesh& mesh, int f) override {
    const Face& face = mesh.connectivity.face(f);
    for (int i = 0; i < 3; ++i) {
      const int beside = mesh.connectivity.face_across(f, face[i], face[(i + 1) % 3]);
      if (beside < 0) continue;
      copies_.push_back({mesh.face_origin[f], mesh.face_origin[beside]});
      return;
    }
  }

  /// In the order in which they were made.
  const std::vector<Copy>& copies() const { return copies_; }

 private:
  std::vector<Copy> copies_;
};

}  // namespace curvdecim::detail
