// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <vector>

#include "support/shape.h"

namespace curvdecim::test {

// --- with what a decimation needs at least: coordinates, vertex references, flags ----------------

class BareVertex;
class BareFace;
struct BareTypes
    : vcg::UsedTypes<vcg::Use<BareVertex>::AsVertexType, vcg::Use<BareFace>::AsFaceType> {};
class BareVertex : public vcg::Vertex<BareTypes, vcg::vertex::Coord3d, vcg::vertex::BitFlags> {};
class BareFace : public vcg::Face<BareTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class BareMesh : public vcg::tri::TriMesh<std::vector<BareVertex>, std::vector<BareFace>> {};

// --- the same in single precision ----------------------------------------------------------------

class FloatVertex;
class FloatFace;
struct FloatTypes
    : vcg::UsedTypes<vcg::Use<FloatVertex>::AsVertexType, vcg::Use<FloatFace>::AsFaceType> {};
class FloatVertex : public vcg::Vertex<FloatTypes, vcg::vertex::Coord3f, vcg::vertex::Normal3f,
                                       vcg::vertex::Qualityf, vcg::vertex::BitFlags> {};
class FloatFace : public vcg::Face<FloatTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class FloatMesh : public vcg::tri::TriMesh<std::vector<FloatVertex>, std::vector<FloatFace>> {};

// --- a texture by vertex, as glTF has it ---------------------------------------------------------

class SkinnedVertex;
class SkinnedFace;
struct SkinnedTypes
    : vcg::UsedTypes<vcg::Use<SkinnedVertex>::AsVertexType, vcg::Use<SkinnedFace>::AsFaceType> {};
class SkinnedVertex : public vcg::Vertex<SkinnedTypes, vcg::vertex::Coord3d,
                                         vcg::vertex::TexCoord2d, vcg::vertex::BitFlags> {};
class SkinnedFace : public vcg::Face<SkinnedTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class SkinnedMesh : public vcg::tri::TriMesh<std::vector<SkinnedVertex>, std::vector<SkinnedFace>> {
};

// --- every attribute that a host may have --------------------------------------------------------

class RichVertex;
class RichFace;
struct RichTypes
    : vcg::UsedTypes<vcg::Use<RichVertex>::AsVertexType, vcg::Use<RichFace>::AsFaceType> {};
class RichVertex
    : public vcg::Vertex<RichTypes, vcg::vertex::Coord3d, vcg::vertex::Normal3d,
                         vcg::vertex::Qualityd, vcg::vertex::Color4b, vcg::vertex::TexCoord2d,
                         vcg::vertex::Radiusf, vcg::vertex::CurvatureDird, vcg::vertex::VFAdj,
                         vcg::vertex::BitFlags> {};
class RichFace
    : public vcg::Face<RichTypes, vcg::face::VertexRef, vcg::face::Normal3d, vcg::face::Qualityd,
                       vcg::face::Color4b, vcg::face::WedgeTexCoord2d, vcg::face::VFAdj,
                       vcg::face::FFAdj, vcg::face::BitFlags> {};
class RichMesh : public vcg::tri::TriMesh<std::vector<RichVertex>, std::vector<RichFace>> {};

/// Attributes are left at the mesh type's own defaults; curvatures and texture coordinates, which
/// have none, are 0.
template <class MeshType>
void fill(MeshType& mesh, const Shape& shape) {
  using Scalar = typename MeshType::ScalarType;
  vcg::tri::Allocator<MeshType>::AddVertices(mesh, shape.vertices.size());
  for (std::size_t v = 0; v < shape.vertices.size(); ++v)
    for (int k = 0; k < 3; ++k) mesh.vert[v].P()[k] = static_cast<Scalar>(shape.vertices[v][k]);
  if (vcg::tri::HasPerVertexCurvatureDir(mesh))
    for (auto& v : mesh.vert) v.PD1().SetZero(), v.PD2().SetZero(), v.K1() = v.K2() = 0;
  vcg::tri::Allocator<MeshType>::AddFaces(mesh, shape.faces.size());
  for (std::size_t f = 0; f < shape.faces.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      mesh.face[f].V(i) = &mesh.vert[shape.faces[f][i]];
      if (!vcg::tri::HasPerWedgeTexCoord(mesh)) continue;
      mesh.face[f].WT(i).u() = mesh.face[f].WT(i).v() = 0;
      mesh.face[f].WT(i).n() = 0;
    }
}

/// The living elements.
template <class MeshType>
Shape shape_of(const MeshType& mesh) {
  Shape shape;
  std::vector<int> index(mesh.vert.size(), -1);
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    if (mesh.vert[v].IsD()) continue;
    index[v] = shape.vertex_count();
    const auto& p = mesh.vert[v].cP();
    shape.vertices.push_back({double(p[0]), double(p[1]), double(p[2])});
  }
  for (const auto& face : mesh.face) {
    if (face.IsD()) continue;
    Corners corners;
    for (int i = 0; i < 3; ++i) corners[i] = index.at(face.cV(i) - mesh.vert.data());
    shape.faces.push_back(corners);
  }
  return shape;
}

}  // namespace curvdecim::test
