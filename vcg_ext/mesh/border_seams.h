// SPDX-License-Identifier: GPL-3.0-or-later
// Borders that lie on each other, as of files that list every face with vertices of its own.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/disjoint_sets.h"
#include "vcg_ext/mesh/faces_at_edge.h"
#include "vcg_ext/mesh/sheets.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// A side of a face, as an edge between two numbers.
struct FaceSide {
  int low, high;  // whatever names its ends
  int face, corner;
  bool forward;  // it runs from low to high

  bool operator<(const FaceSide& o) const {
    return std::tie(low, high, face, corner) < std::tie(o.low, o.high, o.face, o.corner);
  }
};

/// Finds the border edges that lie on each other and joins their ends. Vertices that are not locked
/// and lie in one place are a site. Edges between the same two sites are a seam where as many run
/// one way as the other; of more than two, those belong together that bound one piece of material.
class BorderSeams {
 public:
  BorderSeams(const WorkingMesh& mesh, const Parallel& parallel)
      : mesh_(mesh), parallel_(parallel) {}

  /// The mesh with the borders joined; the first vertex of a site that is joined stands for the
  /// others. No faces: there is nothing to join.
  Revertexed join() {
    find_sites();
    if (sites_ == 0) return {};
    find_seams();
    if (seams_.empty()) return {};
    unite();
    return joined() > 0 ? result() : Revertexed();
  }

  /// Pairs of border edges that were joined.
  int joined() const {
    return static_cast<int>(std::count_if(seams_.begin(), seams_.end(),
                                          [&](const Seam& seam) { return is_joined(seam); }));
  }

 private:
  static constexpr int none = -1;

  /// Two border edges: the vertices of both at its ends.
  struct Seam {
    std::array<int, 2> low, high;
  };

  int vertices() const { return static_cast<int>(mesh_.position.size()); }

  // --- sites ------------------------------------------------------------------------------------

  struct Place {
    std::array<double, 3> at;
    int vertex;

    bool operator<(const Place& o) const { return std::tie(at, vertex) < std::tie(o.at, o.vertex); }
  };

  /// The vertices that a border may pass. A zero has no sign here.
  std::vector<Place> places() const {
    std::vector<Place> places;
    for (int v = 0; v < vertices(); ++v) {
      if (mesh_.kind[v] == VertexKind::Interior || mesh_.locked[v]) continue;
      const Vector3& p = mesh_.position[v];
      places.push_back({{p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}, v});
    }
    parallel_.sort(places.begin(), places.end());
    return places;
  }

  void find_sites() {
    site_.assign(vertices(), none);
    const std::vector<Place> all = places();
    for (std::size_t first = 0, last; first < all.size(); first = last) {
      last = first + 1;
      while (last < all.size() && all[last].at == all[first].at) ++last;
      for (std::size_t i = first; i < last; ++i) site_[all[i].vertex] = sites_;
      ++sites_;
    }
    given_up_.assign(sites_, false);
  }

  // --- sides ------------------------------------------------------------------------------------

  int end_of(const FaceSide& side, int place) const {
    return mesh_.connectivity.face(side.face)[(side.corner + place) % 3];
  }
  int low_of(const FaceSide& side) const { return end_of(side, side.forward ? 0 : 1); }
  int high_of(const FaceSide& side) const { return end_of(side, side.forward ? 1 : 0); }

  /// The sides of all faces, if wanted(a, b), in the order of their edges; name(v) names the ends.
  template <class Wanted, class Name>
  std::vector<FaceSide> sides(Wanted wanted, Name name) const {
    std::vector<FaceSide> sides;
    for (int f = 0; f < mesh_.connectivity.face_slots(); ++f)
      for (int i = 0; i < 3; ++i) {
        const int a = mesh_.connectivity.face(f)[i], b = mesh_.connectivity.face(f)[(i + 1) % 3];
        if (!wanted(a, b)) continue;
        const auto [low, high] = std::minmax({name(a), name(b)});
        sides.push_back({low, high, f, i, low == name(a)});
      }
    parallel_.sort(sides.begin(), sides.end());
    return sides;
  }

  /// use(first, last) for the sides of every edge.
  template <class Use>
  static void for_edges(const std::vector<FaceSide>& sides, Use use) {
    for (auto first = sides.begin(), last = first; first != sides.end(); first = last) {
      while (last != sides.end() && last->low == first->low && last->high == first->high) ++last;
      use(first, last);
    }
  }

  using Side = std::vector<FaceSide>::const_iterator;

