// SPDX-License-Identifier: GPL-3.0-or-later
// Our own core without a host, on the terms of the other libraries: the clock covers
// decimate_edge_collapse on a bare vcg mesh in double, which is built before. The speed guard
// compiles it with the cores of two commits, so it uses nothing of the interface but what every
// commit has.
#include <vcg/complex/complex.h>

#include "peer.h"
#if __has_include("vcg_ext/edge_collapse.h")
#include "vcg_ext/edge_collapse.h"
#include "vcg_ext/vertex_clustering.h"
#else  // commits before the headers had the names of the operators
#include "vcg_ext/cluster.h"
#include "vcg_ext/decimate.h"
#endif

namespace {

class BareVertex;
class BareFace;
struct BareTypes
    : vcg::UsedTypes<vcg::Use<BareVertex>::AsVertexType, vcg::Use<BareFace>::AsFaceType> {};
class BareVertex : public vcg::Vertex<BareTypes, vcg::vertex::Coord3d, vcg::vertex::BitFlags> {};
class BareFace : public vcg::Face<BareTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class BareMesh : public vcg::tri::TriMesh<std::vector<BareVertex>, std::vector<BareFace>> {};

void build(const peer::Mesh& mesh, BareMesh& bare) {
  vcg::tri::Allocator<BareMesh>::AddVertices(bare, mesh.vertices());
  vcg::tri::Allocator<BareMesh>::AddFaces(bare, mesh.faces());
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    const double* p = &mesh.points[3 * v];
    bare.vert[v].P() = {p[0], p[1], p[2]};
  }
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const std::int32_t* c = &mesh.corners[3 * f];
    for (int i = 0; i < 3; ++i) bare.face[f].V(i) = &bare.vert[static_cast<std::size_t>(c[i])];
  }
}

peer::Mesh arrays_of(BareMesh& bare) {
  vcg::tri::Allocator<BareMesh>::CompactEveryVector(bare);
  peer::Mesh mesh;
  for (const BareVertex& v : bare.vert) {
    const auto& p = v.cP();
    mesh.points.insert(mesh.points.end(), {p[0], p[1], p[2]});
  }
  for (BareFace& face : bare.face) {
    for (int i = 0; i < 3; ++i) {
      const auto index = vcg::tri::Index(bare, face.V(i));
      mesh.corners.push_back(static_cast<std::int32_t>(index));
    }
  }
  return mesh;
}

curvdecim::Preset preset_of(const std::string& name) {
  if (name == "Fast") return curvdecim::Preset::Fast;
  if (name == "Balanced") return curvdecim::Preset::Balanced;
  if (name == "Best") return curvdecim::Preset::Best;
  throw std::invalid_argument("CurvDecim: no preset " + name);
}

void collapse_edges(const std::string& preset, std::size_t target, BareMesh& mesh) {
  curvdecim::EdgeCollapseParams params;
  params.preset = preset_of(preset);
  params.target_faces = static_cast<int>(target);
  curvdecim::decimate_edge_collapse(mesh, params);
}

void cluster(std::size_t target, BareMesh& mesh) {
  curvdecim::ClusteringParams params;
  params.target_faces = static_cast<int>(target);
  curvdecim::decimate_vertex_clustering(mesh, params);
}

peer::Cost decimate(const std::string& policy, std::size_t target, peer::Mesh& mesh) {
  BareMesh bare;
  build(mesh, bare);
  mesh = {};
  const peer::Cost cost = peer::measure([&] {
    policy == "Clustering" ? cluster(target, bare) : collapse_edges(policy, target, bare);
  });
  mesh = arrays_of(bare);
  return cost;
}

}  // namespace

int main(int count, char** words) { return peer::run(count, words, "this tree", decimate); }
