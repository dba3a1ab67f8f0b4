// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/convex_polygon.h"
#include "vcg_ext/guard/reference_surface.h"

namespace curvdecim::detail {

/// A point over a triangle: two of its barycentric coordinates and its height.
class PlaceOverFace {
 public:
  explicit PlaceOverFace(const Triangle& t) : origin_(t[0]) {
    const Vector3 ab = t[1] - t[0], ac = t[2] - t[0], normal = ab.cross(ac);
    const double scale = normal.squaredNorm();
    flat_ = !(scale > least_quality * sum_of_squared_edges(t) * sum_of_squared_edges(t));
    if (flat_) return;
    to_b_ = ac.cross(normal) / scale, to_c_ = normal.cross(ab) / scale;
    up_ = normal / std::sqrt(scale);
  }

  /// No coordinates exist.
  bool flat() const { return flat_; }

  Vector3 operator()(const Vector3& p) const {
    const Vector3 from = p - origin_;
    return {to_b_.dot(from), to_c_.dot(from), up_.dot(from)};
  }

  /// Barycentric coordinate i of a place.
  static double weight(const Vector3& place, int i) {
    return i == 0 ? 1.0 - place[0] - place[1] : place[i - 1];
  }

 private:
  static constexpr double least_quality = 1e-12;  // squared: coordinates lose six digits

  Vector3 origin_, to_b_, to_c_, up_;
  bool flat_;
};

/// The sheet of the reference over a face: its faces that look the same way and can be reached from
/// one of them without leaving the prism over the face, or going higher than a limit. Over the face
/// the sheet ends only where edges of such faces say so. What these leave of the face in one piece
/// is all below the sheet, or nothing of it is; what lies between them and its sides is not told.
class SheetOverFace {
 public:
  struct Result {
    double height = 0.0;             ///< of the sheet, the largest
    std::array<double, 3> untold{};  ///< where barycentric coordinate i is less: not told
  };

  explicit SheetOverFace(const ReferenceSurface& reference)
      : reference_(reference), seen_(reference.size(), 0) {}

  /// nullopt: there is no sheet over the middle part of the face. Calls lies_over(r, height) with
  /// faces of the reference that lie over nothing but the face, whatever the answer is. start: a
  /// face of the reference over it.
  template <class LiesOver>
  std::optional<Result> find(const Triangle& face, int start, double limit, LiesOver lies_over) {
    const PlaceOverFace place(face);
    if (place.flat()) return std::nullopt;
    const double slack = margin * std::sqrt(sum_of_squared_edges(face));
    Result result;
    middles_.clear();
    begin(start);
    for (double side = 0.0; !waiting_.empty();) {  // 1: up, -1: down
      const int r = waiting_.back();
      waiting_.pop_back();
      const Piece corners(reference_.triangle(r), place);
      const Piece piece = corners.inside();
      const double height = piece.height() + slack, area = piece.area();
      if (height <= limit && corners.lies_over()) lies_over(r, height);
      if (side == 0.0) side = area > 0.0 ? 1.0 : -1.0;
      if (height > limit || !(side * area > 0.0)) {
        end_at(corners, result);
        continue;
      }
      spread(r, corners, result);
      result.height = std::max(result.height, height);
      middles_.push_back(piece.middle());
    }
    if (!is_told_somewhere(result)) return std::nullopt;
    return result;
  }

 private:
  static constexpr double margin = 1e-9;  // of the face, in which the sheet may end

  /// Part of a face of the reference, in places over the face.
  class Piece {
   public:
    Piece(const Triangle& t, const PlaceOverFace& place) {
      for (const Vector3& p : t) add(place(p));
    }

    const Vector3& operator[](int i) const { return corner_[i]; }

    double height() const {
      double largest = 0.0;
      for (int i = 0; i < size_; ++i) largest = std::max(largest, std::abs(corner_[i].z()));
      return largest;
    }

