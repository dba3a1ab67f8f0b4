// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/guard/limits.h"
#include "vcg_ext/mesh/triangle_tree.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/refine/input_surface.h"

namespace curvdecim::detail {

/// How far from the input the samples around a vertex are.
struct Farthest {
  int near = SurfacePoint::none;  // a face of the input near the vertex
  double distance2 = std::numeric_limits<double>::infinity();
};

/// How far vertices may step: not past their neighbours, and no face turns far, folds back over the
/// input, or becomes a needle.
class MoveGuard {
 public:
  MoveGuard(const WorkingMesh& mesh, const InputSurface& input,
            const TriangleTree<InputSurface>& tree, const FaceLimits& limits)
      : mesh_(mesh), input_(input), tree_(tree), least_facing_(least_cosine(limits, 1.0)) {}

  /// The positions after the steps, as far as they may be done. near: by face, a face of the input
  /// near it; farthest: by vertex.
  std::vector<Vector3> moved(std::vector<Vector3> steps, const std::vector<int>& near,
                             const std::vector<Farthest>& farthest,
                             const Parallel& parallel) const {
    bound_by_edges(steps, parallel);
    shorten(steps, parallel);
    std::vector<Vector3> now(steps.size());
    parallel.for_each(static_cast<int>(now.size()),
                      [&](int v) { now[v] = mesh_.position[v] + steps[v]; });
    take_back_strays(now, farthest, parallel);
    take_back_folds(now, near, parallel);
    return now;
  }

  /// May this face be, where there was one that faced the input by `before`?
  bool faces_input(const Triangle& triangle, double before, int hint) const {
    const double now = facing(triangle, hint);
    return now >= least_facing_ || now > before;
  }

  /// Cosine between the face's normal and the input's, at the point of the input nearest to the
  /// face's centre.
  double facing(const Triangle& triangle, int hint) const {
    const Vector3 normal = face_plane(triangle).normal;
    const Vector3 center = center_of(triangle);
    return normal.dot(face_plane(input_.triangle(tree_.nearest(center, hint).face)).normal);
  }

 private:
  static constexpr double part_of_edge = 0.5;  // two that step towards each other do not pass
  static constexpr double least_turn = 0.5;    // cosine: 60 degrees in one step
  static constexpr double least_shape_quality = 0.02;
  static constexpr double much_further2 = 4.0;  // squared: twice as far
  static constexpr int halvings = 4;            // before a step is dropped

  int face_count() const { return mesh_.connectivity.face_slots(); }
  int vertex_count() const { return mesh_.connectivity.vertex_slots(); }

  /// Where the samples hardly hold a vertex in some direction, their best step may be of any
  /// length.
  void bound_by_edges(std::vector<Vector3>& steps, const Parallel& parallel) const {
    parallel.for_each(vertex_count(), [&](int v) {
      const double most2 = part_of_edge * part_of_edge * shortest_edge2(v);
      const double length2 = steps[v].squaredNorm();
      if (length2 > most2) steps[v] *= std::sqrt(most2 / length2);
    });
  }

  /// Squared length.
  double shortest_edge2(int v) const {
    double shortest2 = std::numeric_limits<double>::infinity();
    for (int f : mesh_.connectivity.faces_of(v))
      for (int w : mesh_.connectivity.face(f))
        if (w != v)
          shortest2 = std::min(shortest2, (mesh_.position[w] - mesh_.position[v]).squaredNorm());
    return shortest2;
  }

  /// Halves the steps at faces that they would spoil, until none is.
  void shorten(std::vector<Vector3>& steps, const Parallel& parallel) const {
    std::vector<std::uint8_t> spoilt(face_count());
    for (int round = 0;; ++round) {
      parallel.for_each(face_count(), [&](int f) { spoilt[f] = is_spoilt(f, steps); });
      if (std::none_of(spoilt.begin(), spoilt.end(), [](std::uint8_t s) { return s != 0; })) return;
      const double factor = round < halvings ? 0.5 : 0.0;
      parallel.for_each(vertex_count(), [&](int v) {
        if (is_any_set(mesh_.connectivity.faces_of(v), spoilt)) steps[v] *= factor;
      });
    }
  }

  static bool is_any_set(IndexRange faces, const std::vector<std::uint8_t>& flag) {
    return std::any_of(faces.begin(), faces.end(), [&](int f) { return flag[f] != 0; });
  }

  bool is_spoilt(int f, const std::vector<Vector3>& steps) const {
    const auto [a, b, c] = mesh_.connectivity.face(f);
    if (steps[a].isZero(0.0) && steps[b].isZero(0.0) && steps[c].isZero(0.0)) return false;
    const Triangle before = mesh_.triangle(f);
    const Triangle after{before[0] + steps[a], before[1] + steps[b], before[2] + steps[c]};
    const FacePlane plane = face_plane(after);
    return turns_too_far(mesh_.plane[f].normal, plane, least_turn) ||
           spoils_shape(after, plane.area, least_shape_quality,
                        [&] { return shape_quality(before, mesh_.plane[f].area); });
  }

  /// Vertices that end much further from the input than the samples around them were go back to
  /// where they were.
  void take_back_strays(std::vector<Vector3>& now, const std::vector<Farthest>& farthest,
                        const Parallel& parallel) const {
    const auto check = [&](int v) {
      if (now[v] == mesh_.position[v]) return;
      const auto [near, distance2] = farthest[v];
      const double most2 = much_further2 * distance2;
      const bool is_near = (near != SurfacePoint::none &&
                            squared_distance(input_.triangle(near), now[v]) <= most2) ||
                           tree_.nearest(now[v], near).distance2 <= most2;
      if (!is_near) now[v] = mesh_.position[v];
    };
    parallel.for_each(vertex_count(), check, Parallel::heavy);
  }

  /// Corners of a face that faces away go back to where they were, until no face does.
  void take_back_folds(std::vector<Vector3>& now, const std::vector<int>& near,
                       const Parallel& parallel) const {
    std::vector<std::uint8_t> folded(face_count()), changed(face_count(), 1);
    for (bool any = true; any;) {
      parallel.for_each(
          face_count(),
          [&](int f) {
            folded[f] = changed[f] != 0 && has_moved(f, now) && is_folded(f, now, near[f]);
          },
          Parallel::heavy);
      std::fill(changed.begin(), changed.end(), 0);
      any = false;
      for (int f = 0; f < face_count(); ++f)
        if (folded[f] != 0) any = true, put_back(f, now, changed);
    }
  }

  bool has_moved(int f, const std::vector<Vector3>& now) const {
    for (int v : mesh_.connectivity.face(f))
      if (now[v] != mesh_.position[v]) return true;
    return false;
  }

  bool is_folded(int f, const std::vector<Vector3>& now, int hint) const {
    const double after = facing(triangle_of(now, mesh_.connectivity.face(f)), hint);
    return after < least_facing_ && after < facing(mesh_.triangle(f), hint);
  }

  void put_back(int f, std::vector<Vector3>& now, std::vector<std::uint8_t>& changed) const {
    for (int v : mesh_.connectivity.face(f)) {
      now[v] = mesh_.position[v];
      for (int g : mesh_.connectivity.faces_of(v)) changed[g] = 1;
    }
  }

  const WorkingMesh& mesh_;
  const InputSurface& input_;
  const TriangleTree<InputSurface>& tree_;
  const double least_facing_;
};

}  // namespace curvdecim::detail
