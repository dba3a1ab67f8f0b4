// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "vcg_ext/errors.h"
#include "vcg_ext/geometry/vector3.h"
#include "vcg_ext/host_mesh/custom_attributes.h"
#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/mesh/wedge_coordinate.h"

namespace curvdecim::detail {

/// Bits of a vertex that say something about the mesh: that it is selected, and a user's.
template <class Vertex>
int lasting_bits() {
  return Vertex::SELECTED | ~(Vertex::USER0 - 1);
}

template <class Vertex>
Eigen::Vector2d curvatures_of(const Vertex& vertex) {
  return {double(vertex.cK1()), double(vertex.cK2())};
}

template <class Vertex>
auto curvature_directions_of(const Vertex& vertex) {
  return std::array{vertex.cPD1(), vertex.cPD2()};
}

template <class TexCoord>
WedgeCoordinate coordinate_of(const TexCoord& texture) {
  return {double(texture.u()), double(texture.v()), texture.n()};
}

/// It keeps its texture page.
template <class TexCoord>
void set_coordinate(TexCoord& texture, double u, double v) {
  texture.u() = static_cast<decltype(texture.u() + 0)>(u);
  texture.v() = static_cast<decltype(texture.v() + 0)>(v);
}

/// How what the vertices of a vcg mesh carry is read as values that can be blended, and written
/// back. MeshType may be const where nothing is written.
template <class MeshType>
class VertexAttributes {
 public:
  explicit VertexAttributes(MeshType& mesh) : mesh_(mesh) {}

  /// use(read, write) for each attribute that the mesh has: read(v) gives the value of vertex v,
  /// write(v, value) puts one back.
  template <class Use>
  void for_each(Use use) const {
    if (vcg::tri::HasPerVertexNormal(mesh_)) with_normal(use);
    for_each_but_normal(use);
  }

  template <class Use>
  void for_each_but_normal(Use use) const {
    if (vcg::tri::HasPerVertexQuality(mesh_)) with_quality(use);
    if (vcg::tri::HasPerVertexRadius(mesh_)) with_radius(use);
    if (vcg::tri::HasPerVertexColor(mesh_)) with_color(use);
    if (vcg::tri::HasPerVertexTexCoord(mesh_)) with_texture(use);
    if (vcg::tri::HasPerVertexCurvatureDir(mesh_)) with_curvature(use);
    with_flags(use);
    for_each_custom(mesh_.vert_attr, use);
  }

 private:
  // Values to be written are `auto`, so that a const mesh will do where none is.

  template <class Use>
  void with_quality(Use& use) const {
    use([this](int v) { return static_cast<double>(mesh_.vert[v].cQ()); },
        [this](int v, const auto& q) { assign_number(mesh_.vert[v].Q(), q); });
  }

  template <class Use>
  void with_radius(Use& use) const {
    use([this](int v) { return static_cast<double>(mesh_.vert[v].cR()); },
        [this](int v, const auto& r) { assign_number(mesh_.vert[v].R(), r); });
  }

  template <class Use>
  void with_color(Use& use) const {
    use(
        [this](int v) {
          const auto& c = mesh_.vert[v].cC();
          return Eigen::Vector4d(c[0], c[1], c[2], c[3]);
        },
        [this](int v, const auto& c) { set_color(mesh_.vert[v].C(), c); });
  }

  template <class Use>
  void with_normal(Use& use) const {
    use([this](int v) { return vector_of(mesh_.vert[v].cN()); },
        [this](int v, const auto& n) {
          const double length = n.norm();
          if (length > 0.0) assign(mesh_.vert[v].N(), n / length);
        });
  }

  template <class Use>
  void with_texture(Use& use) const {
    use(
        [this](int v) {
          const auto& t = mesh_.vert[v].cT();
          return Eigen::Vector2d(t.u(), t.v());
        },
        [this](int v, const auto& t) { set_coordinate(mesh_.vert[v].T(), t.x(), t.y()); });
    use([this](int v) { return Label<int>{mesh_.vert[v].cT().n()}; },
        [this](int v, const auto& page) { mesh_.vert[v].T().n() = page.value; });
  }

  /// A direction and its opposite are the same one, so that there is no mean of two.
  template <class Use>
  void with_curvature(Use& use) const {
    use([this](int v) { return curvatures_of(mesh_.vert[v]); },
        [this](int v, const auto& k) { set_curvatures(mesh_.vert[v], k); });
    using Directions = decltype(curvature_directions_of(mesh_.vert[0]));
    use([this](int v) { return Label<Directions>{curvature_directions_of(mesh_.vert[v])}; },
        [this](int v, const auto& d) { set_curvature_directions(mesh_.vert[v], d.value); });
  }

  template <class Use>
  void with_flags(Use& use) const {
    const int lasting = lasting_bits<typename MeshType::VertexType>();
    use([this, lasting](int v) { return Label<int>{mesh_.vert[v].cFlags() & lasting}; },
        [this, lasting](int v, const auto& bits) {
          set_bits(mesh_.vert[v].Flags(), lasting, bits.value);
        });
  }

  template <class Color>
  static void set_color(Color& color, const Eigen::Vector4d& c) {
    for (int k = 0; k < 4; ++k)
      color[k] = static_cast<unsigned char>(std::lround(std::clamp(c[k], 0.0, 255.0)));
  }

  template <class Flags>
  static void set_bits(Flags& flags, int which, int bits) {
    flags = (flags & ~which) | bits;
  }

  template <class Vertex>
  static void set_curvatures(Vertex& vertex, const Eigen::Vector2d& k) {
    assign_number(vertex.K1(), k.x()), assign_number(vertex.K2(), k.y());
  }

  template <class Vertex, class Directions>
  static void set_curvature_directions(Vertex& vertex, const Directions& directions) {
    vertex.PD1() = directions[0], vertex.PD2() = directions[1];
  }

  template <class Number>
  static void assign_number(Number& number, double value) {
    number = static_cast<Number>(value);
  }

  MeshType& mesh_;
};

template <class FaceType>
FaceWedges wedges_of(const FaceType& face) {
  return {coordinate_of(face.cWT(0)), coordinate_of(face.cWT(1)), coordinate_of(face.cWT(2))};
}

/// The face keeps its texture page.
template <class FaceType>
void write_wedges(FaceType& face, const FaceWedges& wedges) {
  for (int i = 0; i < 3; ++i) set_coordinate(face.WT(i), wedges[i].u, wedges[i].v);
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
