// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <algorithm>
#include <cmath>

#include "vcg_ext/geometry/vector3.h"

namespace curvdecim {

/// How the attributes of a vcg mesh's vertices are read as vectors over double, to be blended, and
/// written back.
template <class MeshType>
class VertexAttributes {
 public:
  using Vertex = typename MeshType::VertexType;

  /// use(read, write) for each attribute that the mesh has: read(vertex) gives a value of a vector
  /// space, write(vertex, value) puts it back.
  template <class Use>
  static void for_each(const MeshType& mesh, Use use) {
    if (vcg::tri::HasPerVertexQuality(mesh)) use(read_quality, write_quality);
    if (vcg::tri::HasPerVertexRadius(mesh)) use(read_radius, write_radius);
    if (vcg::tri::HasPerVertexColor(mesh)) use(read_color, write_color);
    if (vcg::tri::HasPerVertexNormal(mesh)) use(read_normal, write_normal);
    if (vcg::tri::HasPerVertexTexCoord(mesh)) use(read_texture, write_texture);
  }

 private:
  static constexpr auto read_quality = [](const Vertex& v) { return static_cast<double>(v.cQ()); };
  static constexpr auto write_quality = [](Vertex& v, double q) {
    v.Q() = static_cast<decltype(v.cQ() + 0)>(q);
  };

  static constexpr auto read_radius = [](const Vertex& v) { return static_cast<double>(v.cR()); };
  static constexpr auto write_radius = [](Vertex& v, double r) {
    v.R() = static_cast<decltype(v.cR() + 0)>(r);
  };

  static constexpr auto read_color = [](const Vertex& v) {
    return Eigen::Vector4d(v.cC()[0], v.cC()[1], v.cC()[2], v.cC()[3]);
  };
  static constexpr auto write_color = [](Vertex& v, const Eigen::Vector4d& c) {
    for (int k = 0; k < 4; ++k)
      v.C()[k] = static_cast<unsigned char>(std::lround(std::clamp(c[k], 0.0, 255.0)));
  };

  static constexpr auto read_normal = [](const Vertex& v) {
    return Vector3(static_cast<double>(v.cN()[0]), static_cast<double>(v.cN()[1]),
                   static_cast<double>(v.cN()[2]));
  };
  static constexpr auto write_normal = [](Vertex& v, const Vector3& n) {
    using Scalar = typename MeshType::ScalarType;
    const double length = n.norm();
    for (int k = 0; k < 3 && length > 0.0; ++k) v.N()[k] = static_cast<Scalar>(n[k] / length);
  };

  static constexpr auto read_texture = [](const Vertex& v) {
    return Eigen::Vector2d(v.cT().u(), v.cT().v());
  };
  static constexpr auto write_texture = [](Vertex& v, const Eigen::Vector2d& t) {
    using Coordinate = decltype(v.cT().u() + 0);
    v.T().u() = static_cast<Coordinate>(t.x()), v.T().v() = static_cast<Coordinate>(t.y());
  };
};

}  // namespace curvdecim
