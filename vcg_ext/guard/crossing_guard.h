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
  /// A face before a change, and after it.
  struct Changed {
    PlacedFace was, now;

    bool is_same() const { return was.triangle == now.triangle; }

    /// True if it crosses the other afterwards, and did not before.
    bool newly_crosses(const Changed& o) const { return now.crosses(o.now) && !was.crosses(o.was); }
    bool newly_crosses(const PlacedFace& o) const { return now.crosses(o) && !was.crosses(o); }
  };

  /// What a collapse changes; reused from edge to edge.
  using Star = std::vector<Changed>;

  CrossingGuard(const WorkingMesh& mesh, const Parallel& parallel)
      : mesh_(mesh), parallel_(parallel) {
    rebuild();
  }

  /// May the edge collapse to x? `star` gets its faces.
  bool allows(const EdgeNeighborhood& around, const Vector3& x, Star& star) const {
    star.clear();
    for (int f : around.star())
      star.push_back({{f, mesh_.triangle(f)}, {f, triangle_after(mesh_, f, around.edge(), x)}});
    const auto [a, b] = around.edge();
    return !cross_each_other(star) && !crosses_any(star, [&, a = a, b = b](int f) {
      return mesh_.connectivity.face_has(f, a) || mesh_.connectivity.face_has(f, b);
    });
  }

  /// May face f, which is none now, be added with these corners?
  bool allows_face(int f, const Triangle& triangle) const {
    const PlacedFace now(f, triangle);
    return !any_near(now.box, [&](const PlacedFace& other) { return now.crosses(other); });
  }

  /// May these faces change so, others staying as they are?
  bool allows(const Star& changed) const {
    return !cross_each_other(changed) && !crosses_any(changed, [&](int f) {
      return std::any_of(changed.begin(), changed.end(),
                         [f](const Changed& c) { return c.now.face == f; });
    });
  }

  /// True if two changes that are allowed each by itself may not be made both.
  static bool are_in_conflict(const Star& a, const Star& b) {
    for (const Changed& of_a : a)
      for (const Changed& of_b : b)
        if (!of_a.is_same() && !of_b.is_same() && of_a.newly_crosses(of_b)) return true;
    return false;
  }

  /// The box around what changes.
  static Box box_of(const Star& star) {
    Box box;
    for (const Changed& changed : star)
      if (!changed.is_same()) box.add(changed.now.box);
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
  static bool cross_each_other(const Star& star) {
    for (std::size_t i = 0; i < star.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (!(star[i].is_same() && star[k].is_same()) && star[i].newly_crosses(star[k]))
          return true;
    return false;
  }

  /// is_among(f): the face changes, too, or goes.
  template <class IsAmong>
  bool crosses_any(const Star& changed, IsAmong is_among) const {
    return any_near(box_of(changed), [&](const PlacedFace& other) {
      if (is_among(other.face)) return false;
      return std::any_of(changed.begin(), changed.end(),
                         [&](const Changed& c) { return !c.is_same() && c.newly_crosses(other); });
    });
  }

  /// True if found(face) is for a face whose box meets this one.
  template <class Found>
  bool any_near(const Box& box, Found found) const {
    if (!boxes_) return false;
    return boxes_->tree().any_meeting(box, [&](int place) {
      const int f = *boxes_->faces_of(place).begin();
      return mesh_.connectivity.alive(f) && found(PlacedFace(f, mesh_.triangle(f)));
    });
  }

  const WorkingMesh& mesh_;
  const Parallel& parallel_;
  std::optional<SingleBoxes<WorkingMesh>> boxes_;  // of all numbers of faces; none where no face is
  std::vector<int> place_of_;                      // by face: in the boxes
  int faces_when_built_ = 0;                       // the boxes get worse as faces grow and go
};

}  // namespace curvdecim::detail
