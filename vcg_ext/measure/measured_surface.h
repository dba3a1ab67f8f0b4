// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "vcg_ext/measure/face_tree.h"
#include "vcg_ext/mesh/wedge_coordinate.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/pieces.h"

namespace curvdecim::detail {

/// A surface that is measured, in the box of diagonal 1 around the original: its faces with an
/// area, numbered anew, and what is nearest on them.
class MeasuredSurface {
 public:
  /// vertices: the places of the host's vertices. A face of the mesh must have an area.
  MeasuredSurface(WorkingMesh mesh, std::vector<Vector3> vertices, const Parallel& parallel)
      : mesh_(std::move(mesh)),
        vertices_(std::move(vertices)),
        solid_(indices_where(mesh_.connectivity.face_slots(), parallel,
                             [&](int f) { return mesh_.plane[f].area > 0.0; })),
        tree_(
            face_count(), [&](int i) { return triangle(i); }, parallel) {
    for (int f : solid_) area_ += mesh_.plane[f].area;
  }

  const WorkingMesh& mesh() const { return mesh_; }
  const std::vector<Vector3>& vertices() const { return vertices_; }

  /// Faces with an area.
  int face_count() const { return static_cast<int>(solid_.size()); }
  Triangle triangle(int i) const { return mesh_.triangle(solid_[i]); }
  const FacePlane& plane(int i) const { return mesh_.plane[solid_[i]]; }
  /// The number that face i has in the mesh.
  int number_in_mesh(int i) const { return solid_[i]; }

  double area() const { return area_; }
  SurfacePoint nearest(const Vector3& p, int hint) const { return tree_.nearest(p, hint); }

 private:
  WorkingMesh mesh_;
  std::vector<Vector3> vertices_;
  std::vector<int> solid_;
  FaceTree tree_;
  double area_ = 0.0;
};

}  // namespace curvdecim::detail
