// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/guard/distance_to_input.h"
#include "vcg_ext/guard/reliance.h"
#include "vcg_ext/mesh/edge_neighborhood.h"

namespace curvdecim::detail {

/// The two-sided distance to the input as it is, not as the sum of what collapses moved. Every face
/// of the input relies on the faces of the mesh that its points are near; where a collapse changes
/// some of these, it looks for others. The new faces are held against the input:
///
///   x far from the input, or the middle of a new face? refused      (mesh/triangle_tree.h)
///   for each new face: its distance to the input                    (distance_to_input.h)
///   for each face of the input that relied on what changes:         (reliance.h)
///     over one new face? it relies on that
///     covered by new faces and others it relied on? on these        (cover.h)
///
/// What cannot be told counts as too far. One question at a time.
class SurfaceBound {
 public:
  /// input: has faces, whose numbers have no gaps. limit: in the unit of the mesh.
  SurfaceBound(const WorkingMesh& input, double limit, const Parallel& parallel)
      : limit_(limit),
        input_(input, parallel),
        tree_(input_, input_.size(), parallel),
        to_input_(input_, tree_, limit),
        open_(input_.size(), 0) {}

  /// There is a mesh to ask about.
  bool has_begun() const { return at_start_.has_value(); }

  /// Whether samples of a surface and of the input are within a share of the limit of the other.
  /// Surface: triangle(f).
  template <class Surface>
  bool holds_in_samples(const Surface& surface, int faces, double share,
                        const Parallel& parallel) const {
    const TriangleTree<Surface> tree(surface, faces, parallel);
    const double reach2 = share * share * limit_ * limit_;
    const auto from_input = [&](int r) {
      return tree.nearest_within(input_.triangle(r)[0], reach2, none).found();
    };
    const auto to_input = [&](int f) {
      return tree_.nearest_within(center_of(surface.triangle(f)), reach2, none).found();
    };
    return all_sampled(input_.size(), parallel, from_input) &&
           all_sampled(faces, parallel, to_input);
  }

  /// Begins with a surface: its faces have these numbers from now on. False if its distance is
  /// above the limit, or cannot be told; then it has not begun. Surface: triangle(f).
  template <class Surface>
  bool begin(const Surface& surface, int faces, const Parallel& parallel) {
    stop();
    reliance_.reset(input_.size(), faces), changed_.assign(faces, 0);
    const double from_input = begin_from_input(surface, faces, parallel);
    if (from_input > limit_) return false;
    const double to_input = begin_to_input(surface, faces, parallel);
    if (to_input > limit_) return false;
    at_start_ = std::max(from_input, to_input);
    return true;
  }

  /// There is no mesh to ask about any more.
  void stop() { at_start_.reset(); }

  /// The distance that it has begun with; 0 if it has not.
  double at_start() const { return at_start_.value_or(0.0); }

  /// The largest distance of what changes, were the edge collapsed to x; infinite where it is above
  /// the limit, or cannot be told.
  double after(const WorkingMesh& mesh, const EdgeNeighborhood& around, const Vector3& x) {
    gather(mesh, around, x);
    if (!is_near(x) || !find_starts()) return HUGE_VAL;
    double largest = 0.0;
    for (std::size_t i = 0; i < new_faces_.size(); ++i) {
      largest = std::max(largest, distance_of_new_face(i));
      if (largest > limit_) return HUGE_VAL;
    }
    for (int r : asked_) {
      if (is_open(r)) largest = std::max(largest, distance_of_input(mesh, r));
      if (largest > limit_) return HUGE_VAL;
    }
    return largest;
  }

  /// The collapse that was asked about last is done.
  void accept() {
    reliance_.drop(changed_faces_, asked_);
    for (const auto& [r, f] : found_) reliance_.add(r, f);
  }

 private:
  static constexpr int none = SurfacePoint::none;
  /// Into which a triangle is cut; more are worth their time before the first collapse only.
  static constexpr int few_parts = 200, many_parts = 5000;
  static constexpr int block = 64;  // faces of the input that find each other's neighbours

  // --- at the beginning -------------------------------------------------------------------------

  template <class Holds>
  static bool all_sampled(int count, const Parallel& parallel, Holds holds) {
    constexpr int samples = 5000;
    const int stride = std::max(1, count / samples), taken = (count + stride - 1) / stride;
    std::vector<std::uint8_t> held(taken);
    parallel.for_each(
        taken, [&](int i) { held[i] = holds(i * stride); }, Parallel::heavy);
    return std::all_of(held.begin(), held.end(), [](std::uint8_t each) { return each == 1; });
  }

