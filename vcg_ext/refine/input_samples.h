// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/parallel.h"
#include "vcg_ext/refine/input_surface.h"
#include "vcg_ext/refine/match.h"

namespace curvdecim {

/// Samples of the input, each with the nearest point of the mesh: they tell how far the input is
/// from the mesh.
class InputSamples {
 public:
  /// mesh_faces: of the mesh that they will be matched with.
  InputSamples(const InputSurface& input, double area, int mesh_faces)
      : input_(input), limits_(area, mesh_faces) {
    spread_over_faces(area / (per_mesh_face * mesh_faces));
    add_vertices();
    matches_.resize(samples_.size());
  }

  /// With the mesh as it is now.
  void match(const TriangleTree<WorkingMesh>& tree, int mesh_faces, const Parallel& parallel) {
    const int count = static_cast<int>(samples_.size());
    const auto match_run = [&](int run) {
      int last = SurfacePoint::none;  // neighbours in the list are neighbours in space
      for (int i = run * run_length; i < std::min(count, (run + 1) * run_length); ++i) {
        const int hint = is_matched_ ? matches_[i].face : last;
        const Vector3& normal = input_.plane[samples_[i].face].normal;
        matches_[i] = nearest_on_sheet(tree, samples_[i].point, normal, hint, limits_);
        last = matches_[i].face;
      }
    };
    parallel.for_each((count + run_length - 1) / run_length, match_run, Parallel::heavy);
    is_matched_ = true;
    sort_by_face(mesh_faces);
  }

  /// After flips: the samples of two faces that have taken each other's place, among the two.
  void match_among(const WorkingMesh& mesh, int f, int g) {
    for (int old : {f, g})
      for (int i : of_face(old)) {
        matches_[i] = {};
        for (int h : {f, g}) {
          const SurfacePoint found = closest_on_face(mesh, h, samples_[i].point);
          if (found.distance2 < matches_[i].distance2) matches_[i] = found;
        }
        limits_.round(matches_[i]);
      }
  }

  void sort_by_face() { sort_by_face(static_cast<int>(begin_.size()) - 1); }

  /// The samples whose nearest point is on face f of the mesh.
  IndexRange of_face(int f) const {
    return {by_face_.data() + begin_[f], by_face_.data() + begin_[f + 1]};
  }

  Match match(int i) const {
    return {matches_[i].weight, samples_[i].point, samples_[i].weight, matches_[i].distance2,
            samples_[i].face};
  }
  const Vector3& point(int i) const { return samples_[i].point; }
  double weight(int i) const { return samples_[i].weight; }
  double distance2(int i) const { return matches_[i].distance2; }
  int input_face(int i) const { return samples_[i].face; }

 private:
  static constexpr double per_mesh_face = 6.0;  // samples inside faces, about, at the least
  static constexpr int most_cuts = 8;  // of an edge: a face of hundreds of others is one of few
  static constexpr double vertex_share = 0.1;  // of a face's weight: they see the largest errors
  static constexpr int run_length = 64;        // samples that follow each other's hints

  struct Sample {
    Vector3 point;
    double weight;
    int face;  // of the input
  };

  void spread_over_faces(double part) {
    std::vector<Barycentric> points;
    for (int f = 0; f < input_.face_count(); ++f) {
      const double area = input_.plane[f].area;
      if (!(area > 0.0)) continue;
      spread_over_triangle(cuts_for(area, part, most_cuts), points);
      const double weight =
          (1.0 - vertex_share) * input_.weight[f] * area / static_cast<double>(points.size());
      for (const Barycentric& w : points)
        samples_.push_back({at(input_.triangle(f), w), weight, f});
    }
  }

  void add_vertices() {
    const std::size_t first = samples_.size();
    for (const Vector3& p : input_.position) samples_.push_back({p, 0.0, SurfacePoint::none});
    for (int f = 0; f < input_.face_count(); ++f)
      for (int v : input_.connectivity.face(f)) {
        Sample& sample = samples_[first + v];
        sample.weight += vertex_share * input_.weight[f] * input_.plane[f].area / 3.0;
        if (sample.face == SurfacePoint::none) sample.face = f;
      }
  }

  static SurfacePoint closest_on_face(const WorkingMesh& mesh, int f, const Vector3& p) {
    const Triangle triangle = mesh.triangle(f);
    const Barycentric weight = closest_point(triangle, p);
    return {f, weight, (at(triangle, weight) - p).squaredNorm()};
  }

  void sort_by_face(int mesh_faces) {
    begin_.assign(mesh_faces + 1, 0);
    for (const SurfacePoint& match : matches_) ++begin_[match.face + 1];
    for (int f = 0; f < mesh_faces; ++f) begin_[f + 1] += begin_[f];
    by_face_.resize(matches_.size());
    std::vector<int> end(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < matches_.size(); ++i)
      by_face_[end[matches_[i].face]++] = static_cast<int>(i);
  }

  const InputSurface& input_;
  const MatchLimits limits_;
  std::vector<Sample> samples_;
  std::vector<SurfacePoint> matches_;  // by sample: on the mesh
  bool is_matched_ = false;
  std::vector<int> begin_, by_face_;  // samples by the face of their match
};

}  // namespace curvdecim
