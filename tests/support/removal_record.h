// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "vcg_ext/removal/removal_observer.h"

namespace curvdecim::detail {

/// Remembers how to take removals back, the last one first: vertex insertion is the inverse of
/// vertex removal, to the bit.
class RemovalRecord : public RemovalObserver {
 public:
  void before(const WorkingMesh& mesh, const VertexFan& fan, const std::vector<NewFace>&) override {
    Removal removal{fan.faces(), {}};
    for (int f : fan.faces()) removal.corners.push_back(mesh.connectivity.face(f));
    removals_.push_back(std::move(removal));
  }

  std::size_t size() const { return removals_.size(); }

  /// Inserts the vertex that was removed last; there must be one.
  void insert_last(WorkingMesh& mesh) {
    const auto& [slots, corners] = removals_.back();
    mesh.connectivity.count(mesh.connectivity.replace(slots, corners));
    for (int f : slots) mesh.update_plane(f);
    removals_.pop_back();
  }

 private:
  struct Removal {
    std::vector<int> slots;     // of the faces around the vertex
    std::vector<Face> corners;  // the same: before
  };

  std::vector<Removal> removals_;  // in their order
};

}  // namespace curvdecim::detail
