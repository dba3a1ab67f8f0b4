// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include "vcg_ext/host_mesh/custom_attributes.h"
#include "vcg_ext/params.h"

namespace curvdecim::detail {

/// Faces of a vcg mesh that are the same in what the user names.
template <class MeshType>
class FaceGroups {
 public:
  /// Where the mesh lacks what tells them apart, all faces are one group.
  FaceGroups(const MeshType& mesh, KeepBordersOf by)
      : mesh_(mesh), by_(is_there(by) ? by : KeepBordersOf::Nothing) {}

  bool exist() const { return by_ != KeepBordersOf::Nothing; }

  bool are_one(int f, int g) const {
    switch (by_) {
      case KeepBordersOf::Nothing: return true;
      case KeepBordersOf::FaceColor: return mesh_.face[f].cC() == mesh_.face[g].cC();
      case KeepBordersOf::FaceQuality: return mesh_.face[f].cQ() == mesh_.face[g].cQ();
      case KeepBordersOf::FaceAttributes: return are_same_in_known(mesh_.face_attr, f, g);
    }
    return true;
  }

 private:
  bool is_there(KeepBordersOf by) const {
    switch (by) {
      case KeepBordersOf::Nothing: return false;
      case KeepBordersOf::FaceColor: return vcg::tri::HasPerFaceColor(mesh_);
      case KeepBordersOf::FaceQuality: return vcg::tri::HasPerFaceQuality(mesh_);
      case KeepBordersOf::FaceAttributes: return !mesh_.face_attr.empty();
    }
    return false;
  }

  const MeshType& mesh_;
  const KeepBordersOf by_;
};

}  // namespace curvdecim::detail
