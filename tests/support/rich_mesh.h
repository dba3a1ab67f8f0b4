// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/algorithms/update/normal.h>

#include <cmath>

#include "support/mesh_types.h"

namespace curvdecim::test {

/// What every attribute is made of: affine in position, 0 at the origin and 1 at (1, 1, 1).
inline double affine(const vcg::Point3d& p) { return (p[0] + 2.0 * p[1] + 4.0 * p[2]) / 7.0; }

inline vcg::Color4b affine_color(const vcg::Point3d& p) {
  const auto byte = [](double x) { return static_cast<unsigned char>(std::lround(255.0 * x)); };
  return {byte(affine(p)), byte(1.0 - affine(p)), 128, 255};
}

/// A shape within the unit cube with all attributes set, the vertices' affine in position.
inline void fill_with_attributes(RichMesh& mesh, const Shape& shape) {
  fill(mesh, shape);
  for (RichVertex& v : mesh.vert) {
    v.Q() = affine(v.cP());
    v.R() = static_cast<float>(affine(v.cP()));
    v.C() = affine_color(v.cP());
    v.T() = vcg::TexCoord2d(v.cP()[0], v.cP()[1]);
  }
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    RichFace& face = mesh.face[f];
    face.Q() = static_cast<double>(f);
    face.C() = vcg::Color4b(static_cast<unsigned char>(f % 256),
                            static_cast<unsigned char>(f / 256), 1, 255);
    for (int i = 0; i < 3; ++i) face.WT(i) = vcg::TexCoord2d(face.cP(i)[0], face.cP(i)[1]);
  }
  vcg::tri::UpdateNormal<RichMesh>::PerVertexNormalizedPerFaceNormalized(mesh);
  vcg::tri::UpdateBounding<RichMesh>::Box(mesh);
}

/// Selects the faces whose centre satisfies the condition; returns how many.
template <class Condition>
int select_faces(RichMesh& mesh, Condition condition) {
  int selected = 0;
  for (RichFace& f : mesh.face)
    if (!f.IsD() && condition((f.cP(0) + f.cP(1) + f.cP(2)) / 3.0)) f.SetS(), ++selected;
  return selected;
}

}  // namespace curvdecim::test
