// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "vcg_ext/parallel/bucket_places.h"
#include "vcg_ext/refine/face_places.h"
#include "vcg_ext/refine/input_surface.h"
#include "vcg_ext/refine/match.h"

namespace curvdecim::detail {

/// Samples of the input, each with the nearest point of the mesh: they tell how far the input is
/// from the mesh.
class InputSamples {
 public:
  /// mesh_faces: of the mesh that they will be matched with.
  InputSamples(const InputSurface& input, double area, int mesh_faces, const Parallel& parallel)
      : input_(input),
        limits_(area, mesh_faces),
        places_(most_cuts),
        part_(area / (per_mesh_face * mesh_faces)) {
    make_room(parallel);
    spread_over_faces(parallel);
    add_vertices(parallel);
    found_.resize(face_.size());
  }

  /// With the mesh as it is now.
  void match(const TriangleTree<WorkingMesh>& tree, int mesh_faces, const MatchLimits& limits,
             const Parallel& parallel) {
    const int count = static_cast<int>(face_.size());
    const auto match_run = [&](int run) {
      int last = SurfacePoint::none;  // neighbours in the list are neighbours in space
      for (int i = run * run_length; i < std::min(count, (run + 1) * run_length); ++i) {
        const int hint = is_matched_ ? found_[i].face : last;
        const Triangle face = input_.triangle(face_[i]);
        found_[i] = Found(
            nearest_on_sheet(tree, at(face, places_[place_[i]]), area_vector(face), hint, limits));
        last = found_[i].face;
      }
    };
    parallel.for_each((count + run_length - 1) / run_length, match_run, Parallel::heavy);
    is_matched_ = true;
    parallel.progress().ask();
    sort_by_face(mesh_faces, parallel);
    parallel.progress().ask();
  }

  /// After flips: the samples of two faces that have taken each other's place, among the two.
  void match_among(const WorkingMesh& mesh, int f, int g) {
    for (int old : {f, g})
      for (int i : of_face(old)) {
        SurfacePoint nearest;
        for (int h : {f, g}) look_at(mesh, h, point(i), any_face, nearest);
        limits_.round(nearest);
        found_[i] = Found(nearest);
      }
  }

  /// To be called where matches are others now.
  void sort_by_face(int mesh_faces, const Parallel& parallel) {
    const int count = static_cast<int>(found_.size());
    place_by_face_.count(count, mesh_faces, parallel,
                         [&](int i, auto count_in) { count_in(found_[i].face); });
    by_face_.resize(count);
    place_by_face_.fill(parallel,
                        [&](int i, auto place_in) { by_face_[place_in(found_[i].face)] = i; });
  }

  /// The samples whose nearest point is on face f of the mesh.
  IndexRange of_face(int f) const {
    const std::vector<int>& begin = place_by_face_.begin();
    return {by_face_.data() + begin[f], by_face_.data() + begin[f + 1]};
  }

  /// face: of the mesh, the one that sample i is matched with.
  Match match(const Triangle& face, int i) const {
    const Vector3 target = point(i);
    return {closest_point(face, target), target, weight(i), distance2(i), face_[i],
            places_[place_[i]]};
  }
  Vector3 point(int i) const { return at(input_.triangle(face_[i]), places_[place_[i]]); }
  double weight(int i) const { return weight_[i]; }
  double distance2(int i) const { return found_[i].distance2; }
  int input_face(int i) const { return face_[i]; }

 private:
  static constexpr double per_mesh_face = 6.0;  // samples inside faces, about, at the least
  static constexpr int most_cuts = 8;  // of an edge: a face of hundreds of others is one of few
  static constexpr double vertex_share = 0.1;  // of a face's weight: they see the largest errors
  static constexpr int run_length = 64;        // samples that follow each other's hints

  void add(int face, int place, double weight) {
    face_.push_back(face), place_.push_back(static_cast<std::uint8_t>(place));
    weight_.push_back(static_cast<float>(weight));
  }

  /// For exactly those that there will be.
  void make_room(const Parallel& parallel) {
    std::size_t count = input_.connectivity.vertex_slots();
    parallel.in_order(input_.face_count(), [&](int f) {
      const double area = input_.area(f);
      const int cuts = area > 0.0 ? cuts_for(area, part_, most_cuts) : 0;
      count += cuts * cuts;
    });
    face_.reserve(count), place_.reserve(count), weight_.reserve(count);
  }

  void spread_over_faces(const Parallel& parallel) {
    parallel.in_order(input_.face_count(), [&](int f) {
      const double area = input_.area(f);
      if (!(area > 0.0)) return;
      const int cuts = cuts_for(area, part_, most_cuts), count = cuts * cuts;
      const double weight = (1.0 - vertex_share) * input_.weight[f] * area / count;
      for (int i = 0; i < count; ++i) add(f, places_.first_of_parts(cuts) + i, weight);
    });
  }

  /// Each as a corner of its first face.
  void add_vertices(const Parallel& parallel) {
    parallel.in_order(input_.connectivity.vertex_slots(), [&](int v) {
      const IndexRange faces = input_.connectivity.faces_of(v);
      double weight = 0.0;
      for (int f : faces) weight += vertex_share * input_.weight[f] * input_.area(f) / 3.0;
      const int f = *faces.begin();
      add(f, FacePlaces::of_corner(input_.connectivity.corner(f, v)), weight);
    });
  }

  const InputSurface& input_;
  const MatchLimits limits_;
  const FacePlaces places_;
  const double part_;                // area that a sample stands for at most
  std::vector<int> face_;            // by sample: of the input
  std::vector<std::uint8_t> place_;  // by sample: on this face
  std::vector<float> weight_;        // by sample: the part of the area that it stands for
  std::vector<Found> found_;         // by sample: on the mesh
  bool is_matched_ = false;
  BucketPlaces place_by_face_;  // a bucket a face of the mesh
  std::vector<int> by_face_;    // samples by the face of their match
};

}  // namespace curvdecim::detail
