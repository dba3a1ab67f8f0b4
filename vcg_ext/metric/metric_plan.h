// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "vcg_ext/params.h"

namespace curvdecim::detail {

/// Quadrics of planes, and of what holds boundaries and sharp edges.
struct QuadricPlan : QuadricParams {
  double boundary_weight = 1.0;
  double feature_angle = 60.0;  ///< degrees
  bool keeps_topology = true;   ///< around an inner vertex no boundary changes and no face is lost
  double seam_weight = 0.0;     ///< of seams, against the surface
};

/// Quadrics times a factor that grows with curvature.
struct CurvatureWeightedPlan {
  QuadricPlan quadrics;
  CurvatureParams curvature;
  double diagonal = 1.0;  ///< of the input in its own unit, for AlphaUnits::ModelUnits
};

/// Quadrics plus lambda times a term of curvature.
struct CurvatureAdditivePlan {
  QuadricPlan quadrics;
  double lambda = 0.0;
  CurvatureTerm term = CurvatureTerm::Melax;
};

/// Algebraic spheres, with quadrics for what they do not hold.
struct SpherePlan {
  QuadricPlan quadrics;
  KernelParams kernel;
  SphereEnergy energy = SphereEnergy::Squared;
};

struct AnchoredSpherePlan : SpherePlan {};
struct InterpolatedSpherePlan : SpherePlan {};

/// The metric of a run: which, and all that it needs to know.
using MetricPlan = std::variant<QuadricPlan, CurvatureWeightedPlan, CurvatureAdditivePlan,
                                AnchoredSpherePlan, InterpolatedSpherePlan>;

}  // namespace curvdecim::detail
