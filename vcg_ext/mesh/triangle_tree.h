// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/mesh/face_boxes.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// A point of a surface, and how far it is from where one asked.
struct SurfacePoint {
  static constexpr int none = -1;

  int face = none;
  Barycentric weight{};
  double distance2 = std::numeric_limits<double>::infinity();

  bool found() const { return face != none; }
};

/// For searches: takes every face.
inline bool any_face(const Vector3&) { return true; }

/// Sets `best` to the point of a triangle nearest to p, if it is nearer. normal: of any length.
inline void look_at(const Triangle& t, const Vector3& normal, int face, const Vector3& p,
                    SurfacePoint& best) {
  const double height = normal.dot(p - t[0]);
  if (height * height > best.distance2 * normal.squaredNorm()) return;  // so is its plane already
  const Barycentric weight = closest_point(t, normal, p);
  const double distance2 = (at(t, weight) - p).squaredNorm();
  if (distance2 < best.distance2) best = {face, weight, distance2};
}

/// The same for face f of a surface, if `accept` takes the face's normal.
template <class Surface, class Accept>
void look_at(const Surface& surface, int f, const Vector3& p, Accept accept, SurfacePoint& best) {
  const Triangle& t = surface.triangle(f);
  const Vector3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  if (accept(normal)) look_at(t, normal, f, p, best);
}

/// Finds the points of a surface that are nearest to others, by boxes around its faces.
///
/// Surface: triangle(f). Its vertices may move, if refit is called afterwards.
template <class Surface>
class TriangleTree {
 public:
  /// faces: at least one.
  TriangleTree(const Surface& surface, int faces, const Parallel& parallel)
      : boxes_(surface, faces, parallel) {}

  void refit(const Parallel& parallel) { boxes_.refit(parallel); }

  /// hint: a face near by, to look at first, or SurfacePoint::none.
  SurfacePoint nearest(const Vector3& p, int hint) const {
    return search(p, hint, std::numeric_limits<double>::infinity(), any_face);
  }

  /// The nearest point within the root of limit2; not found where there is none.
  SurfacePoint nearest_within(const Vector3& p, double limit2, int hint) const {
    return search(p, hint, limit2, any_face);
  }

  /// The nearest point on faces that do not face away from `normal`, within the root of limit2; not
  /// found where there is none.
  SurfacePoint nearest_facing(const Vector3& p, const Vector3& normal, double limit2,
                              int hint) const {
    return search(p, hint, limit2, [&](const Vector3& n) { return n.dot(normal) >= 0.0; });
  }

  const Surface& surface() const { return boxes_.surface(); }

 private:
  template <class Accept>
  SurfacePoint search(const Vector3& p, int hint, double limit2, Accept accept) const {
    SurfacePoint best;
    best.distance2 = limit2;
    if (hint != SurfacePoint::none) look_at(surface(), hint, p, accept, best);
    boxes_.tree().visit_near(p, best.distance2, [&](int leaf) {
      for (int f : boxes_.faces_of(leaf)) look_at(surface(), f, p, accept, best);
    });
    return best;
  }

  static constexpr int leaf_size = 2;

  FaceBoxes<Surface, leaf_size> boxes_;
};

}  // namespace curvdecim::detail
