// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "vcg_ext/mesh/crossings.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/face_boxes.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// Keeps faces from crossing others: a change is refused after which two faces cross that do not
/// now. It holds boxes around all faces, and has to be told of every change. Questions may be asked
/// at the same time.
class CrossingGuard {
 public:
  /// What a change makes of the faces that are others afterwards; reused from edge to edge.
  class Star {
   public:
    void clear() { faces_.clear(), boxes_.clear(), box_ = {}; }

    void add(int f, const Triangle& now) {
      const std::size_t lane = faces_.size() % FourBoxes::count;
      if (lane == 0) boxes_.emplace_back();
      const Box box = box_around(now);
      boxes_.back().set(static_cast<int>(lane), box), box_.add(box);
      faces_.emplace_back(f, now);
    }

    const std::vector<PlacedFace>& faces() const { return faces_; }
    /// Around all.
    const Box& box() const { return box_; }

    bool has(int f) const {
      return std::any_of(faces_.begin(), faces_.end(),
                         [f](const PlacedFace& face) { return face.face == f; });
    }

    /// True if found(face) is for one that may meet a box.
    template <class Found>
    bool any_meeting(const FourBoxes::Place& box, Found found) const {
      for (std::size_t four = 0; four < boxes_.size(); ++four) {
        const auto meets = boxes_[four].meets(box);
        for (int i = 0; i < FourBoxes::count; ++i)
          if (meets[i] != 0 && found(faces_[FourBoxes::count * four + i])) return true;
      }
      return false;
    }

   private:
    std::vector<PlacedFace> faces_;
    std::vector<FourBoxes> boxes_;  // of four faces each
    Box box_;
  };

  CrossingGuard(const WorkingMesh& mesh, const Parallel& parallel)
      : mesh_(mesh), parallel_(parallel) {
    rebuild();
  }

  /// May the edge collapse to x? after: the planes that its star would have. is_disk: the star
  /// would be a disk. `star` gets what changes.
  bool allows(const EdgeNeighborhood& around, const Vector3& x, const std::vector<FacePlane>& after,
              bool is_disk, Star& star) const {
    const auto [a, b] = around.edge();
    star.clear();
    for (std::size_t i = 0; i < around.star().size(); ++i)
      if (mesh_.position[i < around.star_of_a() ? a : b] != x)
        star.add(around.star()[i], triangle_after(mesh_, around.star()[i], {a, b}, x));
    const auto changes = [&, a = a, b = b](int f) {
      return mesh_.connectivity.face_has(f, a) || mesh_.connectivity.face_has(f, b);
    };
    if (crosses_any(star, changes)) return false;
    if (is_disk && is_seen_as_disk(around, x, after)) return true;
    return !cross_each_other(star) && !crosses_rest(around, x, star);
  }

  /// May face f, which is none now, be added with these corners?
  bool allows_face(int f, const Triangle& triangle) const {
    Star added;
    added.add(f, triangle);
    return !crosses_any(added, [f](int other) { return other == f; });
  }

  /// May these faces change so, others staying as they are?
  bool allows(const Star& changed) const {
    return !cross_each_other(changed) &&
           !crosses_any(changed, [&](int f) { return changed.has(f); });
  }

  /// True if two changes that are allowed each by itself may not be made both.
  bool are_in_conflict(const Star& a, const Star& b) const {
    for (const PlacedFace& of_a : a.faces()) {
      const FourBoxes::Place place(box_around(of_a.triangle));
      if (b.any_meeting(place, [&](const PlacedFace& of_b) { return newly_cross(of_a, of_b); }))
        return true;
    }
    return false;
  }

  /// To be told of a face that has changed or is new.
  void update(int f) { boxes_->refit(place_of_[f]); }

  /// To be told of a vertex whose faces have changed.
  void update_around(int v) {
    for (int f : mesh_.connectivity.faces_of(v)) update(f);
    if (2 * mesh_.connectivity.face_count() < faces_when_built_) rebuild();
  }

