// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/attributes/carried.h"
#include "vcg_ext/guard/crossing_guard.h"
#include "vcg_ext/guard/surface_bound.h"
#include "vcg_ext/mesh/tally.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/refine/crossing_moves.h"
#include "vcg_ext/refine/curve_samples.h"
#include "vcg_ext/refine/edge_flips.h"
#include "vcg_ext/refine/input_samples.h"
#include "vcg_ext/refine/input_surface.h"
#include "vcg_ext/refine/mesh_samples.h"
#include "vcg_ext/refine/move_guard.h"
#include "vcg_ext/refine/texture_drift.h"
#include "vcg_ext/refine/texture_fit.h"
#include "vcg_ext/refine/vertex_fit.h"
#include "vcg_ext/refine/wedge_moves.h"

namespace curvdecim::detail {

/// Moves vertices and flips edges of a decimated mesh, so that it and the input come closer to each
/// other; the numbers of vertices and faces stay @cite hoppe1993:
///
///   a sweep:
///     match samples of the input with their nearest points of the mesh,
///       and samples of the mesh with theirs of the input               (samples, triangle_tree.h)
///     flip the edges that lower the error                                  (edge_flips.h)
///     steps of all vertices that fit the samples best                      (vertex_fit.h)
///     shorten the steps that would spoil or fold a face, or lead astray    (move_guard.h)
///     take back those that would make faces cross, where none may          (crossing_moves.h)
///   max_error? no edge is flipped, and what has come too far goes back  (guard/surface_bound.h)
///
/// Locked vertices and those of non-manifold curves stay; those of borders and of seams move with
/// these.
class Refinement {
 public:
  /// mesh: without gaps in its numbers; input: what the mesh was before the collapses. bound: has
  /// begun with the mesh; nullptr without one.
  Refinement(WorkingMesh& mesh, const InputSurface& input, const CollapsePlan& plan,
             const SurfaceBound* bound, const Parallel& parallel)
      : mesh_(mesh),
        input_(input),
        bound_(bound),
        parallel_(parallel),
        area_(total_area(input)),
        limits_(area_, face_count()),
        before_(mesh.position),
        input_tree_(input, input.face_count(), parallel),
        mesh_tree_(mesh, face_count(), parallel),
        of_input_(input, area_, face_count(), parallel),
        of_mesh_(input, input_tree_, area_, face_count()),
        of_border_({input.position, input.border}, {mesh.position, border_edges(mesh)},
                   border_share * plan.boundary_weight, limits_, parallel),
        of_seams_({input.position, input.seams}, {mesh.position, seam_edges(mesh)}, seam_share,
                  limits_, parallel),
        guard_(mesh, input, input_tree_, plan.limits.faces),
        drift_(mesh, input, plan.limits.attribute_weight),
        near_(face_count(), SurfacePoint::none) {
    if (plan.limits.prevents_crossings) crossing_guard_.emplace(mesh, parallel);
  }

  /// Throws CancelRequest.
  void run(int sweeps) {
    if (!(area_ > 0.0)) return;
    const std::vector<std::uint8_t> fixed = fixed_vertices();
    const bool has_texture = mesh_.texture_scale2 > 0.0;
    const double swept = has_texture ? texture_starts : 1.0;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      const double one = (swept - ready) / sweeps, start = ready + one * sweep;
      const MatchLimits limits = sweep == 0 && has_curves() ? limits_.without_walks() : limits_;
      parallel_.progress().along(start, start + one, [&] { sweep_once(limits, fixed); });
    }
    if (bound_) distance_ = return_within(*bound_);
    if (has_texture) parallel_.progress().along(swept, 1.0, [&] { fit_texture(); });
  }

  /// Where on the input what moved takes its attributes from: vertices, by the numbers that they
  /// had at the start, or wedges inside charts, from the same chart.
  std::vector<BlendStep> attributes() const {
    std::vector<BlendStep> of_vertex(mesh_.position.size());
    parallel_.for_each(
        static_cast<int>(of_vertex.size()),
        [&](int v) {
          if (has_moved(v)) of_vertex[v] = step_from_input(v);
        },
        Parallel::heavy);
    const auto is_none = [](const BlendStep& step) { return step.keep == BlendStep::none; };
    of_vertex.erase(std::remove_if(of_vertex.begin(), of_vertex.end(), is_none), of_vertex.end());
    return of_vertex;
  }

