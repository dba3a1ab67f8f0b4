// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/parallel/array.h"
#include "vcg_ext/parallel/bucket_places.h"

namespace curvdecim::detail {

/// Elements one after the other in an array that something else owns; valid until that changes.
template <class T>
struct ElementRange {
  const T* first;
  const T* last;
  const T* begin() const { return first; }
  const T* end() const { return last; }
  int size() const { return static_cast<int>(last - first); }
};
using IndexRange = ElementRange<int>;  ///< numbers of elements

using Face = std::array<int, 3>;

/// True if a vertex comes twice.
inline bool is_degenerate(const Face& face) {
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

/// The corner of a face that follows v.
inline int next_in(const Face& face, int v) {
  return face[0] == v ? face[1] : face[1] == v ? face[2] : face[0];
}

/// What a change took away.
struct Removed {
  int faces = 0, vertices = 0;

  Removed& operator+=(const Removed& o) {
    faces += o.faces, vertices += o.vertices;
    return *this;
  }
};

/// Faces and, for every vertex, the list of the faces around it. The lists lie in one pool; a list
/// that outgrows its room moves to the pool's end with room to grow by half, so that a vertex that
/// swallows thousands of neighbours costs amortised constant time and memory.
///
/// Collapses whose neighbourhoods share no vertex may run at the same time, if room was made for
/// them before and what they removed is counted afterwards.
class TriangleConnectivity {
 public:
  static constexpr int dead = -1;  ///< the corners of a face that is gone

  TriangleConnectivity() = default;

  /// faces: (F, 3) indices below vertex_count, no index twice in a face.
  TriangleConnectivity(std::vector<Face> faces, int vertex_count,
                       const Parallel& parallel = Parallel(1))
      : faces_(std::move(faces)) {
    make_lists(vertex_count, parallel);
  }

  /// Throws std::logic_error, which names the flaw, where faces, lists and counts do not agree;
  /// once what was removed is counted they always do.
  void validate() const {
    std::size_t entries = 0;
    int faces = 0, vertices = 0;
    for (int f = 0; f < face_slots(); ++f) faces += alive(f) && has_three_vertices(f);
    for (int v = 0; v < vertex_slots(); ++v) {
      validate_list(v);
      entries += faces_of(v).size(), vertices += faces_of(v).size() > 0;
    }
    require(entries == 3 * static_cast<std::size_t>(faces), "a face is missing in a list");
    require(faces == face_count_, "the faces are miscounted");
    require(vertices == vertex_count_, "the vertices are miscounted");
  }

  /// The faces by slot. Nothing is left.
  std::vector<Face> release_faces() {
    std::vector<Face> faces = std::move(faces_);
    *this = {};
    return faces;
  }

  /// Slots, dead ones included.
  int face_slots() const { return static_cast<int>(faces_.size()); }
  int vertex_slots() const { return static_cast<int>(lists_.size()); }

  /// Living faces; vertices with a face.
  int face_count() const { return face_count_; }
  int vertex_count() const { return vertex_count_; }

  bool alive(int face) const { return faces_[face][0] >= 0; }
  const Face& face(int f) const { return faces_[f]; }

  /// The faces around v; valid until the next collapse.
  IndexRange faces_of(int v) const {
    const List& list = lists_[v];
    return {pool_.data() + list.begin, pool_.data() + list.begin + list.size};
  }

  /// 0, 1 or 2: where v stands in face f.
  int corner(int f, int v) const {
    const Face& face = faces_[f];
    return face[0] == v ? 0 : face[1] == v ? 1 : 2;
  }

  bool face_has(int f, int v) const { return has(faces_[f], v); }

  /// The corner of f that follows v.
  int next_vertex(int f, int v) const { return next_in(faces_[f], v); }

  /// The corner of f that is neither a nor b, two different corners of it.
  int third_vertex(int f, int a, int b) const {
    const Face& face = faces_[f];
    return face[0] + face[1] + face[2] - a - b;
  }

  /// A vertex of very many faces: of more than those of meshes made for any purpose have.
  static constexpr int hub = 64;
  bool is_hub(int v) const { return faces_of(v).size() > hub; }

  bool has_edge(int a, int b) const {
    if (faces_of(a).size() > faces_of(b).size()) std::swap(a, b);
    for (int f : faces_of(a))
      if (face_has(f, b)) return true;
    return false;
  }

  /// The face with these three corners, or -1.
  int find_face(int a, int b, int c) const {
    if (faces_of(a).size() > faces_of(b).size()) std::swap(a, b);
    for (int f : faces_of(a))
      if (face_has(f, b) && face_has(f, c)) return f;
    return -1;
  }

  /// Faces at the edge ab.
  int edge_valence(int a, int b) const {
    if (faces_of(a).size() > faces_of(b).size()) std::swap(a, b);
    int faces = 0;
    for (int f : faces_of(a)) faces += face_has(f, b);
    return faces;
  }

  /// Another face at the edge ab of f, or -1; of several the first in a's list, or b's beside a
  /// hub.
  int face_across(int f, int a, int b) const {
    if (is_hub(a)) std::swap(a, b);
    for (int g : faces_of(a))
      if (g != f && face_has(g, b)) return g;
    return -1;
  }

  Removed remove_face(int f) {
    assert(alive(f));
    Removed removed{1, 0};
    for (int v : faces_[f]) {
      erase(lists_[v], f);
      removed.vertices += lists_[v].size == 0;
    }
    faces_[f] = {dead, dead, dead};
    return removed;
  }

  /// The face, living or not, gets these corners. What it removes may be less than nothing.
  Removed assign(int f, const Face& now) {
    const Face was = faces_[f];
    Removed removed{was[0] == dead ? -1 : 0, 0};
    for (int v : was)
      if (v != dead && !has(now, v)) {
        erase(lists_[v], f);
        removed.vertices += lists_[v].size == 0;
      }
    for (int v : now)
      if (!has(was, v)) {
        removed.vertices -= lists_[v].size == 0;
        reserve(lists_[v], lists_[v].size + 1), append(lists_[v], f);
      }
    faces_[f] = now;
    return removed;
  }

  /// Edge collapse: faces with both vertices go, `gone` becomes `keep` in the others.
  Removed collapse(int keep, int gone) {
    assert(keep != gone);
    Removed removed = remove_shared_faces(keep, gone);
    for (int f : faces_of(gone)) faces_[f][corner(f, gone)] = keep;
    removed.vertices += lists_[keep].size > 0 && lists_[gone].size > 0;
    make_room(keep, gone, 0);
    merge_lists(lists_[keep], lists_[gone]);
    return removed;
  }

  /// Edge flip: the faces f = (a, b, c) and g = (b, a, d) become (a, d, c) and (b, c, d).
  void flip(int f, int g, int a, int b) {
    assert(next_vertex(f, a) == b && next_vertex(g, b) == a);
    const int c = third_vertex(f, a, b), d = third_vertex(g, a, b);
    faces_[f][corner(f, b)] = d;
    faces_[g][corner(g, a)] = c;
    erase(lists_[b], f), erase(lists_[a], g);
    reserve(lists_[d], lists_[d].size + 1), append(lists_[d], f);
    reserve(lists_[c], lists_[c].size + 1), append(lists_[c], g);
  }

  /// Vertex removal and insertion: the faces in `which` become those in `now`; one with dead
  /// corners is no face. Lists in ascending order stay so, and to replace back restores them.
  Removed replace(const std::vector<int>& which, const std::vector<Face>& now) {
    assert(which.size() == now.size());
    Removed removed;
    for (std::size_t i = 0; i < which.size(); ++i) {
      Face& face = faces_[which[i]];
      const Face was = face;
      face = now[i];
      removed.faces += (was[0] != dead) - (face[0] != dead);
      for (int v : was)
        if (v != dead && !has(face, v)) erase_in_order(v, which[i], removed);
      for (int v : face)
        if (v != dead && !has(was, v)) insert_in_order(v, which[i], removed);
    }
    return removed;
  }

  /// So that the collapse of the edge, which has `shared` faces, moves no list but its own two.
  void make_room(int a, int b, int shared) {
    List& roomier = lists_[a].capacity < lists_[b].capacity ? lists_[b] : lists_[a];
    reserve(roomier, lists_[a].size + lists_[b].size - 2 * shared);
  }

  /// Keeps the faces in `old_face`, in this order, which is ascending, with new numbers for the
  /// vertices.
  void keep(const std::vector<int>& old_face, const std::vector<int>& new_vertex,
            int vertex_count) {
    for (std::size_t i = 0; i < old_face.size(); ++i) {
      const auto [a, b, c] = faces_[old_face[i]];
      faces_[i] = {new_vertex[a], new_vertex[b], new_vertex[c]};
    }
    faces_.resize(old_face.size());
    make_lists(vertex_count, Parallel(1));
  }

  /// More slots: of vertices without a face, and of dead faces.
  void extend(int vertices, int faces) {
    faces_.reserve(faces_.size() + faces), lists_.reserve(lists_.size() + vertices);
    faces_.resize(faces_.size() + faces, {dead, dead, dead});
    lists_.resize(lists_.size() + vertices, List{});
  }

  /// To be told of every change, so that the counts stay right.
  void count(const Removed& removed) {
    face_count_ -= removed.faces;
    vertex_count_ -= removed.vertices;
  }

 private:
  struct List {
    int begin = 0, size = 0, capacity = 0;
  };

  /// Makes the lists of the faces as they are; all are alive.
  void make_lists(int vertex_count, const Parallel& parallel) {
    BucketPlaces places;
    places.count(face_slots(), vertex_count, parallel, [&](int f, auto count_in) {
      for (int v : faces_[f]) count_in(v);
    });
    const std::vector<int>& begin = places.begin();
    pool_.reserve(2 * static_cast<std::size_t>(begin.back()));  // lists will move to its end
    pool_.resize(begin.back());
    places.fill(parallel, [&](int f, auto place_in) {
      for (int v : faces_[f]) pool_[place_in(v)] = f;
    });
    lists_.resize(vertex_count);
    parallel.for_each(vertex_count, [&](int v) {
      const int size = begin[v + 1] - begin[v];
      lists_[v] = {begin[v], size, size};
    });
    face_count_ = face_slots();
    vertex_count_ = static_cast<int>(std::count_if(lists_.begin(), lists_.end(),
                                                   [](const List& list) { return list.size > 0; }));
  }

  void append(List& list, int f) { pool_[list.begin + list.size++] = f; }

  void erase(List& list, int f) {
    int* const first = pool_.data() + list.begin;
    *find(first, first + list.size, f) = first[list.size - 1];
    --list.size;
  }

  /// Where f stands. A hub's list is long: the processor compares a block of it at once.
  static int* find(int* first, int* last, int f) {
    constexpr int block = 16;
    for (; last - first > block; first += block) {
      int found = 0;
      for (int i = 0; i < block; ++i) found |= first[i] == f;
      if (found != 0) break;
    }
    return std::find(first, last, f);
  }

  static void require(bool holds, const char* flaw) {
    if (!holds) throw std::logic_error(std::string("TriangleConnectivity: ") + flaw);
  }

  bool has_three_vertices(int f) const {
    const auto [a, b, c] = faces_[f];
    require(a != b && b != c && c != a, "a face has a vertex twice");
    require(std::min({a, b, c}) >= 0 && std::max({a, b, c}) < vertex_slots(),
            "a face has a vertex that does not exist");
    return true;
  }

  void validate_list(int v) const {
    std::vector<int> faces(faces_of(v).begin(), faces_of(v).end());
    std::sort(faces.begin(), faces.end());
    require(std::adjacent_find(faces.begin(), faces.end()) == faces.end(),
            "a list has a face twice");
    for (int f : faces) require(alive(f) && face_has(f, v), "a list has a face without its vertex");
  }

  static bool has(const Face& face, int v) { return face[0] == v || face[1] == v || face[2] == v; }

  void erase_in_order(int v, int f, Removed& removed) {
    List& list = lists_[v];
    int* const first = pool_.data() + list.begin;
    int* const place = std::lower_bound(first, first + list.size, f);
    std::copy(place + 1, first + list.size, place);
    removed.vertices += --list.size == 0;
  }

  void insert_in_order(int v, int f, Removed& removed) {
    List& list = lists_[v];
    reserve(list, list.size + 1);
    int* const first = pool_.data() + list.begin;
    int* const place = std::lower_bound(first, first + list.size, f);
    std::copy_backward(place, first + list.size, first + list.size + 1);
    *place = f;
    removed.vertices -= list.size++ == 0;
  }

  Removed remove_shared_faces(int keep, int gone) {
    Removed removed;
    for (int i = lists_[gone].size - 1; i >= 0; --i) {
      const int f = pool_[lists_[gone].begin + i];
      if (face_has(f, keep)) removed += remove_face(f);
    }
    return removed;
  }

  /// All of b's faces go to a; the roomier list stays where it is, and has room.
  void merge_lists(List& a, List& b) {
    if (a.capacity < b.capacity) std::swap(a, b);
    std::copy_n(pool_.data() + b.begin, b.size, pool_.data() + a.begin + a.size);
    a.size += b.size;
    b.size = 0;
  }

  void reserve(List& list, int needed) {
    if (needed <= list.capacity) return;
    const int begin = static_cast<int>(pool_.size());
    const int capacity = std::max(needed, list.capacity + list.capacity / 2);
    pool_.resize(pool_.size() + capacity);
    std::copy_n(pool_.data() + list.begin, list.size, pool_.data() + begin);
    list.begin = begin;
    list.capacity = capacity;
  }

  std::vector<Face> faces_;
  Array<List> lists_;  // by vertex
  Array<int> pool_;
  int face_count_ = 0, vertex_count_ = 0;
};

}  // namespace curvdecim::detail
