// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/guard/distance_to_input.h"
#include "vcg_ext/guard/distances_to_surface.h"
#include "vcg_ext/guard/reliance.h"
#include "vcg_ext/guard/surface_change.h"

namespace curvdecim::detail {

/// The two-sided distance to the input as it is, not as the sum of what collapses moved. Every face
/// of the input relies on the faces of the mesh that its points are near; where a step changes some
/// of these, it looks for others. The new faces are held against the input:
///
///   the middle of a new face far from the input? refused            (mesh/triangle_tree.h)
///   for each new face: its distance to the input                    (distance_to_input.h)
///   for each face of the input that relied on what changes:         (reliance.h)
///     over one new face? it relies on that
///     covered by new faces and others it relied on? on these        (cover.h)
///
/// One-sided, only the faces of the mesh are asked about. What cannot be told counts as too far.
/// One question at a time.
class SurfaceBound {
 public:
  /// input: has faces, whose numbers have no gaps. limit: in the unit of the mesh.
  SurfaceBound(const WorkingMesh& input, double limit, bool one_sided, const Parallel& parallel)
      : limit_(limit),
        one_sided_(one_sided),
        input_(input, parallel),
        tree_(input_, input_.size(), parallel),
        to_input_(input_, tree_, limit),
        open_(input_.size(), 0) {}
  SurfaceBound(const SurfaceBound&) = delete;  // parts refer to each other

  double limit() const { return limit_; }

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
    return (one_sided_ || all_sampled(input_.size(), parallel, from_input)) &&
           all_sampled(faces, parallel, to_input);
  }

  /// Begins with a surface: its faces have these numbers from now on. False if its distance is
  /// above the limit, or cannot be told; then it has not begun. Surface: triangle(f).
  template <class Surface>
  bool begin(const Surface& surface, int faces, const Parallel& parallel) {
    reset(faces);
    std::vector<std::vector<int>> used(input_.size());
    const std::vector<double> from_input = distances_from_input(surface, faces, used, parallel);
    const double from = largest_of(from_input);
    if (from > limit_) return false;
    for (int r = 0; r < input_.size(); ++r)
      for (int f : without_doubles(used[r])) rely(r, f, from_input[r]);
    const std::vector<double> to_input = distances_to_input(surface, faces, parallel);
    const double to = largest_of(to_input);
    if (to > limit_) return false;
    for (int f = 0; f < faces; ++f) of_face_[f] = std::max(of_face_[f], to_input[f]);
    at_start_ = std::max(from, to);
    return true;
  }

  /// Begins with the input as it is.
  void begin_with_input() {
    reset(input_.size());
    for (int r = 0; r < input_.size(); ++r) reliance_.add(r, r);
    at_start_ = 0.0;
  }

  /// There is no mesh to ask about any more.
  void stop() { at_start_.reset(); }

  /// The distance that it has begun with; 0 if it has not.
  double at_start() const { return at_start_.value_or(0.0); }

  struct Reached {
    double distance;           ///< the largest; infinite where one is above the limit
    std::vector<int> too_far;  ///< faces that are, or that such a face of the input relies on
  };

  /// How far the surface is now that it began with, its vertices moved.
  template <class Surface>
  Reached reached(const Surface& surface, const Parallel& parallel) const {
    const int faces = static_cast<int>(of_face_.size());
    std::vector<std::vector<int>> used(input_.size());
    const std::vector<double> from_input = distances_from_input(surface, faces, used, parallel);
    std::vector<double> distance = distances_to_input(surface, faces, parallel);
    for (int r = 0; r < input_.size(); ++r)
      for (int f : reliance_.of_input(r)) distance[f] = std::max(distance[f], from_input[r]);
    Reached reached{largest_of(distance), {}};
    for (int f = 0; f < faces; ++f)
      if (distance[f] > limit_) reached.too_far.push_back(f);
    return reached;
  }

  /// Whether a point is near the input. hint: a face of the mesh near by.
  bool is_near(const Vector3& x, int hint) const {
    return tree_.nearest_within(x, limit_ * limit_, hint_of(hint)).found();
  }

  /// How far the faces that go, and what relies on them, are apart at most.
  double before(const SurfaceChange& change) const {
    double largest = 0.0;
    for (int f : change.gone) largest = std::max(largest, of_face_[f]);
    return largest;
  }

  /// The largest distance of what changes; infinite where it is above the limit, or cannot be told.
  /// Surface: triangle(f).
  template <class Surface>
  double after(const Surface& surface, const SurfaceChange& change) {
    gather(change);
    if (!find_starts(change)) return HUGE_VAL;
    double largest = 0.0;
    for (std::size_t i = 0; i < change.now.size(); ++i) {
      new_distance_[i] = distance_of(change.now[i], starts_[i]);
      largest = std::max(largest, new_distance_[i]);
      if (largest > limit_) return HUGE_VAL;
    }
    for (int r : asked_) {
      if (one_sided_) break;
      if (is_open(r)) largest = std::max(largest, distance_of_input(surface, r, change));
      if (largest > limit_) return HUGE_VAL;
    }
    return largest;
  }

  /// The change that was asked about last is done.
  void accept(const SurfaceChange& change) {
    reliance_.drop(change.gone, asked_);
    for (std::size_t i = 0; i < change.now.size(); ++i)
      of_face_[change.now[i].number] = new_distance_[i];
    for (const auto& [r, f, distance] : found_) rely(r, f, distance);
  }

