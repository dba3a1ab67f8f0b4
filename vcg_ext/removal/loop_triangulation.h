// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/removal/loop_part.h"

namespace curvdecim::detail {

/// Fills a loop with triangles by recursive split lines @cite schroeder1992:
///
///   triangulate(loop):
///     three corners? a triangle, if it is accepted
///     for the lines between two corners, the best first, that
///         part the loop: all corners of one half lie on one side of the split plane, which holds
///           the line and stands on the average plane, and all of the other on its other side
///         have an aspect ratio (least distance of a corner to the split plane, by the length of
///           the line) that is not too small
///         are no edges yet:
///       triangulate both halves; done? return
///     fail
///
/// Best is the line that is nearest to the old faces, which saves a tenth to a half of the error;
/// of equally near ones, as in a plane, that of the largest aspect ratio.
///
/// It knows how far the new triangles are from the old faces. Seen along one direction both are
/// height fields over one outline, and their difference is largest where a new edge crosses an old
/// one, or at the vertex that goes @cite cohen1997.
class LoopTriangulation {
 public:
  enum class Outcome { Done, EdgeExists, NoSplit };

  LoopTriangulation(const WorkingMesh& mesh, double least_aspect_ratio)
      : mesh_(mesh), least_aspect_ratio_(least_aspect_ratio) {}

  /// errors: by vertex, how far a point of the faces at it may be from the input already; of the
  /// apex apart. accept(triangle): whether no guard refuses it.
  template <class Accept>
  Outcome run(const LoopPart& part, const std::vector<double>& errors, double apex_error,
              Accept accept) {
    part_ = &part, errors_ = &errors, apex_error_ = apex_error;
    triangles_.clear();
    tries_ = 0;
    distance_ = {0.0, apex_error};
    if (closes_with_an_edge()) return Outcome::EdgeExists;
    flatten();
    if (!is_height_field()) return Outcome::NoSplit;
    measure_diagonals();
    Ring ring;
    for (int i = 0; i < corner_count(); ++i) ring.push(i);
    if (!triangulate(ring, accept)) return Outcome::NoSplit;
    if (part.closed) distance_ = larger(distance_, below_apex());
    return Outcome::Done;
  }

  const std::vector<LoopTriangle>& triangles() const { return triangles_; }

  /// Between the old faces and the new triangles, at most; 0 where it is rounding.
  double step() const { return distance_.step; }

  /// The same with what was there before: how far the new triangles are from the input at most, and
  /// the other way round.
  double error() const { return distance_.error; }

 private:
  /// Places of corners, around a part of the loop.
  struct Ring {
    std::array<int, VertexFan::longest + 1> place;
    int size = 0;

    void push(int corner) { place[size++] = corner; }
    int operator[](int i) const { return place[i]; }
  };

  struct Distance {
    double step, error;
  };

  static Distance larger(const Distance& a, const Distance& b) {
    return {std::max(a.step, b.step), std::max(a.error, b.error)};
  }

  /// A line between two corners of the loop.
  struct Diagonal {
    Distance below;
    double length2;  // its length by its length as seen along the direction
  };

  struct Split {
    int from, to;  // in the ring
    Distance distance;
    double aspect_ratio;

    bool operator<(const Split& o) const {
      return std::tie(distance.step, o.aspect_ratio, from, to) <
             std::tie(o.distance.step, aspect_ratio, o.from, o.to);
    }
  };

  static constexpr int most_tries = 64;  // of splits; there are exponentially many

  int corner_count() const { return static_cast<int>(part_->corners.size()); }

  /// An open part by the new edge between its ends, a closed one of three corners by a face.
  bool closes_with_an_edge() const {
    const std::vector<int>& v = part_->corners;
    if (!part_->closed) return mesh_.connectivity.has_edge(v.front(), v.back());
    return v.size() == 3 && mesh_.connectivity.find_face(v[0], v[1], v[2]) >= 0;
  }

  // --- seen along one direction -----------------------------------------------------------------

  /// Into a frame at the apex with z along the direction.
  void flatten() {
    flat_.clear();
    for (int corner : part_->corners) flat_.push_back(mesh_.position[corner] - part_->apex);
    const Vector3 z = direction(), x = z.unitOrthogonal(), y = z.cross(x);
    for (Vector3& p : flat_) p = Vector3(x.dot(p), y.dot(p), z.dot(p));
  }