  template <class Surface>
  double begin_from_input(const Surface& surface, int faces, const Parallel& parallel) {
    constexpr Grain blocks{1, 1 << 8};
    const TriangleTree<Surface> tree(surface, faces, parallel);
    std::vector<double> distance(input_.size());
    std::vector<std::vector<int>> used(input_.size());
    const auto look = [&](int i) {
      Cover cover;
      int hint = none;  // of this block alone: with several nearest faces it decides
      for (int r = i * block; r < std::min(input_.size(), (i + 1) * block); ++r) {
        cover.add(ConvexPolygon(input_.triangle(r)));
        NearInTree<Surface> near(tree, limit_, hint, used[r]);
        distance[r] = cover.distance(limit_, many_parts, near).value_or(HUGE_VAL);
        if (!used[r].empty()) hint = used[r].front();
        drop_doubles(used[r]);
      }
    };
    parallel.for_each((input_.size() + block - 1) / block, look, blocks);
    for (int r = 0; r < input_.size(); ++r)
      for (int f : used[r]) reliance_.add(r, f);
    return *std::max_element(distance.begin(), distance.end());
  }

  template <class Surface>
  double begin_to_input(const Surface& surface, int faces, const Parallel& parallel) {
    std::vector<double> distance(faces);
    std::vector<std::optional<DistanceToInput>> to_input(parallel.threads());
    const auto look = [&](int begin, int end, int worker) {
      if (!to_input[worker]) to_input[worker].emplace(input_, tree_, limit_);
      for (int f = begin; f < end; ++f) {
        const Triangle t = surface.triangle(f);
        const int start = to_input[worker]->near_middle(t, hint_of(f));
        distance[f] =
            start == none ? HUGE_VAL : to_input[worker]->of(t, start, many_parts, [](int) {});
      }
    };
    parallel.for_ranges(faces, look, Parallel::heavy);
    return *std::max_element(distance.begin(), distance.end());
  }

  // --- what a collapse changes ------------------------------------------------------------------

  /// The faces that it moves or removes, and those of the input that relied on them.
  void gather(const WorkingMesh& mesh, const EdgeNeighborhood& around, const Vector3& x) {
    ++question_;
    changed_faces_.clear(), new_faces_.clear(), found_.clear(), asked_.clear();
    for (int f : around.wings()) change(f);
    for (int f : around.star()) {
      const bool at_a = mesh.connectivity.face_has(f, around.edge().a);
      if (mesh.position[at_a ? around.edge().a : around.edge().b] == x) continue;  // it stays
      change(f);
      new_faces_.push_back({f, triangle_after(mesh, f, around.edge(), x)});
    }
  }

  void change(int f) {
    changed_[f] = question_, changed_faces_.push_back(f);
    for (int r : reliance_.of_face(f))
      if (!is_open(r)) open_[r] = question_, asked_.push_back(r);
  }

  bool is_changed(int f) const { return changed_[f] == question_; }
  bool is_open(int r) const { return open_[r] == question_; }

  // --- from the mesh to the input ---------------------------------------------------------------

  bool is_near(const Vector3& x) const {
    return tree_.nearest_within(x, limit_ * limit_, asked_.empty() ? none : asked_.front()).found();
  }

  /// A face of the input near a face, or none.
  int hint_of(int f) const {
    const std::vector<int>& near = reliance_.of_face(f);
    return near.empty() ? none : near[near.size() / 2];
  }

  /// False if the middle of a new face is too far away.
  bool find_starts() {
    starts_.clear();
    for (const auto& [f, triangle] : new_faces_) {
      starts_.push_back(to_input_.near_middle(triangle, hint_of(f)));
      if (starts_.back() == none) return false;
    }
    return true;
  }

  double distance_of_new_face(std::size_t i) {
    const NumberedFace& face = new_faces_[i];
    return to_input_.of(face.triangle, starts_[i], few_parts, [&](int r) {
      if (is_open(r)) found_.push_back({r, face.number}), open_[r] = 0;
    });
  }

  // --- from the input to the mesh ---------------------------------------------------------------

  double distance_of_input(const WorkingMesh& mesh, int r) {
    const std::size_t changed = new_faces_.size();
    for (int f : reliance_.of_input(r))
      if (!is_changed(f)) new_faces_.push_back({f, mesh.triangle(f)});
    used_.clear();
    cover_.add(ConvexPolygon(input_.triangle(r)));
    const auto distance = cover_.distance(limit_, few_parts, NearInList(new_faces_, limit_, used_));
    new_faces_.resize(changed);
    drop_doubles(used_);
    for (int f : used_) found_.push_back({r, f});
    return distance.value_or(HUGE_VAL);
  }

  static void drop_doubles(std::vector<int>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  }

  double limit_;
  const ReferenceSurface input_;
  const DistanceToInput::Tree tree_;
  DistanceToInput to_input_;
  Cover cover_;
  Reliance reliance_;
  std::optional<double> at_start_;
  // The question:
  int question_ = 0;
  std::vector<int> changed_;  // by face: the last question that it changed in
  std::vector<int> open_;     // by face of the input: the question that it is to be asked in
  std::vector<int> changed_faces_, asked_, starts_, used_;
  std::vector<NumberedFace> new_faces_;
  std::vector<std::pair<int, int>> found_;  // face of the input, face that it may rely on
};

}  // namespace curvdecim::detail