    /// Signed, of the face's.
    double area() const {
      double sum = 0.0;
      for (int i = 2; i < size_; ++i) {
        const Vector3 p = corner_[i - 1] - corner_[0], q = corner_[i] - corner_[0];
        sum += p.x() * q.y() - p.y() * q.x();
      }
      return sum;
    }

    Vector3 middle() const {
      Vector3 sum = Vector3::Zero();
      for (int i = 0; i < size_; ++i) sum += corner_[i];
      return sum / size_;
    }

    /// All of it lies over the face.
    bool lies_over() const {
      for (int i = 0; i < size_; ++i)
        for (int k = 0; k < 3; ++k)
          if (PlaceOverFace::weight(corner_[i], k) < -margin) return false;
      return true;
    }

    Piece inside() const { return inside(0).inside(1).inside(2); }

   private:
    Piece() = default;

    void add(const Vector3& place) { corner_[size_++] = place; }

    Piece inside(int k) const {
      Piece part;
      clip(
          corner_.data(), size_, [&](const Vector3& p) { return PlaceOverFace::weight(p, k); },
          [&](const Vector3& p) { part.add(p); });
      return part;
    }

    std::array<Vector3, 6> corner_;  // three cuts of a triangle
    int size_ = 0;
  };

  using Segment = std::pair<Vector3, Vector3>;

  void begin(int start) {
    ++search_;
    waiting_.assign(1, start);
    seen_[start] = search_;
  }

  /// To the faces across edges that run over the face.
  void spread(int r, const Piece& corners, Result& result) {
    for (int i = 0; i < 3; ++i) {
      const auto over = part_over(corners[i], corners[(i + 1) % 3]);
      if (!over) continue;
      const int next = reference_.across(r, i);
      if (next == ReferenceSurface::none) {
        end_at(*over, result);
      } else if (seen_[next] != search_) {
        seen_[next] = search_;
        waiting_.push_back(next);
      }
    }
  }

  static void end_at(const Piece& corners, Result& result) {
    for (int i = 0; i < 3; ++i)
      if (const auto over = part_over(corners[i], corners[(i + 1) % 3])) end_at(*over, result);
  }

  /// What lies between the segment and a side of the face, that where this is least, is not told.
  static void end_at(const Segment& segment, Result& result) {
    int side = 0;
    double least = HUGE_VAL;
    for (int k = 0; k < 3; ++k) {
      const double depth = std::max(PlaceOverFace::weight(segment.first, k),
                                    PlaceOverFace::weight(segment.second, k));
      if (depth < least) least = depth, side = k;
    }
    result.untold[side] = std::max(result.untold[side], least + margin);
  }

  /// The part of an edge over the face, further inside than its margin.
  static std::optional<Segment> part_over(const Vector3& p, const Vector3& q) {
    double from = 0.0, to = 1.0;
    for (int k = 0; k < 3; ++k) {
      const double at_p = PlaceOverFace::weight(p, k) - margin;
      const double at_q = PlaceOverFace::weight(q, k) - margin;
      if (at_p <= 0.0 && at_q <= 0.0) return std::nullopt;
      if (at_p < 0.0) from = std::max(from, at_p / (at_p - at_q));
      if (at_q < 0.0) to = std::min(to, at_p / (at_p - at_q));
    }
    if (!(from < to)) return std::nullopt;
    return Segment{p + from * (q - p), p + to * (q - p)};
  }

  /// The sheet is over a point of what the untold sides leave, so that it is over all of it.
  bool is_told_somewhere(const Result& result) const {
    return std::any_of(middles_.begin(), middles_.end(), [&](const Vector3& middle) {
      for (int k = 0; k < 3; ++k)
        if (PlaceOverFace::weight(middle, k) <= result.untold[k]) return false;
      return true;
    });
  }

  const ReferenceSurface& reference_;
  std::vector<int> seen_;  // by face of the reference: the last search that came to it
  int search_ = 0;
  std::vector<int> waiting_;
  std::vector<Vector3> middles_;  // of the sheet's parts over the face
};

}  // namespace curvdecim::detail