  /// With a bound: the distance to the input that is left.
  double distance() const { return distance_; }

  /// How wedges have followed their vertices, in an order in which it can be replayed.
  const std::vector<BlendStep>& wedge_steps() const { return wedge_steps_; }

 private:
  // Parts of the time: when the first sweep starts, and the fit of a texture.
  static constexpr double ready = 0.05, texture_starts = 0.9;

  /// A border's samples against those of the surface: the border must not pull the surface along.
  static constexpr double border_share = 0.3;
  static constexpr double seam_share = 0.3;

  int face_count() const { return mesh_.connectivity.face_slots(); }

  /// Its three parts take about as long as each other.
  void sweep_once(const MatchLimits& limits, const std::vector<std::uint8_t>& fixed) {
    constexpr double third = 1.0 / 3.0;
    ProgressMeter& progress = parallel_.progress();
    progress.along(0.0, third, [&] { match_surface(limits), match_curves(); });
    progress.along(third, 2.0 * third, [&] {
      if (!bound_)
        EdgeFlips(mesh_, of_input_, of_mesh_, guard_, drift_, crossing_guard())
            .run(near_, parallel_);
    });
    progress.along(2.0 * third, 1.0, [&] { fit(fixed); });
  }

  std::vector<std::uint8_t> fixed_vertices() const {
    std::vector<std::uint8_t> fixed(mesh_.position.size());
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      fixed[i] =
          static_cast<std::uint8_t>(mesh_.locked[i] != 0 || mesh_.kind[i] >= VertexKind::Curve);
    }
    return fixed;
  }

  /// Sheets that meet in a curve may face one way and lie so near each other that a walk on the
  /// wrong one ends near by.
  bool has_curves() const {
    return std::any_of(mesh_.kind.begin(), mesh_.kind.end(),
                       [](VertexKind kind) { return kind >= VertexKind::Curve; });
  }

  void match_surface(const MatchLimits& limits) {
    of_input_.match(mesh_tree_, face_count(), limits, parallel_);
    parallel_.for_each(face_count(), [&](int f) {
      const IndexRange samples = of_input_.of_face(f);
      if (samples.size() > 0) near_[f] = of_input_.input_face(*(samples.end() - 1));
    });
    of_mesh_.match(mesh_, near_, limits, parallel_);
  }

  void match_curves() { of_border_.match(parallel_), of_seams_.match(parallel_); }

  void fit(const std::vector<std::uint8_t>& fixed) {
    std::vector<Vector3> steps =
        VertexFit(mesh_, parallel_).steps(of_input_, of_mesh_, {&of_border_, &of_seams_}, fixed);
    std::vector<Vector3> now = guard_.moved(std::move(steps), near_, farthest(), parallel_);
    if (crossing_guard()) take_back_crossings(mesh_, now, parallel_);
    move_to(std::move(now));
  }

  void move_to(std::vector<Vector3> now) {
    if (mesh_.wedges.exist()) WedgeMoves(mesh_, parallel_).follow(now, wedge_steps_);
    mesh_.position.swap(now);
    mesh_.update_planes(parallel_);
    mesh_tree_.refit(parallel_);
    if (crossing_guard()) crossing_guard()->rebuild();
  }

  /// nullptr: faces may cross.
  CrossingGuard* crossing_guard() { return crossing_guard_ ? &*crossing_guard_ : nullptr; }

  /// The corners of faces that are too far go back to where they were, which may bring others too
  /// far, or make faces cross; in the end all do. Returns the distance, 0 if all have.
  double return_within(const SurfaceBound& bound) {
    constexpr int most_rounds = 10;  // a few are enough nearly always
    for (int round = 0;; ++round) {
      if (mesh_.position == before_) return 0.0;
      const auto [distance, too_far] = bound.reached(mesh_, parallel_);
      if (too_far.empty()) return distance;
      std::vector<Vector3> now = mesh_.position;
      for (int f : too_far)
        for (int v : mesh_.connectivity.face(f)) now[v] = before_[v];
      if (round == most_rounds || now == mesh_.position) now = before_;
      if (crossing_guard()) {
        move_to(before_);
        take_back_crossings(mesh_, now, parallel_);
      }
      move_to(std::move(now));
    }
  }

  /// Where vertices moved, inside charts.
  void fit_texture() {
    match_surface(limits_);
    TextureFit(mesh_, input_, moved_vertices(), parallel_).run(of_input_, of_mesh_);
  }

  std::vector<std::uint8_t> moved_vertices() const {
    std::vector<std::uint8_t> moved(mesh_.position.size());
    for (std::size_t v = 0; v < moved.size(); ++v) moved[v] = has_moved(static_cast<int>(v));
    return moved;
  }

  bool has_moved(int v) const { return mesh_.position[v] != before_[v]; }

  /// By vertex.
  std::vector<Farthest> farthest() const {
    std::vector<double> of_face(face_count());
    parallel_.for_each(face_count(), [&](int f) {
      of_face[f] = of_mesh_.farthest2(mesh_, f);
      for (int i : of_input_.of_face(f)) of_face[f] = std::max(of_face[f], of_input_.distance2(i));
    });
    std::vector<Farthest> farthest(mesh_.position.size());
    parallel_.for_each(static_cast<int>(farthest.size()), [&](int v) {
      farthest[v] = {of_mesh_.input_face(v), 0.0};
      for (int f : mesh_.connectivity.faces_of(v))
        farthest[v].distance2 = std::max(farthest[v].distance2, of_face[f]);
    });
    return farthest;
  }

  /// From the nearest point of the input; none: at the outline of a chart, or beyond it.
  BlendStep step_from_input(int v) const {
    const SurfacePoint from =
        nearest_on_sheet(input_tree_, mesh_.position[v], area_vector_around(mesh_, v),
                         of_mesh_.input_face(v), limits_);
    if (!mesh_.wedges.exist())
      return BlendStep::at(mesh_.vertex_origin[v], input_.connectivity.face(from.face),
                           from.weight);
    const int f = *mesh_.connectivity.faces_of(v).begin();
    if (!is_inside_chart(mesh_, v) || !input_.charts.has(mesh_, f, from.face)) return {};
    return BlendStep::at(only_wedge(mesh_, v), input_.charts.wedges[from.face], from.weight);
  }

  WorkingMesh& mesh_;
  const InputSurface& input_;
  const SurfaceBound* const bound_;
  const Parallel& parallel_;
  const double area_;  // of the input
  const MatchLimits limits_;
  const std::vector<Vector3> before_;  // by vertex
  TriangleTree<InputSurface> input_tree_;
  TriangleTree<WorkingMesh> mesh_tree_;
  InputSamples of_input_;
  MeshSamples of_mesh_;
  CurveSamples of_border_, of_seams_;
  MoveGuard guard_;
  TextureDrift drift_;
  std::optional<CrossingGuard> crossing_guard_;  // where faces may not cross
  std::vector<BlendStep> wedge_steps_;
  double distance_ = 0.0;
  std::vector<int> near_;  // by face of the mesh: a face of the input near it
};

