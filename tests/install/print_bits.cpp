// SPDX-License-Identifier: GPL-3.0-or-later
// Runs every function of the core and prints, for each, a number that changes with any bit of the
// result. The core comes first, as it has to where its target's flags are not given; with
// VCGLIB_FIRST it comes too late, which is to be refused.
#ifdef VCGLIB_FIRST
#include "support/fingerprint.h"
#endif
#include "vcg_ext/algebraic_sphere.h"
#include "vcg_ext/curvature_importance.h"
#include "vcg_ext/edge_collapse.h"
#include "vcg_ext/vertex_clustering.h"
#include "vcg_ext/vertex_removal.h"
// clang-format off: after the core
#include "bumpy_grid.h"
#include "support/fingerprint.h"

#include <cstdint>
#include <iostream>
#include <string>
// clang-format on

namespace curvdecim::test {
namespace {

constexpr double kept = 0.2;  // of the faces

/// FNV-1a.
std::uint64_t hash(const std::string& bytes) {
  std::uint64_t sum = 14695981039346656037u;
  for (unsigned char byte : bytes) sum = (sum ^ byte) * 1099511628211u;
  return sum;
}

/// Everything that the fingerprint reads gets a value.
void add_attributes(RichMesh& mesh) {
  for (RichVertex& v : mesh.vert) {
    const auto& p = v.cP();
    v.Q() = 1.0 + p[0] * p[1], v.R() = 1.0f;
    v.C() = vcg::Color4b(static_cast<unsigned char>(200 * p[0]), 100, 50, 255);
    v.N() = vcg::Point3d(p[2], p[1], 1.0);
    v.T() = {p[1], p[0]}, v.T().n() = 0;
  }
  for (RichFace& f : mesh.face) {
    f.N() = vcg::Point3d(0, 0, 1), f.Q() = 1.0, f.C() = vcg::Color4b(1, 2, 3, 255);
    for (int i = 0; i < 3; ++i) f.WT(i) = {f.P(i)[0], f.P(i)[1]}, f.WT(i).n() = 0;
  }
}

template <class Run>
void print(const std::string& name, Run run) {
  Mesh grid;
  make_bumpy_grid(grid, 48);
  RichMesh mesh;
  fill(mesh, shape_of(grid));
  add_attributes(mesh);
  run(mesh);
  std::cout << name << " " << std::hex << hash(bytes_of(mesh)) << "\n";
}

void print_collapse(const std::string& name, EdgeCollapseParams params) {
  if (params.max_error == 0.0) params.target_fraction = kept;
  print(name, [&](RichMesh& mesh) { decimate_edge_collapse(mesh, params); });
}

void print_collapses() {
  EdgeCollapseParams params;
  params.preset = Preset::Best;
  print_collapse("best", params);
  params = {}, params.metric = Metric::CurvatureAdditive;
  print_collapse("additive", params);
  params = {}, params.preset = Preset::Custom, params.scheduler = Scheduler::Eager;
  params.quadrics = Quadrics::Accumulated, params.placement = Placement::Line;
  params.curvature_of = CurvatureOf::Current;
  print_collapse("accumulated", params);
  params = {}, params.target_faces = 0, params.max_error = 0.01;
  print_collapse("bound", params);
}

void print_spheres() {
  SphereParams params;
  params.target_fraction = kept;
  for (SpherePlacement placement : {SpherePlacement::Free3D, SpherePlacement::OnSphereAlongEdge}) {
    params.placement = placement;
    print(std::string("sphere ") + label_of(placement),
          [&](RichMesh& mesh) { decimate_algebraic_sphere(mesh, params); });
  }
}

void print_others() {
  VertexRemovalParams removal;
  removal.target_fraction = kept;
  print("removal", [&](RichMesh& mesh) { decimate_vertex_removal(mesh, removal); });
  ClusteringParams clustering;
  clustering.target_fraction = kept;
  print("clustering", [&](RichMesh& mesh) { decimate_vertex_clustering(mesh, clustering); });
  print("importance", [](RichMesh& mesh) { curvature_importance(mesh, ImportanceParams()); });
}

}  // namespace
}  // namespace curvdecim::test

int main() {
  curvdecim::test::print_collapses();
  curvdecim::test::print_spheres();
  curvdecim::test::print_others();
}
