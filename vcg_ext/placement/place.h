// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/quadric.h"
#include "vcg_ext/metric/candidate.h"
#include "vcg_ext/params.h"
#include "vcg_ext/placement/line.h"
#include "vcg_ext/placement/optimal.h"

namespace curvdecim {

/// A point near the edge from -half to +half (the midpoint is the origin).
struct Placed {
  Vector3 offset;
  double t;      // 0..1: the nearest point of the edge
  double value;  // of the quadric
};

/// t = 0 and t = 1 give the ends exactly.
inline Placed place_at(const Quadric& q, const Vector3& half, double t) {
  const Vector3 offset = (2.0 * t - 1.0) * half;
  return {offset, t, q.value(offset)};
}

inline Placed place_half_edge(const Quadric& q, const Vector3& half) {
  const Placed a = place_at(q, half, 0.0), b = place_at(q, half, 1.0);
  return a.value <= b.value ? a : b;
}

inline Placed place_endpoint_or_midpoint(const Quadric& q, const Vector3& half) {
  const Placed end = place_half_edge(q, half);
  return q.c < end.value ? place_at(q, half, 0.5) : end;
}

inline Placed place_optimal(const QuadricOfEdge& q, const Vector3& half,
                            const std::optional<VolumePlane>& volume) {
  const Minimum minimum = optimal_minimum(q, volume, half);
  return {minimum.offset, parameter_along(half, minimum.offset), minimum.value};
}

/// volume: for Optimal only.
inline Placed place(const QuadricOfEdge& quadric, const Vector3& half, Allowed allowed,
                    Placement placement, const std::optional<VolumePlane>& volume = std::nullopt) {
  const Quadric& q = quadric.sum;
  if (allowed == Allowed::OntoA) return place_at(q, half, 0.0);
  if (allowed == Allowed::OntoB) return place_at(q, half, 1.0);
  switch (placement) {
    case Placement::Optimal: return place_optimal(quadric, half, volume);
    case Placement::Line: return place_at(q, half, parameter_of_minimum(q, half));
    case Placement::EndpointOrMidpoint: return place_endpoint_or_midpoint(q, half);
    case Placement::HalfEdge: break;
  }
  return place_half_edge(q, half);
}

}  // namespace curvdecim
