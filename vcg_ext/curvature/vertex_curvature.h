// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "vcg_ext/geometry/angle_sum.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/params.h"

namespace curvdecim::detail {

/// Discrete curvature around a vertex, in the unit of the positions.
struct VertexCurvature {
  double gaussian = 0.0;  ///< angle defect / area, 1/length^2, by Gauss-Bonnet @cite pellizzoni2020
  double mean = 0.0;      ///< area gradient along the normal / (2 area), 1/length @cite meyer2003
  double area = 0.0;      ///< a third of the faces around, length^2
  double missing = 0.0;   ///< angle missing from a full turn / area: gaussian, and where it ends

  /// |k1| + |k2| of the principal curvatures mean +- sqrt(mean^2 - gaussian), 1/length.
  double absolute() const {
    return gaussian >= 0.0 ? 2.0 * std::abs(mean) : 2.0 * std::sqrt(mean * mean - gaussian);
  }

  double of_kind(CurvatureKind kind) const {
    return kind == CurvatureKind::Gaussian ? std::abs(gaussian) : absolute();
  }

  /// The same, 1/length^2, as |K|, which is also the angle that the border of an open surface
  /// leaves out. Absolute adds a little of (|k1| + |k2|)^2: cylinders and ridges come between what
  /// is flat and what is curved both ways.
  double density(CurvatureKind kind) const {
    constexpr double ridges = 0.03;  // a cylinder counts about a fortieth of a sphere
    const double k = absolute();
    return std::abs(missing) + (kind == CurvatureKind::Gaussian ? 0.0 : ridges * k * k);
  }

  /// What the weight is a function of.
  double measure(const CurvatureParams& params) const {
    return params.alpha_units == AlphaUnits::ScaleFree ? density(params.curvature_kind)
                                                       : of_kind(params.curvature_kind);
  }
};

/// The corner of face f at vertex v.
struct FaceCorner {
  const FacePlane& plane;
  Vector3 to_next, to_last;  // its edges

  FaceCorner(const WorkingMesh& mesh, int f, int v) : plane(mesh.plane[f]) {
    const int next = mesh.connectivity.next_vertex(f, v);
    to_next = mesh.position[next] - mesh.position[v];
    to_last = mesh.position[mesh.connectivity.third_vertex(f, v, next)] - mesh.position[v];
  }

  /// Cosine and sine of the angle there, both times the same: the area tells the sine.
  double cosine() const { return to_next.dot(to_last); }
  double sine() const { return 2.0 * plane.area; }
  double angle() const { return std::atan2(sine(), cosine()); }
};

using CornerAngles = std::array<double, 3>;

/// All angles of face f, radians: what two leave of a half turn is the third.
inline CornerAngles corner_angles(const WorkingMesh& mesh, int f) {
  const Face& face = mesh.connectivity.face(f);
  const double first = FaceCorner(mesh, f, face[0]).angle();
  const double second = FaceCorner(mesh, f, face[1]).angle();
  return {first, second, std::max(M_PI - first - second, 0.0)};
}

/// What curvature is made of: sums over the faces around a vertex, so that a face can come and go.
struct CurvatureSums {
  double angles = 0.0, area = 0.0;
  Vector3 gradient = Vector3::Zero(), normal = Vector3::Zero();

  /// A face with its corner at the vertex, but for the angle; sign: 1 to add, -1 to take away.
  void add(const FaceCorner& corner, double sign) {
    const FacePlane& plane = corner.plane;
    area += sign * (plane.area / 3.0);
    gradient += (0.5 * sign) * plane.normal.cross(corner.to_last - corner.to_next);
    normal += (sign * plane.area) * plane.normal;
  }

  /// All zero where the faces around have no area. On the boundary the full angle is pi.
  VertexCurvature curvature(VertexKind kind) const {
    const double length = normal.norm();
    if (!(area > 0.0) || !(length > 0.0)) return {};
    const double full = kind == VertexKind::Boundary ? M_PI : 2.0 * M_PI;
    return {(full - angles) / area, gradient.dot(normal) / (2.0 * area * length), area,
            (2.0 * M_PI - angles) / area};
  }
};

/// The curvature at v, by the faces around it.
inline VertexCurvature vertex_curvature(const WorkingMesh& mesh, int v) {
  CurvatureSums sums;
  AngleSum angles;
  for (int f : mesh.connectivity.faces_of(v)) {
    const FaceCorner corner(mesh, f, v);
    angles.add(corner.cosine(), corner.sine()), sums.add(corner, 1.0);
  }
  sums.angles = angles.value();
  return sums.curvature(mesh.kind[v]);
}

}  // namespace curvdecim::detail
