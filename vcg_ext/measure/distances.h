// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/morton.h"
#include "vcg_ext/measure/area_samples.h"
#include "vcg_ext/measure/fixed_blocks.h"
#include "vcg_ext/measure/measured_surface.h"

namespace curvdecim::detail {

/// Degrees between unit vectors; exact for small angles, too.
inline double degrees_between(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * (180.0 / M_PI);
}

inline constexpr Grain one_run{1, 1 << 6};  ///< some hundred searches

/// The root of a squared distance in the box of diagonal 1. What rounding leaves of 0 is none.
inline double length_of(double distance2) {
  constexpr double rounding = 1e-14;
  return distance2 > rounding * rounding ? std::sqrt(distance2) : 0.0;
}

/// What samples of a surface see of another one, by sample.
struct Readings {
  Array<double> distance;  // to the nearest point, in the box of diagonal 1
  Array<double> turn;      // between the normals here and there, degrees

  int count() const { return static_cast<int>(distance.size()); }
};

/// A sample with its place on the curve through space.
struct SampleInSpace {
  std::uint64_t code;
  int number, face;
  Vector3 point;
};

/// Those of a run along the curve: a point then looks first at the face that the one before it is
/// nearest to, and most are near it, too.
inline std::vector<SampleInSpace> along_curve(const MeasuredSurface& from,
                                              const AreaSamples& samples, int run) {
  std::vector<SampleInSpace> order;
  samples.for_run(run, [&](int i, int face, const Barycentric& weight) {
    const Vector3 p = at(from.triangle(face), weight);
    order.push_back({morton_code(p.cwiseMax(-0.5).cwiseMin(0.5)), i, face, p});
  });
  std::sort(order.begin(), order.end(), [](const SampleInSpace& a, const SampleInSpace& b) {
    return std::tie(a.code, a.number) < std::tie(b.code, b.number);
  });
  return order;
}

inline Readings read_samples(const MeasuredSurface& from, const AreaSamples& samples,
                             const MeasuredSurface& to, const Parallel& parallel) {
  Readings readings;
  readings.distance.resize(samples.count()), readings.turn.resize(samples.count());
  const auto read_run = [&](int run) {
    int hint = SurfacePoint::none;
    for (const SampleInSpace& sample : along_curve(from, samples, run)) {
      const SurfacePoint found = to.nearest(sample.point, hint);
      hint = found.face;
      readings.distance[sample.number] = length_of(found.distance2);
      readings.turn[sample.number] =
          degrees_between(from.plane(sample.face).normal, to.plane(hint).normal);
    }
  };
  parallel.for_each(samples.runs(), read_run, one_run);
  return readings;
}

/// work(begin, end) for runs of neighbours that cover 0..count. The runs do not depend on the
/// number of threads: what one starts with may show in the last bit.
template <class Work>
void for_runs(int count, const Parallel& parallel, Work work) {
  constexpr int length = 256;
  parallel.for_each(
      count / length + (count % length != 0),
      [&](int run) {
        const int begin = run * length;
        work(begin, begin + std::min(length, count - begin));
      },
      one_run);
}

/// How far points, neighbours of which are neighbours in space, are from a surface.
inline std::vector<double> distances_of(const std::vector<Vector3>& points,
                                        const MeasuredSurface& to, const Parallel& parallel) {
  std::vector<double> distance(points.size());
  for_runs(static_cast<int>(points.size()), parallel, [&](int begin, int end) {
    int hint = SurfacePoint::none;
    for (int i = begin; i < end; ++i) {
      const SurfacePoint found = to.nearest(points[i], hint);
      hint = found.face;
      distance[i] = length_of(found.distance2);
    }
  });
  return distance;
}

/// Looks for the point that is farthest from a surface. Most are not: to know that, it is enough
/// that the face that the last one was nearest to is nearer than the farthest that is known.
class FarthestPoint {
 public:
  /// known: the distance of a point before.
  FarthestPoint(const MeasuredSurface& to, double known) : to_(to), distance2_(known * known) {}

  void look_at(const Vector3& p) {
    if (hint_ != SurfacePoint::none && squared_distance(to_.triangle(hint_), p) <= distance2_)
      return;
    const SurfacePoint found = to_.nearest(p, hint_);
    hint_ = found.face;
    distance2_ = std::max(distance2_, found.distance2);
  }

  double distance() const { return length_of(distance2_); }

 private:
  const MeasuredSurface& to_;
  double distance2_;
  int hint_ = SurfacePoint::none;
};

/// The largest distance of what look(i, farthest) looks at for all i below count, neighbours after
/// each other, or the known one if that is larger.
template <class Look>
double farthest(int count, double known, const MeasuredSurface& to, const Parallel& parallel,
                Look look) {
  std::vector<double> distance(count, known);  // at the first of each run
  for_runs(count, parallel, [&](int begin, int end) {
    FarthestPoint point(to, known);
    for (int i = begin; i < end; ++i) look(i, point);
    distance[begin] = std::max(known, point.distance());
  });
  return *std::max_element(distance.begin(), distance.end());
}

/// True for the first of the faces at an edge: each edge counts once.
inline bool is_first_at_edge(const TriangleConnectivity& connectivity, int f, int a, int b) {
  if (connectivity.faces_of(a).size() > connectivity.faces_of(b).size()) std::swap(a, b);
  const IndexRange faces = connectivity.faces_of(a);
  return std::none_of(faces.begin(), faces.end(),
                      [&](int g) { return g < f && connectivity.face_has(g, b); });
}

/// Looks at points along an edge, its ends left out: at the spacing of samples, and at the middle.
inline void look_along(const Vector3& a, const Vector3& b, double spacing,
                       FarthestPoint& farthest) {
  constexpr double most_points = 1024.0;  // of an edge that is much longer than the other surface
  const int points = static_cast<int>(std::clamp((b - a).norm() / spacing, 1.0, most_points));
  for (int k = 1; k <= points; ++k) farthest.look_at(a + (k / (points + 1.0)) * (b - a));
}

/// The largest distance of points along all edges of a surface to another, or the known one.
inline double farthest_along_edges(const MeasuredSurface& from, double spacing, double known,
                                   const MeasuredSurface& to, const Parallel& parallel) {
  const WorkingMesh& mesh = from.mesh();
  return farthest(from.face_count(), known, to, parallel, [&](int i, FarthestPoint& point) {
    const int f = from.number_in_mesh(i);
    const Face& face = mesh.connectivity.face(f);
    for (int k = 0; k < 3; ++k) {
      const int a = face[k], b = face[(k + 1) % 3];
      if (is_first_at_edge(mesh.connectivity, f, a, b))
        look_along(mesh.position[a], mesh.position[b], spacing, point);
    }
  });
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
