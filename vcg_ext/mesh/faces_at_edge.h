// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <vector>

#include "vcg_ext/geometry/vector3.h"

namespace curvdecim::detail {

/// A face at an edge from a to b.
struct FaceAtEdge {
  int id;           // whatever names it
  bool forward;     // it runs from a to b
  Vector3 third;    // its other corner
  double turn = 0;  // around the edge, from the first face
};

/// Which of the faces at an edge belong together: two with a piece of material between them, which
/// lies behind a face, two with air between them, the two that are flattest, or none.
enum class Pairing { Material, Air, Flattest, Alone };

/// Pairs the faces at an edge. Closed parts that touch along it have four faces there or more, and
/// as one goes around it, material and air take turns: a face that runs backward has material
/// behind it, and the next one forward ends it. Reused from edge to edge.
class FacesAtEdge {
 public:
  using Pair = std::array<int, 2>;  // ids

  void clear() { faces_.clear(), pairs_.clear(); }
  void add(const FaceAtEdge& face) { faces_.push_back(face); }

  /// False where material and air are asked for and the faces do not come in such pairs: their
  /// number is odd, one is degenerate, or they do not take turns. Two need no angle.
  bool pair(const Vector3& a, const Vector3& b, Pairing pairing = Pairing::Material) {
    pairs_.clear();
    if (pairing == Pairing::Alone) return true;
    if (pairing == Pairing::Flattest) return pair_flattest(a, b), true;
    return pair_turns(a, b, pairing);
  }

  /// Flattest ones that are left over are in none.
  const std::vector<Pair>& pairs() const { return pairs_; }

 private:
  /// An angle in turns of 4. Coincident faces that are cut differently differ by the rounding
  /// of their coordinates, which may be single.
  static constexpr double same_turn = 1e-4;
  /// The sine of an angle below which a face has no side to lie on.
  static constexpr double least_sine = 1e-6;

  bool pair_turns(const Vector3& a, const Vector3& b, Pairing pairing) {
    const std::size_t count = faces_.size();
    const auto forward = std::count_if(faces_.begin(), faces_.end(),
                                       [](const FaceAtEdge& face) { return face.forward; });
    if (2 * static_cast<std::size_t>(forward) != count) return false;
    if (count > 2 && !(measure(a, b) && sort())) return false;
    for (std::size_t i = 0; i < count; ++i)
      if (faces_[i].forward == (pairing == Pairing::Air))
        pairs_.push_back({faces_[i].id, faces_[(i + 1) % count].id});
    return true;
  }

  /// Two that run alike are no pair: the surface would be turned over there.
  void pair_flattest(const Vector3& a, const Vector3& b) {
    const auto direction = [&](const FaceAtEdge& face) {
      const auto radius = away(b - a, face.third - a);
      return radius ? radius->normalized() : Vector3(Vector3::Zero());
    };
    std::vector<std::tuple<double, std::size_t, std::size_t>> options;
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (std::size_t j = i + 1; j < faces_.size(); ++j)
        if (faces_[i].forward != faces_[j].forward)
          options.push_back({direction(faces_[i]).dot(direction(faces_[j])), i, j});
    std::sort(options.begin(), options.end());
    std::vector<bool> is_paired(faces_.size(), false);
    for (const auto& [cosine, i, j] : options) {
      if (is_paired[i] || is_paired[j]) continue;
      is_paired[i] = is_paired[j] = true;
      pairs_.push_back({faces_[i].id, faces_[j].id});
    }
  }

  /// Grows with the angle of (x, y) from 0 to 4; without a function whose last bit differs by
  /// machine.
  static double turn_of(double x, double y) {
    const double part = y / (std::abs(x) + std::abs(y));
    if (x < 0.0) return 2.0 - part;
    return y < 0.0 ? 4.0 + part : part;
  }

  /// From the edge's line to a corner; nullopt: a face is degenerate.
  static std::optional<Vector3> away(const Vector3& along, const Vector3& corner) {
    const double length2 = along.squaredNorm();
    if (!(length2 > 0.0)) return std::nullopt;
    const Vector3 radius = corner - along * (along.dot(corner) / length2);
    if (!(radius.norm() > least_sine * corner.norm())) return std::nullopt;
    return radius;
  }

  bool measure(const Vector3& a, const Vector3& b) {
    const Vector3 along = b - a;
    const auto first = away(along, faces_[0].third - a);
    if (!first) return false;
    const Vector3 x = first->normalized(), y = along.cross(x).normalized();
    for (FaceAtEdge& face : faces_) {
      const auto radius = away(along, face.third - a);
      if (!radius) return false;
      face.turn = turn_of(x.dot(*radius), y.dot(*radius));
      if (face.turn > 4.0 - same_turn) face.turn -= 4.0;
    }
    return true;
  }

  using Iterator = std::vector<FaceAtEdge>::iterator;

  /// The end of the faces that lie where the first one does.
  Iterator end_of_place(Iterator first) {
    const auto is_elsewhere = [](const FaceAtEdge& f, const FaceAtEdge& g) {
      return std::abs(g.turn - f.turn) > same_turn;
    };
    const auto last = std::adjacent_find(first, faces_.end(), is_elsewhere);
    return last == faces_.end() ? last : last + 1;
  }

  /// A face that no other lies on goes first, if there is one.
  void begin_with_a_lone_face() {
    for (auto first = faces_.begin(); first != faces_.end();) {
      const auto last = end_of_place(first);
      if (last - first == 1) {
        std::rotate(faces_.begin(), first, faces_.end());
        return;
      }
      first = last;
    }
  }

  /// Faces in one place run forward and backward by turns, as long as there are such.
  static void take_turns(Iterator first, Iterator last, bool forward) {
    for (; first != last; ++first, forward = !forward) {
      const auto next = std::find_if(
          first, last, [&](const FaceAtEdge& face) { return face.forward == forward; });
      if (next == last) return;
      std::rotate(first, next, next + 1);
    }
  }

  /// Two faces in one place part two pieces of material, or in the air they are a fin, as what lies
  /// before them tells.
  void arrange() {
    begin_with_a_lone_face();
    const bool is_lone = end_of_place(faces_.begin()) - faces_.begin() == 1;
    bool forward = is_lone ? faces_[0].forward : true;  // the next one should be
    for (auto first = faces_.begin(); first != faces_.end();) {
      const auto last = end_of_place(first);
      take_turns(first, last, forward);
      forward = !(last - 1)->forward;
      first = last;
    }
  }

  /// Around the edge. False where material and air do not take turns, or a face doubles another.
  bool sort() {
    std::sort(faces_.begin(), faces_.end(), [](const FaceAtEdge& f, const FaceAtEdge& g) {
      return std::tie(f.turn, f.forward, f.id) < std::tie(g.turn, g.forward, g.id);
    });
    const auto are_doubles = [](const FaceAtEdge& f, const FaceAtEdge& g) {
      return f.forward == g.forward && f.third == g.third;
    };
    if (std::adjacent_find(faces_.begin(), faces_.end(), are_doubles) != faces_.end()) return false;
    arrange();
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (faces_[i].forward == faces_[(i + 1) % faces_.size()].forward) return false;
    return true;
  }

  std::vector<FaceAtEdge> faces_;
  std::vector<Pair> pairs_;
};

}  // namespace curvdecim::detail