  /// The average normal of the old faces; turned towards those that it does not see from above, as
  /// long as that helps.
  Vector3 direction() {
    constexpr int most_turns = 8;
    normal_.clear();
    Vector3 up = Vector3::Zero();
    for (std::size_t i = 0; i < part_->faces.size(); ++i) {
      normal_.push_back(flat_[i].cross(flat_[(i + 1) % flat_.size()]));
      up += normal_.back();
    }
    if (!(up.squaredNorm() > 0.0)) return Vector3::UnitZ();
    up.normalize();
    for (int turn = 0; turn < most_turns; ++turn) {
      const auto lowest =
          std::min_element(normal_.begin(), normal_.end(), [&](const Vector3& a, const Vector3& b) {
            return a.dot(up) * b.norm() < b.dot(up) * a.norm();
          });
      if (lowest->dot(up) > 0.0) break;
      const Vector3 turned = up + lowest->normalized();
      if (!(turned.squaredNorm() > 0.0)) break;
      up = turned.normalized();
    }
    return up;
  }

  /// Twice the signed area, in the plane, of the origin and two points.
  static double cross(const Vector3& a, const Vector3& b) { return a.x() * b.y() - a.y() * b.x(); }

  /// The signed area, in the plane, of the triangle from the apex to two corners, twice.
  double twice_area(int i, int j) const { return twice_area_[i * corner_count() + j]; }

  /// Every old face is seen from above, and together they go around the apex once.
  bool is_height_field() const {
    int turns = 0;
    for (std::size_t i = 0; i < part_->faces.size(); ++i) {
      const Vector3 &a = flat_[i], &b = flat_[(i + 1) % flat_.size()];
      if (!(cross(a, b) > 0.0)) return false;
      turns += part_->closed ? a.y() < 0.0 && b.y() >= 0.0 : i > 0 && !(cross(flat_[0], a) > 0.0);
    }
    return turns == part_->closed;
  }

  // --- split lines ------------------------------------------------------------------------------

  template <class Accept>
  bool triangulate(const Ring& ring, Accept& accept) {
    if (ring.size == 3) return add_triangle({ring[0], ring[1], ring[2]}, accept);
    const std::size_t triangles = triangles_.size();
    const Distance before = distance_;
    std::optional<Split> split;
    while (tries_++ < most_tries && (split = best_split(ring, split))) {
      distance_ = larger(before, split->distance);
      Ring between, beyond;
      for (int i = split->from; i <= split->to; ++i) between.push(ring[i]);
      for (int i = split->to; i <= split->from + ring.size; ++i) beyond.push(ring[i % ring.size]);
      if (triangulate(between, accept) && triangulate(beyond, accept)) return true;
      triangles_.resize(triangles);
      distance_ = before;
    }
    return false;
  }

  template <class Accept>
  bool add_triangle(LoopTriangle t, Accept& accept) {
    if (!(cross(flat_[t[1]] - flat_[t[0]], flat_[t[2]] - flat_[t[0]]) > 0.0)) return false;
    std::sort(t.begin(), t.end());  // a rotation
    if (!accept(t)) return false;
    triangles_.push_back(t);
    return true;
  }

  /// Every line between two corners that are not next to each other; parts of the loop have no
  /// others.
  void measure_diagonals() {
    const int n = corner_count();
    twice_area_.resize(n * n), diagonals_.resize(n * n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) twice_area_[i * n + j] = cross(flat_[i], flat_[j]);
    for (int i = 0; i + 2 < n; ++i)
      for (int j = i + 2; j < n - (i == 0); ++j)
        diagonals_[i * n + j] = diagonals_[j * n + i] = measured_diagonal(i, j);
  }

  Diagonal measured_diagonal(int i, int j) const {
    const Vector3 line = flat_[j] - flat_[i];
    const double flat2 = line.x() * line.x() + line.y() * line.y();
    return {below_edge(i, j), std::sqrt(flat2 * line.squaredNorm())};
  }

  const Diagonal& diagonal(int i, int j) const { return diagonals_[i * corner_count() + j]; }

