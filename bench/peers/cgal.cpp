// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's Surface_mesh_simplification. The clock covers the policy's construction (that of
// Garland-Heckbert computes the quadrics), edge_collapse and collect_garbage; the Surface_mesh is
// built before.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/version.h>

#include "peer.h"

namespace {

namespace sms = CGAL::Surface_mesh_simplification;
using Kernel = CGAL::Simple_cartesian<double>;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = SurfaceMesh::Vertex_index;

/// CGAL 5.5 counts edges only; this counts faces, as every other peer does.
struct FaceCountStop {
  const SurfaceMesh& mesh;
  std::size_t target;

  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t) const {
    return mesh.number_of_faces() <= target;
  }
};

SurfaceMesh build(const peer::Mesh& mesh) {
  SurfaceMesh surface;
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    const double* p = &mesh.points[3 * v];
    surface.add_vertex({p[0], p[1], p[2]});
  }
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const std::int32_t* c = &mesh.corners[3 * f];
    if (surface.add_face(Vertex(c[0]), Vertex(c[1]), Vertex(c[2])) == SurfaceMesh::null_face()) {
      throw peer::Refused("CGAL: not an oriented manifold");
    }
  }
  surface.collect_garbage();
  return surface;
}

peer::Mesh arrays_of(const SurfaceMesh& surface) {
  peer::Mesh mesh;
  for (const Vertex v : surface.vertices()) {
    const auto& p = surface.point(v);
    mesh.points.insert(mesh.points.end(), {p.x(), p.y(), p.z()});
  }
  for (const auto f : surface.faces()) {
    for (const Vertex v : surface.vertices_around_face(surface.halfedge(f))) {
      mesh.corners.push_back(static_cast<std::int32_t>(v));
    }
  }
  return mesh;
}

void lindstrom_turk(SurfaceMesh& surface, const FaceCountStop& stop) {
  sms::edge_collapse(surface, stop);  // cost and placement of Lindstrom-Turk are the defaults
}

template <class Policies>
void garland_heckbert(SurfaceMesh& surface, const FaceCountStop& stop) {
  const Policies policies(surface);
  sms::edge_collapse(surface, stop,
                     CGAL::parameters::get_cost(policies.get_cost())
                         .filter(sms::Bounded_normal_change_filter<>())
                         .get_placement(policies.get_placement()));
}

using Collapse = void (*)(SurfaceMesh&, const FaceCountStop&);

Collapse collapse_of(const std::string& policy) {
  if (policy == "lindstrom-turk") return lindstrom_turk;
  if (policy == "plane") {
    return garland_heckbert<sms::GarlandHeckbert_plane_policies<SurfaceMesh, Kernel>>;
  }
  if (policy == "probabilistic-plane") {
    return garland_heckbert<sms::GarlandHeckbert_probabilistic_plane_policies<SurfaceMesh, Kernel>>;
  }
  if (policy == "triangle") {
    return garland_heckbert<sms::GarlandHeckbert_triangle_policies<SurfaceMesh, Kernel>>;
  }
  if (policy == "probabilistic-triangle") {
    return garland_heckbert<
        sms::GarlandHeckbert_probabilistic_triangle_policies<SurfaceMesh, Kernel>>;
  }
  throw std::invalid_argument("CGAL: no policy " + policy);
}

peer::Cost decimate(const std::string& policy, std::size_t target, peer::Mesh& mesh) {
  const Collapse collapse = collapse_of(policy);
  SurfaceMesh surface = build(mesh);
  mesh = {};
  const peer::Cost cost = peer::measure([&] {
    collapse(surface, {surface, target});
    surface.collect_garbage();
  });
  mesh = arrays_of(surface);
  return cost;
}

}  // namespace

int main(int count, char** words) { return peer::run(count, words, CGAL_VERSION_STR, decimate); }