  /// The pairs among the sides of an edge are in at_edge_ then, by place.
  bool pair(Side first, Side last) {
    at_edge_.clear();
    for (Side side = first; side != last; ++side)
      at_edge_.add(
          {static_cast<int>(side - first), side->forward, mesh_.position[end_of(*side, 2)]});
    return at_edge_.pair(mesh_.position[low_of(*first)], mesh_.position[high_of(*first)]);
  }

  // --- seams ------------------------------------------------------------------------------------

  bool is_border(int a, int b) const {
    if (site_[a] == none || site_[b] == none || site_[a] == site_[b]) return false;
    return is_boundary_edge(mesh_.connectivity, a, b);
  }

  void find_seams() {
    const auto borders =
        sides([&](int a, int b) { return is_border(a, b); }, [&](int v) { return site_[v]; });
    for_edges(borders, [&](Side first, Side last) {
      if (last - first < 2 || !pair(first, last)) return;
      for (const auto& [f, g] : at_edge_.pairs()) add_seam(first[f], first[g]);
    });
  }

  void add_seam(const FaceSide& f, const FaceSide& g) {
    seams_.push_back({{low_of(f), low_of(g)}, {high_of(f), high_of(g)}});
  }

  bool is_joined(const Seam& seam) const {
    return !given_up_[site_[seam.low[0]]] && !given_up_[site_[seam.high[0]]];
  }

  // --- joining ----------------------------------------------------------------------------------

  /// A site stays as it is whose joining would spoil a face or an edge; that may spoil others.
  void unite() {
    constexpr int most_rounds = 64;  // each gives up a site; there are few
    for (int round = 0; round < most_rounds; ++round) {
      vertex_.reset(vertices());
      for (const Seam& seam : seams_)
        if (is_joined(seam))
          for (const auto& [v, w] : {seam.low, seam.high}) vertex_.unite(v, w);
      mark_changed();
      if (!give_up_at_faces() && !give_up_at_edges()) return;
    }
    given_up_.assign(sites_, true);
  }

  void mark_changed() {
    changed_.assign(vertices(), false);
    for (int v = 0; v < vertices(); ++v)
      if (const int root = vertex_.root(v); root != v) changed_[v] = changed_[root] = true;
  }

  void give_up_at(int v) {
    if (changed_[v]) given_up_[site_[v]] = true;
  }

  /// Gives up where a face would have a vertex twice.
  bool give_up_at_faces() {
    bool any = false;
    for (int f = 0; f < mesh_.connectivity.face_slots(); ++f)
      for (int i = 0; i < 3; ++i) {
        const int a = mesh_.connectivity.face(f)[i], b = mesh_.connectivity.face(f)[(i + 1) % 3];
        if (vertex_.root(a) != vertex_.root(b)) continue;
        give_up_at(a);
        any = true;
      }
    return any;
  }

  /// Gives up where edges become one and their faces do not come in pairs.
  bool give_up_at_edges() {
    bool any = false;
    const auto all = sides([&](int a, int b) { return changed_[a] || changed_[b]; },
                           [&](int v) { return vertex_.root(v); });
    for_edges(all, [&](Side first, Side last) {
      const auto is_as_it_was = [&](const FaceSide& side) {
        return low_of(side) == low_of(*first) && high_of(side) == high_of(*first);
      };
      if (std::all_of(first, last, is_as_it_was) || pair(first, last)) return;
      give_up_at(low_of(*first)), give_up_at(high_of(*first));
      any = true;
    });
    return any;
  }

  Revertexed result() {
    Revertexed result;
    std::vector<int> number(vertices());
    for (int v = 0; v < vertices(); ++v) {
      const int root = vertex_.root(v);  // the least: its number is known
      number[v] = root == v ? static_cast<int>(result.old_of.size()) : number[root];
      if (root == v) result.old_of.push_back(v);
    }
    for (int f = 0; f < mesh_.connectivity.face_slots(); ++f) {
      const auto [a, b, c] = mesh_.connectivity.face(f);
      result.faces.push_back({number[a], number[b], number[c]});
    }
    return result;
  }

  const WorkingMesh& mesh_;
  const Parallel& parallel_;
  int sites_ = 0;
  std::vector<int> site_;       // by vertex; none: alone in its place, inside, or locked
  std::vector<bool> given_up_;  // by site
  FacesAtEdge at_edge_;
  std::vector<Seam> seams_;
  DisjointSets vertex_;        // those that become one
  std::vector<bool> changed_;  // by vertex: it becomes one with another
};

}  // namespace curvdecim::detail
