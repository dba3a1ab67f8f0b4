// SPDX-License-Identifier: GPL-3.0-or-later
// OpenMesh's Decimater with quadrics that may not flip a normal, in double. The clock covers
// initialize, decimate_to_faces and garbage_collection; the mesh and its face normals, which
// ModNormalFlipping wants to be there, are made before.
#include <OpenMesh/Core/System/config.h>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "peer.h"

namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using SurfaceMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Decimater = OpenMesh::Decimater::DecimaterT<SurfaceMesh>;
using Quadric = OpenMesh::Decimater::ModQuadricT<SurfaceMesh>;
using NormalFlipping = OpenMesh::Decimater::ModNormalFlippingT<SurfaceMesh>;

void build(const peer::Mesh& mesh, SurfaceMesh& surface) {
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    const double* p = &mesh.points[3 * v];
    surface.add_vertex({p[0], p[1], p[2]});
  }
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const std::int32_t* c = &mesh.corners[3 * f];
    const auto face =
        surface.add_face(SurfaceMesh::VertexHandle(c[0]), SurfaceMesh::VertexHandle(c[1]),
                         SurfaceMesh::VertexHandle(c[2]));
    if (!face.is_valid()) throw peer::Refused("OpenMesh: not an oriented manifold");
  }
  surface.request_face_normals();
  surface.update_face_normals();
}

peer::Mesh arrays_of(const SurfaceMesh& surface) {
  peer::Mesh mesh;
  for (const auto v : surface.vertices()) {
    const auto& p = surface.point(v);
    mesh.points.insert(mesh.points.end(), {p[0], p[1], p[2]});
  }
  for (const auto f : surface.faces()) {
    for (const auto v : surface.fv_range(f)) mesh.corners.push_back(v.idx());
  }
  return mesh;
}

void collapse(SurfaceMesh& surface, std::size_t target) {
  Decimater decimater(surface);
  Quadric::Handle quadric;
  NormalFlipping::Handle flipping;
  decimater.add(quadric);
  decimater.add(flipping);
  decimater.module(quadric).unset_max_err();
  if (!decimater.initialize()) throw std::runtime_error("OpenMesh: the decimater has no cost");
  const std::size_t any_vertices = 0;
  decimater.decimate_to_faces(any_vertices, target);
  surface.garbage_collection();
}

peer::Cost decimate(const std::string& policy, std::size_t target, peer::Mesh& mesh) {
  if (policy != "quadric") throw std::invalid_argument("OpenMesh: no policy " + policy);
  SurfaceMesh surface;
  build(mesh, surface);
  mesh = {};
  const peer::Cost cost = peer::measure([&] { collapse(surface, target); });
  mesh = arrays_of(surface);
  return cost;
}

std::string version() { return std::to_string(OM_GET_VER) + "." + std::to_string(OM_GET_MAJ); }

}  // namespace

int main(int count, char** words) { return peer::run(count, words, version(), decimate); }
