// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "vcg_ext/removal/removal_observer.h"

namespace curvdecim::detail {

/// Remembers how to take removals back, the last one first: vertex insertion is the inverse of
/// vertex removal, to the bit.
class RemovalRecord : public RemovalObserver {
 public:
  void before(const WorkingMesh& mesh, const VertexFan& fan, const std::vector<NewFace>&) override {
    begin_.push_back(slots_.size());
    for (int f : fan.faces()) {
      slots_.push_back(f);
      corners_.push_back(mesh.connectivity.face(f));
    }
  }

  std::size_t size() const { return begin_.size(); }

  /// Inserts the vertex that was removed last; there must be one.
  void insert_last(WorkingMesh& mesh) {
    const auto begin = static_cast<std::ptrdiff_t>(begin_.back());
    const std::vector<int> numbers(slots_.begin() + begin, slots_.end());
    const std::vector<Face> corners(corners_.begin() + begin, corners_.end());
    mesh.connectivity.count(mesh.connectivity.replace(numbers, corners));
    for (int f : numbers) mesh.update_plane(f);
    begin_.pop_back(), slots_.resize(slots_.size() - numbers.size());
    corners_.resize(slots_.size());
  }

 private:
  std::vector<std::size_t> begin_;  // by removal: where its faces begin
  std::vector<int> slots_;          // by face around a removed vertex
  std::vector<Face> corners_;       // the same: its corners before
};

}  // namespace curvdecim::detail