  /// To be told where faces have other numbers, or all have changed.
  void rebuild() {
    boxes_.reset(), place_of_.clear();
    faces_when_built_ = mesh_.connectivity.face_count();
    if (faces_when_built_ == 0) return;
    boxes_.emplace(mesh_, mesh_.connectivity.face_slots(), parallel_);
    place_of_.resize(mesh_.connectivity.face_slots());
    parallel_.for_each(boxes_->face_count(),
                       [&](int place) { place_of_[*boxes_->faces_of(place).begin()] = place; });
  }

 private:
  /// The cosine from which a face is clearly seen from the front.
  static constexpr double clearly = 0.1;

  /// Whether the faces cross so, and not as they are now. g is a face already.
  bool newly_cross(const PlacedFace& f, const PlacedFace& g) const {
    if (!f.crosses(g)) return false;
    const bool is_new = !mesh_.connectivity.alive(f.face);
    return is_new || !faces_cross(f.face, mesh_.triangle(f.face), g.face, mesh_.triangle(g.face));
  }

  bool cross_each_other(const Star& star) const {
    const std::vector<PlacedFace>& faces = star.faces();
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (newly_cross(faces[i], faces[k])) return true;
    return false;
  }

  /// True if what changes crosses faces of the edge's star that stay as they are.
  bool crosses_rest(const EdgeNeighborhood& around, const Vector3& x, const Star& star) const {
    const auto [a, b] = around.edge();
    for (std::size_t i = 0; i < around.star().size(); ++i) {
      if (mesh_.position[i < around.star_of_a() ? a : b] != x) continue;
      const PlacedFace rest(around.star()[i], mesh_.triangle(around.star()[i]));
      for (const PlacedFace& face : star.faces())
        if (newly_cross(face, rest)) return true;
    }
    return false;
  }

  /// True if, from somewhere, the whole star is clearly seen from the front, and goes round the
  /// vertex once: then no two of its faces cross. The ring is a closed path, since it is a disk.
  bool is_seen_as_disk(const EdgeNeighborhood& around, const Vector3& x,
                       const std::vector<FacePlane>& after) const {
    Vector3 up = Vector3::Zero();
    for (const FacePlane& plane : after) up += plane.area_vector();
    up.normalize();
    for (const FacePlane& plane : after)
      if (!(plane.normal.dot(up) > clearly)) return false;
    const Vector3 along = up.unitOrthogonal();
    const auto is_ahead = [&](int v) { return along.dot(mesh_.position[v] - x) > 0.0; };
    int rounds = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      const auto [a, b] = around.edge();
      const int f = around.star()[i], end = i < around.star_of_a() ? a : b;
      const int u = mesh_.connectivity.next_vertex(f, end);
      rounds += !is_ahead(u) && is_ahead(mesh_.connectivity.third_vertex(f, end, u));
    }
    return rounds == 1;
  }

  /// True if what changes crosses another face. changes(f): the face changes, too, or goes.
  template <class Changes>
  bool crosses_any(const Star& star, Changes changes) const {
    if (!boxes_) return false;
    const BoxTree& tree = boxes_->tree();
    return tree.any_meeting(star.box(), [&](int place) {
      const int f = *boxes_->faces_of(place).begin();
      if (!mesh_.connectivity.alive(f) || changes(f)) return false;
      std::optional<PlacedFace> other;
      return star.any_meeting(tree.place_of(place), [&](const PlacedFace& face) {
        if (!other) other.emplace(f, mesh_.triangle(f));
        return newly_cross(face, *other);
      });
    });
  }

  const WorkingMesh& mesh_;
  const Parallel& parallel_;
  std::optional<SingleBoxes<WorkingMesh>> boxes_;  // of all numbers of faces; none where no face is
  std::vector<int> place_of_;                      // by face: in the boxes
  int faces_when_built_ = 0;                       // the boxes get worse as faces grow and go
};

}  // namespace curvdecim::detail
