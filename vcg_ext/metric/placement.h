// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "vcg_ext/geometry/quadric.h"
#include "vcg_ext/mesh/vertex_kind.h"
#include "vcg_ext/params.h"

namespace curvdecim::detail {

/// Where, from 0 (-half) to 1 (+half), the quadric is least on the edge; 0.5 where it is flat.
inline double parameter_of_minimum(const Quadric& q, const Vector3& half) {
  const double curvature = half.dot(q.a * half);
  if (!(curvature > 0.0)) return 0.5;
  return std::clamp(0.5 - 0.5 * q.b.dot(half) / curvature, 0.0, 1.0);
}

/// The parameter of the point of the edge nearest to `offset`.
inline double parameter_along(const Vector3& half, const Vector3& offset) {
  const double length2 = half.squaredNorm();
  return length2 > 0.0 ? std::clamp(0.5 + 0.5 * half.dot(offset) / length2, 0.0, 1.0) : 0.5;
}

/// The plane gradient.d = offset on which the collapse leaves the enclosed volume, or the area
/// inside the border, as it is @cite lindstrom1998.
struct KeepingPlane {
  Vector3 gradient;
  double offset;
};

/// A point and the value of the quadric there.
struct Minimum {
  Vector3 offset;
  double value;
};

/// How strongly a minimum is drawn to the midpoint: to the trace, that is to the strongest
/// direction.
inline constexpr double relative_pull = 1e-4;

/// A step of this part of the edge keeps the volume to rounding already.
inline constexpr double least_step = 1e-7;

/// Minimum of the quadric, drawn towards the origin (the edge's midpoint) just strongly enough that
/// directions in which it is flat do not throw the vertex far away; then moved, where that takes no
/// more than the edge's length, to the minimum among the points that keep the volume or area. The
/// edge goes from -half to +half. With p the pull, (A + p) x = -b gives the value without another
/// product: c + b.x - p x.x, and so do the steps from there.
inline Minimum optimal_minimum(const QuadricOfEdge& quadric,
                               const std::optional<KeepingPlane>& kept, const Vector3& half) {
  const Quadric& q = quadric.sum;
  const double trace = q.a.trace(), pull = relative_pull * trace;
  if (!(trace > 0.0)) return {Vector3::Zero(), q.c};
  const Factorization3 a(q.a.plus_diagonal(pull));
  const Vector3 offset = -a.solve(q.b);
  const double least = q.c + q.b.dot(offset) - pull * offset.squaredNorm();
  const double even = quadric.along + q.c, odd = 2.0 * q.b.dot(half);
  if (even - odd < least) return {-half, even - odd};  // a corner: only the pull moved it off
  if (even + odd < least) return {half, even + odd};
  if (!kept) return {offset, least};
  const Vector3 direction = a.solve(kept->gradient);
  const double slope = kept->gradient.dot(direction), length2 = direction.squaredNorm();
  const double gap = kept->offset - kept->gradient.dot(offset);
  const double step2 = gap * gap * length2, edge2 = 4.0 * half.squaredNorm() * (slope * slope);
  if (!(step2 <= edge2) || step2 <= least_step * least_step * edge2 || !(slope > 0.0))
    return {offset, least};
  const double step = gap / slope;
  const double rise = step * (slope - pull * length2) - 2.0 * pull * offset.dot(direction);
  return {offset + step * direction, least + step * rise};
}

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
                            const std::optional<KeepingPlane>& kept) {
  const Minimum minimum = optimal_minimum(q, kept, half);
  return {minimum.offset, parameter_along(half, minimum.offset), minimum.value};
}

/// kept: for Optimal only.
inline Placed place(const QuadricOfEdge& quadric, const Vector3& half, Allowed allowed,
                    Placement placement, const std::optional<KeepingPlane>& kept = std::nullopt) {
  const Quadric& q = quadric.sum;
  if (allowed == Allowed::OntoA) return place_at(q, half, 0.0);
  if (allowed == Allowed::OntoB) return place_at(q, half, 1.0);
  switch (placement) {
    case Placement::Optimal: return place_optimal(quadric, half, kept);
    case Placement::Line: return place_at(q, half, parameter_of_minimum(q, half));
    case Placement::EndpointOrMidpoint: return place_endpoint_or_midpoint(q, half);
    case Placement::HalfEdge: break;
  }
  return place_half_edge(q, half);
}

}  // namespace curvdecim::detail
