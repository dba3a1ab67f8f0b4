// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "vcg_ext/guard/error_bound.h"
#include "vcg_ext/guard/step_bound.h"

namespace curvdecim::detail {

/// Whether collapses stay within a distance to the input. At first the sums of moves tell
/// (error_bound.h), later on, one edge after the other, what is there (step_bound.h).
class CollapseBound {
 public:
  /// limit: in the unit of the working mesh; 0 for none.
  CollapseBound(const WorkingMesh& mesh, double limit)
      : mesh_(mesh), limit_(limit), sums_(mesh, share_of_sums * limit) {}

  bool active() const { return limit_ > 0.0; }

  /// How far apart the surfaces may be around the edge, were it collapsed to x; nullopt: too far. A
  /// distance above the limit is to be measured, before the collapse.
  std::optional<double> after(const EdgeNeighborhood& around, const Vector3& x) const {
    if (measured_) return known(around, x);
    const double sum = sums_.after(mesh_, around, x);
    return sums_.allows(sum) ? std::optional(sum) : std::nullopt;
  }

  /// The same about the collapse that was asked about last, without a doubt.
  std::optional<double> settle(double distance) const {
    return measured_ ? measured_->measure(mesh_) : std::optional(distance);
  }

  /// The collapse that was asked about last is done.
  void accept(const EdgeNeighborhood& around, double distance) {
    if (measured_)
      measured_->accept(mesh_);
    else if (active())
      sums_.set(around, distance);
  }

  /// From now on distances to the input are measured: edges have to be asked about and collapsed
  /// one by one. bound: has begun with the mesh.
  void measure_with(SurfaceBound& bound) { measured_ = std::make_unique<StepBound>(bound); }

  /// The sum of moves may go up to the bound itself.
  void rely_on_sums() { sums_.set_limit(limit_); }

  void renumber(const Renumbering& numbers) { sums_.renumber(numbers); }

 private:
  /// Share of the bound that sums go to before distances are measured. Sums cost little and go
  /// together, but count what comes back; from .03 to .1 as many faces are left.
  static constexpr double share_of_sums = 0.1;

  std::optional<double> known(const EdgeNeighborhood& around, const Vector3& x) const {
    measured_->change().set_collapse(mesh_, around, x);
    const auto distance = measured_->known(ErrorBound::moved(mesh_, around, x));
    if (distance && *distance > limit_ && !measured_->is_near(x)) return std::nullopt;
    return distance;
  }

  const WorkingMesh& mesh_;
  const double limit_;
  ErrorBound sums_;
  std::unique_ptr<StepBound> measured_;  // not yet
};

}  // namespace curvdecim::detail
