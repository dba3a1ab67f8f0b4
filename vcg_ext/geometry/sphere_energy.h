// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "vcg_ext/geometry/algebraic_sphere.h"
#include "vcg_ext/geometry/triangle.h"

namespace curvdecim {

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

}  // namespace curvdecim
