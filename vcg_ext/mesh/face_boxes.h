// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cassert>
#include <vector>

#include "vcg_ext/geometry/box_tree.h"
#include "vcg_ext/geometry/morton.h"
#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// Most surfaces have no gaps in the numbers of their faces.
template <class Surface>
bool has_face(const Surface&, int) {
  return true;
}
inline bool has_face(const WorkingMesh& mesh, int f) { return mesh.connectivity.alive(f); }

/// Boxes around the faces of a surface in a box of diagonal 1: leaves of some faces each in the
/// order of a space-filling curve, and a tree over them.
///
/// Surface: triangle(f). Its vertices may move, and faces may go and come, if the boxes are fitted
/// again afterwards.
template <class Surface, int LeafSize>
class FaceBoxes {
 public:
  /// faces: the numbers below it are those of faces; at least one.
  FaceBoxes(const Surface& surface, int faces, const Parallel& parallel)
      : surface_(surface), order_(faces), boxes_((faces + LeafSize - 1) / LeafSize) {
    assert(faces > 0);
    sort_faces(parallel);
    refit(parallel);
  }

  void refit(const Parallel& parallel) {
    boxes_.fit([&](int count, auto work) { parallel.for_each(count, work); },
               [&](int leaf) { return box_of(leaf); });
  }

  /// The boxes of one leaf and of what it is in.
  void refit(int leaf) {
    boxes_.refit(leaf, [&](int of) { return box_of(of); });
  }

  int face_count() const { return static_cast<int>(order_.size()); }

  /// What is in a leaf; a face may be gone.
  IndexRange faces_of(int leaf) const {
    const int begin = leaf * LeafSize;
    return {order_.data() + begin, order_.data() + std::min(face_count(), begin + LeafSize)};
  }

  Box box_of(int leaf) const {
    Box box;
    for (int f : faces_of(leaf))
      if (has_face(surface_, f)) box.add(box_around(surface_.triangle(f)));
    return box;
  }

  const BoxTree& tree() const { return boxes_; }
  const Surface& surface() const { return surface_; }

 private:
  void sort_faces(const Parallel& parallel) {
    const auto keys = along_curve(face_count(), parallel, [&](int f) -> Vector3 {
      if (!has_face(surface_, f)) return Vector3::Zero();
      return center_of(surface_.triangle(f)).cwiseMax(-0.5).cwiseMin(0.5);
    });
    parallel.for_each(face_count(), [&](int i) { order_[i] = keys[i].value; });
  }

  const Surface& surface_;
  std::vector<int> order_;  // faces along the curve
  BoxTree boxes_;
};

}  // namespace curvdecim::detail
