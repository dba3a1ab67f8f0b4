// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel.h"
#include "vcg_ext/refine/input_surface.h"
#include "vcg_ext/refine/match.h"

namespace curvdecim {

/// Samples of the mesh, each with the nearest point of the input: they tell how far the mesh is
/// from the input.
class MeshSamples {
 public:
  MeshSamples(const InputSurface& input, const TriangleTree<InputSurface>& tree, double area,
              int mesh_faces)
      : input_(input),
        tree_(tree),
        limits_(area, mesh_faces),
        part_(area / (per_face * mesh_faces)),
        of_face_(mesh_faces) {}

  /// Of the mesh as it is now. near: by face, a face of the input near it, or SurfacePoint::none.
  void match(const WorkingMesh& mesh, const std::vector<int>& near, const Parallel& parallel) {
    parallel.for_each(
        mesh.connectivity.face_slots(),
        [&](int f) { match_face(mesh.triangle(f), near[f], of_face_[f]); }, Parallel::heavy);
    of_vertex_.resize(mesh.connectivity.vertex_slots());
    parallel.for_each(mesh.connectivity.vertex_slots(), [&](int v) { match_vertex(mesh, v); });
  }

  void match_face(const WorkingMesh& mesh, int f, int hint) {
    match_face(mesh.triangle(f), hint, of_face_[f]);
  }

  /// Inside face f.
  const std::vector<Match>& of_face(int f) const { return of_face_[f]; }

  /// At vertex v; its place in a face is left out.
  const Match& of_vertex(int v) const { return of_vertex_[v]; }

  /// Samples of a face that could be. matches: known ones are hints, if there are as many.
  void match_face(const Triangle& triangle, int hint, std::vector<Match>& matches) const {
    const FacePlane plane = face_plane(triangle);
    std::vector<Barycentric> points;
    spread_over_triangle(cuts_for(plane.area, part_, most_cuts), points);
    const bool is_known = matches.size() == points.size();
    matches.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (is_known) hint = matches[i].input_face;
      const SurfacePoint found =
          nearest_on_sheet(tree_, at(triangle, points[i]), plane.normal, hint, limits_);
      matches[i] = match_at(found, plane.area / static_cast<double>(points.size()));
      matches[i].at = points[i];
      hint = found.face;
    }
  }

 private:
  static constexpr double per_face = 10.0;       // samples of a face of mean area
  static constexpr int most_cuts = 4;            // of an edge
  static constexpr double vertex_weight = 0.05;  // against the faces around: enough to hold spikes

  Match match_at(const SurfacePoint& found, double area) const {
    return {{},
            at(input_.triangle(found.face), found.weight),
            input_.weight[found.face] * area,
            found.distance2,
            found.face};
  }

  void match_vertex(const WorkingMesh& mesh, int v) {
    double area = 0.0;
    for (int f : mesh.connectivity.faces_of(v)) area += mesh.plane[f].area;
    const SurfacePoint found = nearest_on_sheet(
        tree_, mesh.position[v], area_vector_around(mesh, v), of_vertex_[v].input_face, limits_);
    of_vertex_[v] = match_at(found, vertex_weight * area / 3.0);
  }

  const InputSurface& input_;
  const TriangleTree<InputSurface>& tree_;
  const MatchLimits limits_;
  const double part_;  // area that a sample stands for at most
  std::vector<std::vector<Match>> of_face_;
  std::vector<Match> of_vertex_;
};

}  // namespace curvdecim
