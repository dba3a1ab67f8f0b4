// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "vcg_ext/geometry/algebraic_sphere.h"
#include "vcg_ext/geometry/triangle.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/params.h"

namespace curvdecim::detail {

/// Mean of the sphere's value over the triangle, exactly.
inline double mean_over(const AlgebraicSphere& sphere, const Triangle& t) {
  return (sphere.value(t[0]) + sphere.value(t[1]) + sphere.value(t[2])) / 3.0 -
         sphere.q * sum_of_squared_edges(t) / 12.0;
}

/// Mean of its square, exactly: the square has the degree 4, and so has the rule of six points
/// @cite dunavant1985.
inline double mean_square_over(const AlgebraicSphere& sphere, const Triangle& t) {
  struct Orbit {
    double weight, apex;  // of the three points; barycentric coordinate that stands out
  };
  constexpr std::array<Orbit, 2> orbits = {
      {{0.223381589678011, 0.108103018168070}, {0.109951743655322, 0.816847572980459}}};
  const Vector3 sum = t[0] + t[1] + t[2];
  double mean = 0.0;
  for (const auto& [weight, apex] : orbits) {
    const double other = 0.5 * (1.0 - apex);
    for (const Vector3& corner : t) {
      const double value = sphere.value(other * sum + (apex - other) * corner);
      mean += weight * value * value;
    }
  }
  return mean;
}

/// How far faces are from spheres, summed over them @cite michaud2017.
struct RingEnergy {
  double area = 0.0;      // length^2
  double absolute = 0.0;  // sum of |mean signed distance| x area, length^3
  double squared = 0.0;   // integral of the squared distance, length^4

  void add(const AlgebraicSphere& sphere, const Triangle& t) {
    const double face_area = area_vector(t).norm();
    area += face_area;
    absolute += face_area * std::abs(mean_over(sphere, t));
    squared += face_area * mean_square_over(sphere, t);
  }

  double of(SphereEnergy kind) const { return kind == SphereEnergy::Squared ? squared : absolute; }
};

/// A sum of squared distances to planes, weighted by area, in the unit of the energy; weight: sum
/// of the areas.
inline double planes_in_unit_of(SphereEnergy kind, double squares, double weight) {
  return kind == SphereEnergy::Squared ? squares : std::sqrt(std::max(0.0, squares) * weight);
}

/// What distances of this length make of the energy over an area.
inline double energy_of_distance(SphereEnergy kind, double distance, double area) {
  return area * (kind == SphereEnergy::Squared ? distance * distance : distance);
}

/// use(triangle about x, u, v) for the faces at exactly one end of the edge, as they will be with x
/// for that end; the corners u and v follow x in the face.
template <class Use>
void for_faces_after(const WorkingMesh& mesh, Edge edge, const Vector3& x, Use use) {
  const TriangleConnectivity& connectivity = mesh.connectivity;
  for (const auto& [end, other] : {std::pair(edge.a, edge.b), std::pair(edge.b, edge.a)})
    for (int f : connectivity.faces_of(end)) {
      if (connectivity.face_has(f, other)) continue;
      const int u = connectivity.next_vertex(f, end), v = connectivity.third_vertex(f, end, u);
      use(Triangle{Vector3::Zero(), mesh.position[u] - x, mesh.position[v] - x}, u, v);
    }
}

}  // namespace curvdecim::detail