  /// The best after another one, if given.
  std::optional<Split> best_split(const Ring& ring, const std::optional<Split>& after) const {
    std::optional<Split> best;
    for (int i = 0; i + 2 < ring.size; ++i)
      for (int j = i + 2; j < ring.size - (i == 0); ++j) {
        Split split{i, j, diagonal(ring[i], ring[j]).below, HUGE_VAL};
        if (best && !(split < *best)) continue;  // with any aspect ratio
        split.aspect_ratio = aspect_ratio_of(ring, i, j);
        if (!(split.aspect_ratio > 0.0) || split.aspect_ratio < least_aspect_ratio_) continue;
        if ((after && !(*after < split)) || (best && !(split < *best))) continue;
        if (!mesh_.connectivity.has_edge(part_->corners[ring[i]], part_->corners[ring[j]]))
          best = split;
      }
    return best;
  }

  /// The aspect ratio of a line between two corners; 0 where a corner is on the wrong side.
  double aspect_ratio_of(const Ring& ring, int from, int to) const {
    const int a = ring[from], b = ring[to];
    double least = HUGE_VAL;
    if (!stay_left(ring, from + 1, to, a, b, least) ||
        !stay_left(ring, to + 1, ring.size, b, a, least) || !stay_left(ring, 0, from, b, a, least))
      return 0.0;
    return least / diagonal(a, b).length2;
  }

  /// Whether some corners of the ring are on one side of a line; least: twice the area of their
  /// triangles with it.
  bool stay_left(const Ring& ring, int first, int last, int a, int b, double& least) const {
    const int n = corner_count();
    const double *to_a = &twice_area_[a * n], *to_b = &twice_area_[b * n];
    for (int i = first; i < last && least > 0.0; ++i)
      least = std::min(least, (to_a[ring[i]] - to_b[ring[i]]) + to_b[a]);
    return least > 0.0;
  }

  // --- distance to the old faces ----------------------------------------------------------------

  /// The distance of a new edge, where it crosses the old edges from the apex: those to
  /// the corners on its other side.
  Distance below_edge(int from, int to) const {
    const Vector3 &a = flat_[from], &b = flat_[to];
    const double side = twice_area(from, to);
    const int n = corner_count();
    const bool forward = side > 0.0;  // the corners across come after `from`, else after `to`
    const int first = forward ? from : to, last = forward ? to : from;
    const int end = last < first ? last + n : last;
    Distance largest{0.0, 0.0};
    for (int i = first + 1; i < end; ++i) {
      const Vector3& c = flat_[i % n];
      const double at_a = twice_area(i % n, from), at_b = twice_area(i % n, to);
      const double t = at_a / (at_a - at_b);  // along the new edge
      const double s = side / (at_b - at_a);  // along the old edge, from the apex
      const double gap = std::abs(a.z() + t * (b.z() - a.z()) - s * c.z());
      const double before = apex_error_ + s * (error_at(i % n) - apex_error_);
      largest = larger(largest, {gap, before + gap});
    }
    largest.step = significant(largest.step, (b - a).squaredNorm());
    return largest;
  }

  double error_at(int corner) const { return (*errors_)[part_->corners[corner]]; }

  /// The distance of the triangle that the apex lies over, or lies least outside of by rounding.
  Distance below_apex() const {
    double best = -HUGE_VAL, height = 0.0, length2 = 0.0;
    for (const auto& [i, j, k] : triangles_) {
      const Vector3 &a = flat_[i], &b = flat_[j], &c = flat_[k];
      const double wa = cross(b, c), wb = cross(c, a), wc = cross(a, b), all = wa + wb + wc;
      const double inside = std::min({wa, wb, wc}) / all;
      if (inside <= best) continue;
      best = inside;
      height = std::abs(wa * a.z() + wb * b.z() + wc * c.z()) / all;
      length2 = std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()});
    }
    return {significant(height, length2), apex_error_ + height};
  }

  const WorkingMesh& mesh_;
  const double least_aspect_ratio_;
  const LoopPart* part_ = nullptr;
  const std::vector<double>* errors_ = nullptr;
  double apex_error_ = 0.0;
  std::vector<Vector3> flat_;        // by corner; the apex is at the origin
  std::vector<Vector3> normal_;      // by face, not of unit length
  std::vector<double> twice_area_;   // by corner and corner
  std::vector<Diagonal> diagonals_;  // by corner and corner that is not next to it
  std::vector<LoopTriangle> triangles_;
  Distance distance_{};
  int tries_ = 0;
};

}  // namespace curvdecim::detail
