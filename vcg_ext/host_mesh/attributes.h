// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "vcg_ext/errors.h"
#include "vcg_ext/geometry/vector3.h"
#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/mesh/wedge_coordinate.h"

namespace curvdecim::detail {

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

  static constexpr auto read_normal = [](const Vertex& v) { return vector_of(v.cN()); };
  static constexpr auto write_normal = [](Vertex& v, const Vector3& n) {
    const double length = n.norm();
    if (length > 0.0) assign(v.N(), n / length);
  };

  static constexpr auto read_texture = [](const Vertex& v) {
    return Eigen::Vector2d(v.cT().u(), v.cT().v());
  };
  static constexpr auto write_texture = [](Vertex& v, const Eigen::Vector2d& t) {
    using Coordinate = decltype(v.cT().u() + 0);
    v.T().u() = static_cast<Coordinate>(t.x()), v.T().v() = static_cast<Coordinate>(t.y());
  };
};

/// The wedge texture coordinates of a vcg face.
template <class FaceType>
FaceWedges wedges_of(const FaceType& face) {
  FaceWedges wedges;
  for (int i = 0; i < 3; ++i) {
    const auto& texture = face.cWT(i);
    wedges[i] = {double(texture.u()), double(texture.v()), texture.n()};
  }
  return wedges;
}

/// The face keeps its texture page.
template <class FaceType>
void write_wedges(FaceType& face, const FaceWedges& wedges) {
  for (int i = 0; i < 3; ++i) {
    auto& texture = face.WT(i);
    texture.u() = static_cast<decltype(texture.u() + 0)>(wedges[i].u);
    texture.v() = static_cast<decltype(texture.v() + 0)>(wedges[i].v);
  }
}

/// The face keeps its texture page. texture: by wedge.
template <class FaceType>
void write_coordinates(FaceType& face, const Face& wedges,
                       const std::vector<Eigen::Vector2d>& texture) {
  for (int i = 0; i < 3; ++i) {
    auto& to = face.WT(i);
    to.u() = static_cast<decltype(to.u() + 0)>(texture[wedges[i]].x());
    to.v() = static_cast<decltype(to.v() + 0)>(texture[wedges[i]].y());
  }
}

/// The quality of these vertices, scaled to a largest value of 1, as a factor on the cost. Values
/// at or below zero count as nearly nothing; empty: no vertex has one above zero. Throws InputError
/// where one is not finite.
template <class MeshType>
std::vector<double> importance_from_quality(const MeshType& mesh,
                                            const std::vector<int>& vertices) {
  constexpr double least = 1e-6;  // of the largest: still ordered by error among themselves
  if (!vcg::tri::HasPerVertexQuality(mesh)) return {};
  std::vector<double> importance;
  for (int v : vertices) {
    importance.push_back(static_cast<double>(mesh.vert[v].cQ()));
    if (!std::isfinite(importance.back()))
      throw InputError("Vertex quality is used as a weight, but that of vertex " +
                       std::to_string(v) + " is not finite.");
  }
  const double largest = *std::max_element(importance.begin(), importance.end());
  if (!(largest > 0.0)) return {};
  for (double& value : importance) value = std::max(value / largest, least);
  return importance;
}

/// values: by vertex of `vertices`.
template <class MeshType>
void write_quality(MeshType& mesh, const std::vector<int>& vertices,
                   const std::vector<double>& values) {
  using Quality = std::decay_t<decltype(mesh.vert[0].Q())>;
  for (std::size_t v = 0; v < values.size(); ++v)
    mesh.vert[vertices[v]].Q() = static_cast<Quality>(values[v]);
}

}  // namespace curvdecim::detail
