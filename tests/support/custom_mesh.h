// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/rich_mesh.h"

namespace curvdecim::test {

/// A mesh that may get custom attributes, and frees them: a vcg mesh does not do that itself.
class CustomMesh : public RichMesh {
 public:
  explicit CustomMesh(const Shape& shape) { fill_with_attributes(*this, shape); }
  CustomMesh(const CustomMesh&) = delete;
  CustomMesh& operator=(const CustomMesh&) = delete;
  ~CustomMesh() { drop(vert_attr), drop(face_attr), drop(mesh_attr); }

 private:
  template <class Attributes>
  static void drop(Attributes& attributes) {
    for (const auto& attribute : attributes) delete attribute._handle;
    attributes.clear();
  }
};

}  // namespace curvdecim::test
