// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "vcg_ext/guard/collapse_bound.h"
#include "vcg_ext/guard/collapse_rule.h"
#include "vcg_ext/guard/crossing_guard.h"
#include "vcg_ext/guard/face_guard.h"
#include "vcg_ext/guard/fold.h"
#include "vcg_ext/guard/obstacle.h"
#include "vcg_ext/guard/spike.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/report.h"

namespace curvdecim::detail {

/// Whether a collapse may be done.
struct GuardAnswer {
  std::optional<Rejection> refusal;  ///< nullopt: it may
  double error_bound = 0.0;          ///< of the faces around, were it done; 0 without a bound;
                                     ///< above it: to be settled, if it is to be done
  double price = 0.0;                ///< beside the cost: area times squared distance, in the box
  Obstacle obstacle{};               ///< to be cleared instead; then the edge is asked about again
};

/// All that may refuse a collapse once its kinds allow it, or make it costlier: the cheap guards
/// first. The one against crossings is asked by itself: it looks at faces elsewhere, which may
/// change while others are asked about.
class CollapseGuards {
 public:
  CollapseGuards(const WorkingMesh& mesh, const CollapseLimits& limits)
      : mesh_(mesh),
        rule_(mesh, limits),
        link_condition_(limits.keeps_topology || limits.max_error > 0.0),
        keeps_normal_(limits.faces.keeps_normal),
        face_guard_(mesh, limits.faces),
        bound_(mesh, limits.max_error) {
    if (limits.topology_gives_way) obstacle_price_.emplace(mesh);
  }

  /// May the edge collapse to x? If so, `after` has the planes that the star would have.
  GuardAnswer ask(const EdgeNeighborhood& around, const Vector3& x,
                  std::vector<FacePlane>& after) const {
    GuardAnswer answer;
    if (link_condition_) answer.obstacle = obstacle(around);
    if (answer.obstacle.kind == Obstacle::Kind::Fixed) return {Rejection::LinkCondition};
    if (answer.obstacle.exists()) answer.price = obstacle_price_->of(around, answer.obstacle);
    after.clear();
    for (int f : around.star()) {
      const Triangle moved = triangle_after(mesh_, f, around.edge(), x);
      after.push_back(face_plane(moved));
      const std::optional<double> price = face_guard_.price(f, moved, after.back());
      if (!price) return {Rejection::TriangleShape};
      answer.price += *price;
    }
    answer.price += spike_price(mesh_, around, x, after);
    if (keeps_normal_ && !answer.obstacle.exists() && folds(mesh_, around, after))
      return {Rejection::NormalFlip};
    if (!bound_.active()) return answer;
    const std::optional<double> distance = bound_.after(around, x);
    if (!distance) return {Rejection::ErrorBound};
    answer.error_bound = *distance;
    return answer;
  }

  /// Settles an answer about the collapse that was asked about last.
  void settle(GuardAnswer& answer) const {
    if (!bound_.active()) return;
    const std::optional<double> distance = bound_.settle(answer.error_bound);
    if (!distance)
      answer = {Rejection::ErrorBound};
    else
      answer.error_bound = *distance;
  }

  /// To be told of every collapse that is done, with the bound of the answer.
  void accept(const EdgeNeighborhood& around, double error_bound) {
    bound_.accept(around, error_bound);
  }

  /// How the error is bounded: guard/collapse_bound.h.
  CollapseBound& bound() { return bound_; }

  /// From now on faces may not cross others.
  void prevent_crossings(const Parallel& parallel) { crossing_guard_.emplace(mesh_, parallel); }

  /// False if faces would cross that may not, were the edge collapsed as it was asked about; star:
  /// what changes then.
  bool keeps_apart(const EdgeNeighborhood& around, const Vector3& x,
                   const std::vector<FacePlane>& after, CrossingGuard::Star& star) const {
    if (!crossing_guard_) return true;
    const auto [a, b] = around.edge();
    const bool is_disk = link_condition_ && around.wings().size() == 2 &&
                         mesh_.kind[a] == VertexKind::Interior &&
                         mesh_.kind[b] == VertexKind::Interior;
    return crossing_guard_->allows(around, x, after, is_disk, star);
  }

  /// nullptr: faces may cross.
  CrossingGuard* crossing_guard() { return crossing_guard_ ? &*crossing_guard_ : nullptr; }
  const CrossingGuard* crossing_guard() const {
    return crossing_guard_ ? &*crossing_guard_ : nullptr;
  }

  /// What it costs that the topology gives way; nullptr: it does not.
  const ObstaclePrice* obstacle_price() const {
    return obstacle_price_ ? &*obstacle_price_ : nullptr;
  }

  /// To be told of every face that the topology gave way with.
  void renew(int f) {
    face_guard_.renew(f);
    if (crossing_guard_) crossing_guard_->update(f);
  }

  void renumber(const Renumbering& numbers) {
    face_guard_.renumber(numbers);
    bound_.renumber(numbers);
    if (crossing_guard_) crossing_guard_->rebuild();
  }

 private:
  Obstacle obstacle(const EdgeNeighborhood& around) const {
    if (obstacle_price_)
      return find_obstacle(mesh_, around, rule_.of_kinds(around.edge()).has_value());
    return {satisfies_link_condition(mesh_, around) ? Obstacle::Kind::None : Obstacle::Kind::Fixed};
  }

  const WorkingMesh& mesh_;
  const CollapseRule rule_;
  const bool link_condition_;  // also for the bound: without it a part may vanish
  const bool keeps_normal_;
  FaceGuard face_guard_;
  std::optional<ObstaclePrice> obstacle_price_;  // where the topology gives way
  CollapseBound bound_;
  std::optional<CrossingGuard> crossing_guard_;  // where faces may not cross
};

}  // namespace curvdecim::detail
