// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <vector>

#include "vcg_ext/clustering/clusters.h"

namespace curvdecim::detail {

/// Chooses faces to drop until no edge has more than two, and keeps as many as it can: that with
/// the most crowded edges goes first, of equals the last; then what has room again comes back.
class ManifoldEdges {
 public:
  /// staying: faces that are there as well and are not dropped.
  ManifoldEdges(const std::vector<CellFace>& faces, const std::vector<Face>& staying)
      : edges_of_(faces.size()), kept_(faces.size(), true) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      edges_of_[f] = edges(faces[f].cells);
      for (int e : edges_of_[f]) faces_at_[e].push_back(static_cast<int>(f));
    }
    for (const Face& face : staying)
      for (int e : edges(face)) ++uses_[e];
    for (std::size_t e = 0; e < faces_at_.size(); ++e)
      uses_[e] += static_cast<int>(faces_at_[e].size());
  }

  /// By face: whether it is kept.
  std::vector<bool> run() {
    for (int f = 0; f < static_cast<int>(kept_.size()); ++f)
      if (crowded(f) > 0) queue_.insert({-crowded(f), -f});
    while (!queue_.empty()) {
      const int f = -std::get<1>(*queue_.begin());
      drop(f);
      dropped_.push_back(f);
    }
    for (int f : dropped_)
      if (has_room(f)) restore(f);
    return kept_;
  }

 private:
  static constexpr int most = 2;  // faces at an edge

  std::array<int, 3> edges(const Face& face) {
    std::array<int, 3> result;
    for (int i = 0; i < 3; ++i) {
      const int a = face[i], b = face[(i + 1) % 3];
      result[i] = seen_.number({std::min(a, b), std::max(a, b)});
    }
    faces_at_.resize(seen_.size()), uses_.resize(seen_.size(), 0);
    return result;
  }

  int crowded(int f) const {
    const auto& edges = edges_of_[f];
    return static_cast<int>(
        std::count_if(edges.begin(), edges.end(), [&](int e) { return uses_[e] > most; }));
  }

  bool has_room(int f) const {
    const auto& edges = edges_of_[f];
    return std::all_of(edges.begin(), edges.end(), [&](int e) { return uses_[e] < most; });
  }

  void drop(int f) {
    queue_.erase({-crowded(f), -f});
    kept_[f] = false;
    for (int e : edges_of_[f])
      if (uses_[e]-- == most + 1)  // no longer crowded, for all its faces
        for (int g : faces_at_[e]) requeue(g);
  }

  void requeue(int f) {
    if (!kept_[f]) return;
    queue_.erase({-crowded(f) - 1, -f});
    if (crowded(f) > 0) queue_.insert({-crowded(f), -f});
  }

  void restore(int f) {
    kept_[f] = true;
    for (int e : edges_of_[f]) ++uses_[e];
  }

  FirstSeen<std::array<int, 2>> seen_;
  std::vector<std::array<int, 3>> edges_of_;  // by face
  std::vector<std::vector<int>> faces_at_;    // by edge
  std::vector<int> uses_;                     // by edge: faces that are there
  std::vector<bool> kept_;                    // by face
  std::set<std::tuple<int, int>> queue_;      // of the faces at crowded edges: -edges, -face
  std::vector<int> dropped_;                  // in this order
};

}  // namespace curvdecim::detail
