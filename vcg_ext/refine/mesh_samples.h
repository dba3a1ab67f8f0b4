// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/refine/face_places.h"
#include "vcg_ext/refine/input_surface.h"
#include "vcg_ext/refine/match.h"

namespace curvdecim::detail {

/// Samples of the mesh, each with the nearest point of the input: they tell how far the mesh is
/// from the input.
class MeshSamples {
 public:
  /// The samples of one face; their number tells their places.
  using OfFace = std::vector<Found>;

  MeshSamples(const InputSurface& input, const TriangleTree<InputSurface>& tree, double area,
              int mesh_faces)
      : input_(input),
        tree_(tree),
        limits_(area, mesh_faces),
        places_(most_cuts),
        part_(area / (per_face * mesh_faces)),
        of_face_(mesh_faces) {}

  /// Matches the mesh as it is now. near: by face, an input face near it, or SurfacePoint::none.
  void match(const WorkingMesh& mesh, const std::vector<int>& near, const MatchLimits& limits,
             const Parallel& parallel) {
    parallel.for_each(
        mesh.connectivity.face_slots(),
        [&](int f) { match_face(mesh.triangle(f), mesh.plane[f], near[f], limits, of_face_[f]); },
        Parallel::heavy);
    of_vertex_.resize(mesh.connectivity.vertex_slots());
    parallel.for_each(mesh.connectivity.vertex_slots(), [&](int v) { match_vertex(mesh, v); });
  }

  void match_face(const WorkingMesh& mesh, int f, int hint) {
    match_face(mesh.triangle(f), mesh.plane[f], hint, limits_, of_face_[f]);
  }

  /// Samples inside a face that could be. samples: known ones are hints, if there are as many.
  void match_face(const Triangle& triangle, const FacePlane& plane, int hint,
                  OfFace& samples) const {
    match_face(triangle, plane, hint, limits_, samples);
  }

  /// Sum of the squared distances by the area that they stand for.
  double error(const OfFace& samples, double area) const {
    double sum = 0.0;
    for (const Found& found : samples) sum += double(input_.weight[found.face]) * found.distance2;
    return sum * (area / static_cast<double>(samples.size()));
  }
  double error(const WorkingMesh& mesh, int f) const {
    return error(of_face_[f], mesh.plane[f].area);
  }

  /// The largest squared distance of the samples of face f, also at its corners.
  double farthest2(const WorkingMesh& mesh, int f) const {
    float farthest2 = 0.0f;
    for (const Found& found : of_face_[f]) farthest2 = std::max(farthest2, found.distance2);
    for (int v : mesh.connectivity.face(f))
      farthest2 = std::max(farthest2, of_vertex_[v].distance2);
    return farthest2;
  }

  /// Inside face f.
  std::vector<Match> matches(const WorkingMesh& mesh, int f) const {
    const OfFace& samples = of_face_[f];
    const Triangle triangle = mesh.triangle(f);
    const int count = static_cast<int>(samples.size()),
              first = places_.first_of_parts(static_cast<int>(std::lround(std::sqrt(count))));
    std::vector<Match> matches;
    for (int i = 0; i < count; ++i) {
      const Barycentric& place = places_[first + i];
      matches.push_back(match_of(samples[i], at(triangle, place), mesh.plane[f].area / count));
      matches.back().at = place;
    }
    return matches;
  }

  /// At vertex v; its place in a face is left out.
  Match match_of_vertex(const WorkingMesh& mesh, int v) const {
    double area = 0.0;
    for (int f : mesh.connectivity.faces_of(v)) area += mesh.plane[f].area;
    return match_of(of_vertex_[v], mesh.position[v], vertex_weight * area / 3.0);
  }

  /// That the match of vertex v is on.
  int input_face(int v) const { return of_vertex_[v].face; }

 private:
  static constexpr double per_face = 10.0;       // samples of a face of mean area
  static constexpr int most_cuts = 4;            // of an edge
  static constexpr double vertex_weight = 0.05;  // against the faces around: enough to hold spikes

  Match match_of(const Found& found, const Vector3& p, double area) const {
    const Triangle face = input_.triangle(found.face);
    const Barycentric place = closest_point(face, p);
    return {{},   at(face, place), input_.weight[found.face] * area, found.distance2, found.face,
            place};
  }

  void match_face(const Triangle& triangle, const FacePlane& plane, int hint,
                  const MatchLimits& limits, OfFace& samples) const {
    const int cuts = cuts_for(plane.area, part_, most_cuts), count = cuts * cuts;
    const bool is_known = static_cast<int>(samples.size()) == count;
    samples.resize(count);
    for (int i = 0; i < count; ++i) {
      if (is_known) hint = samples[i].face;
      const Vector3 p = at(triangle, places_[places_.first_of_parts(cuts) + i]);
      samples[i] = Found(nearest_on_sheet(tree_, p, plane.normal, hint, limits));
      hint = samples[i].face;
    }
  }

  void match_vertex(const WorkingMesh& mesh, int v) {
    of_vertex_[v] = Found(nearest_on_sheet(tree_, mesh.position[v], area_vector_around(mesh, v),
                                           of_vertex_[v].face, limits_));
  }

  const InputSurface& input_;
  const TriangleTree<InputSurface>& tree_;
  const MatchLimits limits_;
  const FacePlaces places_;
  const double part_;  // area that a sample stands for at most
  std::vector<OfFace> of_face_;
  std::vector<Found> of_vertex_;
};

}  // namespace curvdecim::detail
