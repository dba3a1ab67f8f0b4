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
  using Star = std::vector<PlacedFace>;

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
        star.emplace_back(around.star()[i], triangle_after(mesh_, around.star()[i], {a, b}, x));
    const auto changes = [&, a = a, b = b](int f) {
      return mesh_.connectivity.face_has(f, a) || mesh_.connectivity.face_has(f, b);
    };
    if (crosses_any(star, changes)) return false;
    if (is_disk && is_seen_as_disk(around, x, after)) return true;
    return !cross_each_other(star) && !crosses_rest(around, x, star);
  }

  /// May face f, which is none now, be added with these corners?
  bool allows_face(int f, const Triangle& triangle) const {
    const PlacedFace now(f, triangle);
    const auto is_left_out = [](int) { return false; };
    return !any_near(now.box, is_left_out,
                     [&](const PlacedFace& other) { return now.crosses(other); });
  }

  /// May these faces change so, others staying as they are?
  bool allows(const Star& changed) const {
    return !cross_each_other(changed) && !crosses_any(changed, [&](int f) {
      return std::any_of(changed.begin(), changed.end(),
                         [f](const PlacedFace& c) { return c.face == f; });
    });
  }

  /// True if two changes that are allowed each by itself may not be made both.
  bool are_in_conflict(const Star& a, const Star& b) const {
    for (const PlacedFace& of_a : a)
      for (const PlacedFace& of_b : b)
        if (newly_cross(of_a, of_b)) return true;
    return false;
  }

  /// The box around what changes.
  static Box box_of(const Star& star) {
    Box box;
    for (const PlacedFace& face : star) box.add(face.box);
    return box;
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

  /// Whether the faces cross so, and not as they are now.
  bool newly_cross(const PlacedFace& f, const PlacedFace& g) const {
    return f.crosses(g) &&
           !faces_cross(f.face, mesh_.triangle(f.face), g.face, mesh_.triangle(g.face));
  }

  bool cross_each_other(const Star& star) const {
    for (std::size_t i = 0; i < star.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (newly_cross(star[i], star[k])) return true;
    return false;
  }

  /// True if what changes crosses faces of the edge's star that stay as they are.
  bool crosses_rest(const EdgeNeighborhood& around, const Vector3& x, const Star& star) const {
    const auto [a, b] = around.edge();
    for (std::size_t i = 0; i < around.star().size(); ++i) {
      if (mesh_.position[i < around.star_of_a() ? a : b] != x) continue;
      const PlacedFace rest(around.star()[i], mesh_.triangle(around.star()[i]));
      for (const PlacedFace& face : star)
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

  /// changes(f): the face changes, too, or goes.
  template <class Changes>
  bool crosses_any(const Star& changed, Changes changes) const {
    return any_near(box_of(changed), changes, [&](const PlacedFace& other) {
      return std::any_of(changed.begin(), changed.end(),
                         [&](const PlacedFace& face) { return newly_cross(face, other); });
    });
  }

  /// True if found(face) is for a face that may meet the box, save those left out.
  template <class LeftOut, class Found>
  bool any_near(const Box& box, LeftOut left_out, Found found) const {
    if (!boxes_) return false;
    return boxes_->tree().any_meeting(box, [&](int place) {
      const int f = *boxes_->faces_of(place).begin();
      return mesh_.connectivity.alive(f) && !left_out(f) && found(PlacedFace(f, mesh_.triangle(f)));
    });
  }

  const WorkingMesh& mesh_;
  const Parallel& parallel_;
  std::optional<SingleBoxes<WorkingMesh>> boxes_;  // of all numbers of faces; none where no face is
  std::vector<int> place_of_;                      // by face: in the boxes
  int faces_when_built_ = 0;                       // the boxes get worse as faces grow and go
};

}  // namespace curvdecim::detail