  /// The change is done, and known to lead this far at most: nothing is asked.
  template <class Surface>
  void follow(const Surface& surface, const SurfaceChange& change, double distance) {
    gather(change);
    new_distance_.assign(change.now.size(), distance);
    for (int r : asked_)
      if (!(distance_of_input(surface, r, change) <= limit_))
        for (const NumberedFace& face : near_) found_.push_back({r, face.number, distance});
    accept(change);
  }

 private:
  static constexpr int none = SurfacePoint::none;
  /// Into which a triangle is cut; more are worth their time where all are asked about.
  static constexpr int few_parts = 200;

  /// What a face of the input may rely on.
  struct Found {
    int input, face;
    double distance;
  };

  void rely(int r, int f, double distance) {
    reliance_.add(r, f);
    of_face_[f] = std::max(of_face_[f], distance);
  }

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

  void reset(int faces) {
    reliance_.reset(input_.size(), faces);
    changed_.assign(faces, 0), of_face_.assign(faces, 0.0);
    stop();
  }

  static double largest_of(const std::vector<double>& distances) {
    return *std::max_element(distances.begin(), distances.end());
  }

  /// By face of the input, with the faces that its parts are near; 0 if none is asked about.
  template <class Surface>
  std::vector<double> distances_from_input(const Surface& surface, int faces,
                                           std::vector<std::vector<int>>& used,
                                           const Parallel& parallel) const {
    if (one_sided_) return std::vector<double>(input_.size(), 0.0);
    const TriangleTree<Surface> tree(surface, faces, parallel);
    return distances_to_surface(input_, input_.size(), tree, limit_, &used, parallel);
  }

  /// By face of the surface.
  template <class Surface>
  std::vector<double> distances_to_input(const Surface& surface, int faces,
                                         const Parallel& parallel) const {
    std::vector<double> distance(faces);
    std::vector<std::optional<DistanceToInput>> to_input(parallel.threads());
    const auto look = [&](int begin, int end, int worker) {
      if (!to_input[worker]) to_input[worker].emplace(input_, tree_, limit_);
      for (int f = begin; f < end; ++f) {
        const Triangle t = surface.triangle(f);
        const int start = to_input[worker]->near_middle(t, hint_of(f));
        distance[f] = start == none
                          ? HUGE_VAL
                          : to_input[worker]->of(t, start, many_parts, [](int, double) {});
      }
    };
    parallel.for_ranges(faces, look, Parallel::heavy);
    return distance;
  }

  // --- what a step changes ----------------------------------------------------------------------

  /// The faces of the input that relied on what goes.
  void gather(const SurfaceChange& change) {
    ++question_;
    found_.clear(), asked_.clear();
    for (int f : change.gone) {
      changed_[f] = question_;
      for (int r : reliance_.of_face(f))
        if (!is_open(r)) open_[r] = question_, asked_.push_back(r);
    }
  }

  bool is_changed(int f) const { return changed_[f] == question_; }
  bool is_open(int r) const { return open_[r] == question_; }

  // --- from the mesh to the input ---------------------------------------------------------------

  /// A face of the input near a face, or none.
  int hint_of(int f) const {
    const std::vector<int>& near = reliance_.of_face(f);
    return near.empty() ? none : near[near.size() / 2];
  }

  /// False if the middle of a new face is too far away.
  bool find_starts(const SurfaceChange& change) {
    starts_.clear(), new_distance_.resize(change.now.size());
    for (const auto& [f, triangle] : change.now) {
      starts_.push_back(to_input_.near_middle(triangle, hint_of(f)));
      if (starts_.back() == none) return false;
    }
    return true;
  }

  double distance_of(const NumberedFace& face, int start) {
    return to_input_.of(face.triangle, start, few_parts, [&](int r, double height) {
      if (is_open(r)) found_.push_back({r, face.number, height}), open_[r] = 0;
    });
  }

  // --- from the input to the mesh ---------------------------------------------------------------

  /// All that a face of the input may rely on then, in near_.
  template <class Surface>
  void gather_near(const Surface& surface, int r, const SurfaceChange& change) {
    near_ = change.now;
    for (int f : reliance_.of_input(r))
      if (!is_changed(f)) near_.push_back({f, surface.triangle(f)});
  }

  template <class Surface>
  double distance_of_input(const Surface& surface, int r, const SurfaceChange& change) {
    gather_near(surface, r, change);
    used_.clear();
    cover_.add(ConvexPolygon(input_.triangle(r)));
    const auto distance = cover_.distance(limit_, few_parts, NearInList(near_, limit_, used_));
    if (!distance) return HUGE_VAL;
    for (int f : without_doubles(used_)) found_.push_back({r, f, *distance});
    return *distance;
  }

  static std::vector<int>& without_doubles(std::vector<int>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
  }

  const double limit_;
  const bool one_sided_;
  const ReferenceSurface input_;
  const DistanceToInput::Tree tree_;
  DistanceToInput to_input_;
  Cover cover_;
  Reliance reliance_;
  std::vector<double> of_face_;  // how far it, and what relies on it, is off at most
  std::optional<double> at_start_;
  // The question:
  int question_ = 0;
  std::vector<int> changed_;  // by face: the last question that it changed in
  std::vector<int> open_;     // by face of the input: the question that it is to be asked in
  std::vector<int> asked_, starts_, used_;
  std::vector<NumberedFace> near_;
  std::vector<double> new_distance_;  // of the faces that come
  std::vector<Found> found_;
};

}  // namespace curvdecim::detail
