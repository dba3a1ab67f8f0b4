// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_set>

#include "vcg_ext/guard/surface_bound.h"

namespace curvdecim::detail {

/// Whether steps, one after the other, stay within a distance to the input:
///
///   the distance before and the move within the limit? so is the step
///   it was too far before? so it is                                  (surface_change.h)
///   otherwise the distance is measured                               (surface_bound.h)
class StepBound {
 public:
  /// surface: has begun with the mesh.
  explicit StepBound(SurfaceBound& surface) : surface_(surface) {}

  /// The step that is asked about; to be filled in first.
  SurfaceChange& change() { return change_; }

  /// How far apart the surfaces will be where it changes them; nullopt: too far. A distance above
  /// the limit is to be measured, before the step. moved: how far it moves a point at most.
  std::optional<double> known(double moved) {
    sum_ = surface_.before(change_) + moved;
    if (sum_ > surface_.limit() && too_far_.count(change_.fingerprint()) > 0) return std::nullopt;
    return sum_;
  }

  /// Whether a point is near the input.
  bool is_near(const Vector3& x) const { return surface_.is_near(x, change_.gone.front()); }

  /// The same as known(), without a doubt. Surface: triangle(f).
  template <class Surface>
  std::optional<double> measure(const Surface& surface) {
    if (sum_ <= surface_.limit()) return sum_;
    const double distance = surface_.after(surface, change_);
    if (distance <= surface_.limit()) return distance;
    too_far_.insert(change_.fingerprint());
    return std::nullopt;
  }

  /// The step is done now; the surface is still what it was before.
  template <class Surface>
  void accept(const Surface& surface) {
    if (sum_ <= surface_.limit())
      surface_.follow(surface, change_, sum_);
    else
      surface_.accept(change_);
  }

 private:
  SurfaceBound& surface_;
  SurfaceChange change_;
  double sum_ = 0.0;                           // of the distance before and the move
  std::unordered_set<std::uint64_t> too_far_;  // fingerprints of changes
};

}  // namespace curvdecim::detail
