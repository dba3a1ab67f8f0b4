// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "vcg_ext/error_report.h"
#include "vcg_ext/guard/fold.h"
#include "vcg_ext/measure/distances.h"
#include "vcg_ext/mesh/crossings.h"
#include "vcg_ext/mesh/disjoint_sets.h"

namespace curvdecim::detail {

/// Counts the parts of a mesh, their holes and their handles, by Euler's formula. Of a part that is
/// not a manifold, what the formula gives counts, if it is more than none.
class TopologyCount {
 public:
  explicit TopologyCount(const WorkingMesh& mesh)
      : mesh_(mesh),
        parts_(mesh.connectivity.vertex_slots()),
        loops_(mesh.connectivity.vertex_slots()),
        of_part_(mesh.connectivity.vertex_slots()) {
    for_each_face([&](const Face& face, int) {
      parts_.unite(face[0], face[1]), parts_.unite(face[1], face[2]);
    });
    count_edges_and_faces();
    count_vertices_and_loops();
  }

  int parts() const {
    return sum([](const Part& part) { return part.vertices > 0 ? 1 : 0; });
  }
  int holes() const {
    return sum([](const Part& part) { return part.loops; });
  }
  int handles() const {
    return sum([](const Part& part) {
      const int characteristic = part.vertices - part.edges + part.faces;
      return part.vertices > 0 ? std::max(0, (2 - part.loops - characteristic) / 2) : 0;
    });
  }

 private:
  struct Part {
    int vertices = 0, edges = 0, faces = 0, loops = 0;
  };

  template <class Use>
  void for_each_face(Use use) {
    for (int f = 0; f < mesh_.connectivity.face_slots(); ++f)
      if (mesh_.connectivity.alive(f)) use(mesh_.connectivity.face(f), f);
  }

  void count_edges_and_faces() {
    on_border_.assign(mesh_.connectivity.vertex_slots(), false);
    for_each_face([&](const Face& face, int f) {
      Part& part = of_part_[parts_.root(face[0])];
      ++part.faces;
      for (int k = 0; k < 3; ++k) {
        const int a = face[k], b = face[(k + 1) % 3];
        part.edges += is_first_at_edge(mesh_.connectivity, f, a, b);
        if (!is_on_border(mesh_, a, b)) continue;
        on_border_[a] = on_border_[b] = true;
        loops_.unite(a, b);
      }
    });
  }

  void count_vertices_and_loops() {
    for (int v = 0; v < mesh_.connectivity.vertex_slots(); ++v) {
      if (mesh_.connectivity.faces_of(v).size() == 0) continue;
      Part& part = of_part_[parts_.root(v)];
      ++part.vertices;
      part.loops += on_border_[v] && loops_.root(v) == v;
    }
  }

  template <class Value>
  int sum(Value value) const {
    int all = 0;
    for (const Part& part : of_part_) all += value(part);
    return all;
  }

  const WorkingMesh& mesh_;
  DisjointSets parts_, loops_;  // of vertices
  std::vector<Part> of_part_;   // by the least vertex
  std::vector<bool> on_border_;
};

/// True if the surface turns back at an edge of two faces: they lie on each other.
inline bool is_folded_at(const WorkingMesh& mesh, int f, int a, int b) {
  if (mesh.connectivity.edge_valence(a, b) != 2) return false;
  const int g = mesh.connectivity.face_across(f, a, b);
  FacePlane other = mesh.plane[g];
  if (mesh.connectivity.next_vertex(g, a) == b) other.normal = -other.normal;  // it is turned over
  return lie_on_each_other(mesh.plane[f], other);
}

/// Faces that lie on the other face of an edge of two.
inline int count_folded(const MeasuredSurface& surface, const Parallel& parallel) {
  const WorkingMesh& mesh = surface.mesh();
  return static_cast<int>(sum_of(surface.face_count(), parallel, [&](int i) {
    const int f = surface.number_in_mesh(i);
    const auto [a, b, c] = mesh.connectivity.face(f);
    const bool is_folded =
        is_folded_at(mesh, f, a, b) || is_folded_at(mesh, f, b, c) || is_folded_at(mesh, f, c, a);
    return is_folded ? 1.0 : 0.0;
  }));
}

/// Faces that go through another one, deeper than the rounding of single precision: what only
/// touches does not cross.
inline std::int64_t count_crossing(const MeasuredSurface& surface, const Parallel& parallel) {
  constexpr double depth = 1e-7;  // in the box of diagonal 1
  const auto cross = [](int, const Triangle& of_f, int, const Triangle& of_g) {
    return triangles_cross_deeper(depth, of_f, of_g);
  };
  if (surface.face_count() == 0) return 0;
  const SingleBoxes<MeasuredSurface> boxes(surface, surface.face_count(), parallel);
  return static_cast<std::int64_t>(faces_of(crossing_pairs(boxes, cross, parallel)).size());
}

/// faces, vertices: of the host's mesh. diagonal: of the original's bounding box.
inline SurfaceFigures surface_figures(const MeasuredSurface& surface, std::int64_t faces,
                                      std::int64_t vertices, double diagonal,
                                      const Parallel& parallel) {
  const TopologyCount topology(surface.mesh());
  const double six_volumes = sum_of(surface.face_count(), parallel, [&](int i) {
    return volume_below(surface.mesh(), surface.number_in_mesh(i), Vector3::Zero());
  });
  SurfaceFigures figures;
  figures.faces = faces, figures.vertices = vertices;
  figures.area = surface.area() * diagonal * diagonal;
  figures.volume = six_volumes / 6.0 * diagonal * diagonal * diagonal;
  figures.parts = topology.parts(), figures.holes = topology.holes();
  figures.handles = topology.handles();
  figures.folded = count_folded(surface, parallel);
  figures.intersecting = count_crossing(surface, parallel);
  return figures;
}

}  // namespace curvdecim::detail
