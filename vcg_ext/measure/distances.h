// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "vcg_ext/measure/area_samples.h"
#include "vcg_ext/measure/fixed_blocks.h"
#include "vcg_ext/measure/measured_surface.h"

namespace curvdecim::detail {

/// Degrees between unit vectors; exact for small angles, too.
inline double degrees_between(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * (180.0 / M_PI);
}

/// What samples of a surface see of another one, by sample.
struct Readings {
  Array<double> distance;  // to the nearest point, in the box of diagonal 1
  Array<double> turn;      // between the normals here and there, degrees

  int count() const { return static_cast<int>(distance.size()); }
};

/// A point looks first at the face that its neighbour is nearest to: most are near it, too.
inline Readings read_samples(const MeasuredSurface& from, const AreaSamples& samples,
                             const MeasuredSurface& to, const Parallel& parallel) {
  Readings readings;
  readings.distance.resize(samples.count()), readings.turn.resize(samples.count());
  samples.for_each(
      parallel, [] { return int{SurfacePoint::none}; },
      [&](int& hint, int i, int face, const Barycentric& weight) {
        const SurfacePoint found = to.nearest(at(from.triangle(face), weight), hint);
        hint = found.face;
        readings.distance[i] = std::sqrt(found.distance2);
        readings.turn[i] = degrees_between(from.plane(face).normal, to.plane(found.face).normal);
      });
  return readings;
}

/// Of points, neighbours of which are neighbours in space, to a surface.
inline std::vector<double> distances_of(const std::vector<Vector3>& points,
                                        const MeasuredSurface& to, const Parallel& parallel) {
  constexpr int run_length = 64;
  const int count = static_cast<int>(points.size());
  std::vector<double> distance(count);
  parallel.for_each((count + run_length - 1) / run_length,
                    [&](int run) {
                      int hint = SurfacePoint::none;
                      for (int i = run * run_length; i < std::min(count, (run + 1) * run_length);
                           ++i) {
                        const SurfacePoint found = to.nearest(points[i], hint);
                        hint = found.face;
                        distance[i] = std::sqrt(found.distance2);
                      }
                    },
                    Parallel::heavy);
  return distance;
}

/// True for the first of the faces at an edge: each edge counts once.
inline bool is_first_at_edge(const TriangleConnectivity& connectivity, int f, int a, int b) {
  if (connectivity.faces_of(a).size() > connectivity.faces_of(b).size()) std::swap(a, b);
  const IndexRange faces = connectivity.faces_of(a);
  return std::none_of(faces.begin(), faces.end(),
                      [&](int g) { return g < f && connectivity.face_has(g, b); });
}

/// The largest distance of points along an edge, their ends left out: at the spacing of samples,
/// and in the middle at least.
inline double largest_along(const Vector3& a, const Vector3& b, double spacing,
                            const MeasuredSurface& to, int& hint) {
  constexpr double most_points = 1024.0;  // of an edge that is much longer than the other surface
  const int points = static_cast<int>(std::clamp((b - a).norm() / spacing, 1.0, most_points));
  double largest2 = 0.0;
  for (int k = 1; k <= points; ++k) {
    const SurfacePoint found = to.nearest(a + (k / (points + 1.0)) * (b - a), hint);
    hint = found.face;
    largest2 = std::max(largest2, found.distance2);
  }
  return std::sqrt(largest2);
}

/// The largest distance of points along all edges of a surface to another.
inline double largest_along_edges(const MeasuredSurface& from, double spacing,
                                  const MeasuredSurface& to, const Parallel& parallel) {
  const WorkingMesh& mesh = from.mesh();
  std::vector<double> largest(from.face_count(), 0.0);
  parallel.for_each(
      from.face_count(),
      [&](int i) {
        const int f = from.number_in_mesh(i);
        const Face& face = mesh.connectivity.face(f);
        int hint = SurfacePoint::none;
        for (int k = 0; k < 3; ++k) {
          const int a = face[k], b = face[(k + 1) % 3];
          if (!is_first_at_edge(mesh.connectivity, f, a, b)) continue;
          largest[i] = std::max(
              largest[i], largest_along(mesh.position[a], mesh.position[b], spacing, to, hint));
        }
      },
      Parallel::heavy);
  return *std::max_element(largest.begin(), largest.end());
}

/// Faces that are turned by more than 90 degrees against the original, at their middle.
inline int count_flipped(const MeasuredSurface& simplified, const MeasuredSurface& original,
                         const Parallel& parallel) {
  return static_cast<int>(sum_of(simplified.face_count(), parallel, [&](int i) {
    const Vector3 middle = center_of(simplified.triangle(i));
    const int there = original.nearest(middle, SurfacePoint::none).face;
    return simplified.plane(i).normal.dot(original.plane(there).normal) < 0.0 ? 1.0 : 0.0;
  }));
}

}  // namespace curvdecim::detail
