// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "vcg_ext/errors.h"
#include "vcg_ext/params.h"

namespace curvdecim {

/// Throws InputError unless low <= value <= high (NaN is refused too).
inline void require_range(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  std::ostringstream message;
  message << name << " is " << value << ", but must lie between " << low << " and " << high << '.';
  throw InputError(message.str());
}

inline void require_at_least(const char* name, double value, double low) {
  if (value >= low && std::isfinite(value)) return;
  std::ostringstream message;
  message << name << " is " << value << ", but must be a finite number of at least " << low << '.';
  throw InputError(message.str());
}

inline void validate(const DecimationParams& params) {
  require_at_least("TargetFaceNum", params.target_faces, 0);
  require_at_least("TargetVertNum", params.target_vertices, 0);
  require_range("TargetPerc", params.target_fraction, 0.0, 1.0);
  require_at_least("MaxError", params.max_error, 0.0);
  require_at_least("BoundaryWeight", params.boundary_weight, 0.0);
  require_range("NormalAngle", params.normal_angle, 0.0, 180.0);
  require_range("FeatureAngle", params.feature_angle, 0.0, 180.0);
  require_at_least("Threads", params.threads, 0);
}

inline void validate(const CurvatureParams& params) {
  if (std::isnan(params.alpha))
    throw InputError("Alpha is not a number; give 0 or less for infinite.");
  require_range("CurvatureFloor", params.curvature_floor, 0.0, 1.0);
}

inline void validate(const EdgeCollapseParams& params) {
  validate(static_cast<const DecimationParams&>(params));
  validate(static_cast<const CurvatureParams&>(params));
  require_at_least("Lambda", params.lambda, 0.0);
  require_at_least("RefineSweeps", params.refine_sweeps, 0);
  require_at_least("PairDistance", params.pair_distance, 0.0);
  if (params.pair_distance > 0.0 && params.max_error > 0.0)
    throw InputError(
        "PairDistance and MaxError are both given, but no bound is known where parts join. Set one "
        "of them to 0.");
}

inline void validate(const SphereParams& params) {
  validate(static_cast<const DecimationParams&>(params));
  require_range("KernelScale", params.kernel_scale, SphereParams::least_kernel_scale,
                SphereParams::largest_kernel_scale);
  require_at_least("RefineSweeps", params.refine_sweeps, 0);
}

inline void validate(const VertexRemovalParams& params) {
  validate(static_cast<const DecimationParams&>(params));
  require_at_least("DistanceBound", params.distance_bound, 0.0);
  require_range("AspectRatioMin", params.aspect_ratio_min, 0.0, 0.5);
}

inline void validate(const ClusteringParams& params) {
  require_at_least("CellSize", params.cell_size, 0.0);
  require_at_least("TargetFaceNum", params.target_faces, 0);
  require_range("TargetPerc", params.target_fraction, 0.0, 1.0);
  require_at_least("BoundaryWeight", params.boundary_weight, 0.0);
  require_at_least("Threads", params.threads, 0);
  if (params.cell_size == 0.0 && params.target_faces == 0 && params.target_fraction == 0.0)
    throw InputError("No target is given. Set CellSize, TargetFaceNum or TargetPerc.");
}

}  // namespace curvdecim