/// What has to be kept of the mesh before the collapses for refine() after them; nullopt: the plan
/// has no refinement.
inline std::optional<InputCopy> keep_input(const WorkingMesh& mesh, const CollapsePlan& plan,
                                           const Parallel& parallel) {
  if (plan.refine_sweeps == 0) return std::nullopt;
  return copy_input(mesh, plan.metric, parallel);
}

/// Gives what is left new numbers without gaps, so that what is gone needs no memory.
inline void pack(WorkingMesh& mesh) {
  const Renumbering without_gaps(mesh.connectivity);
  mesh.renumber(without_gaps);
  mesh = WorkingMesh(mesh);  // a copy has no room to spare
}

/// Moves vertices and flips edges of the decimated mesh, as often as the plan says, to bring it
/// closer to the input. bound: nullptr without one. Throws CancelRequest.
inline void refine(WorkingMesh& decimated, std::optional<InputCopy> input, const CollapsePlan& plan,
                   SurfaceBound* bound, Carried& carried, const Parallel& parallel, Tally& tally) {
  if (!input) return;
  plan.times.begin_refining(parallel.progress());
  pack(decimated);
  if (decimated.connectivity.face_count() == 0) return;  // may be without the link condition
  if (bound && !bound->begin(decimated, decimated.connectivity.face_slots(), parallel)) return;
  const InputSurface surface(std::move(*input));
  parallel.progress().ask();
  Refinement refinement(decimated, surface, plan, bound, parallel);
  refinement.run(plan.refine_sweeps);
  tally.note_error(refinement.distance());
  carried.resampled = refinement.attributes();
  carried.blended.append(refinement.wedge_steps());
  assert((decimated.connectivity.validate(), true));
}

}  // namespace curvdecim::detail
