// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "vcg_ext/collapse/collapse_observer.h"
#include "vcg_ext/collapse/price_unit.h"
#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/geometry/point_tree.h"
#include "vcg_ext/guard/obstacle.h"
#include "vcg_ext/mesh/disjoint_sets.h"
#include "vcg_ext/queue/priority.h"

namespace curvdecim::detail {

/// A piece of the surface that hangs together with nothing else.
struct Part {
  std::vector<int> faces;
  std::vector<int> vertices;  // ascending
};

/// Numbers, each once, up to a fixed count: most parts are too large, and are found so without an
/// allocation.
template <int Capacity>
class FewNumbers {
 public:
  bool contains(int n) const { return std::find(begin(), end(), n) != end(); }
  bool is_full() const { return count_ == Capacity; }
  void add(int n) { numbers_[count_++] = n; }
  int size() const { return count_; }
  int operator[](int i) const { return numbers_[i]; }
  const int* begin() const { return numbers_.data(); }
  const int* end() const { return begin() + count_; }

 private:
  std::array<int, Capacity> numbers_{};
  int count_ = 0;
};

/// The part around v, if it has few faces.
template <int MostFaces>
std::optional<Part> part_around(const TriangleConnectivity& connectivity, int v) {
  FewNumbers<MostFaces> faces;
  FewNumbers<3 * MostFaces> vertices;
  vertices.add(v);
  for (int i = 0; i < vertices.size(); ++i)
    for (int f : connectivity.faces_of(vertices[i])) {
      if (faces.contains(f)) continue;
      if (faces.is_full()) return std::nullopt;
      faces.add(f);
      for (int u : connectivity.face(f))
        if (!vertices.contains(u)) vertices.add(u);
    }
  if (faces.size() == 0) return std::nullopt;
  Part part{{faces.begin(), faces.end()}, {vertices.begin(), vertices.end()}};
  std::sort(part.vertices.begin(), part.vertices.end());
  return part;
}

/// Tells whether the surface is in several parts.
inline bool has_several_parts(const TriangleConnectivity& connectivity) {
  DisjointSets connected(connectivity.vertex_slots());
  int parts = connectivity.vertex_count();
  for (int f = 0; f < connectivity.face_slots(); ++f) {
    if (!connectivity.alive(f)) continue;
    for (int i = 0; i < 2; ++i) {
      const int a = connectivity.face(f)[i], b = connectivity.face(f)[i + 1];
      parts -= connected.root(a) != connected.root(b);
      connected.unite(a, b);
    }
  }
  return parts > 1;
}

/// Small parts that may vanish, the cheapest first. The price of one is about what it adds to the
/// squared error: the area of the input that it stands for, times the squared distance to the
/// nearest other surface.
class Parts : public CollapseObserver {
 public:
  Parts(const WorkingMesh& mesh, const PriceUnit& price_unit, const ObstaclePrice& obstacle_price)
      : mesh_(mesh),
        price_unit_(price_unit),
        obstacle_price_(obstacle_price),
        area_(mesh.position.size(), 0.0),
        cut_(mesh.position.size(), 0),
        several_(has_several_parts(mesh.connectivity)) {
    for (int f = 0; f < mesh.connectivity.face_slots(); ++f)
      if (mesh.connectivity.alive(f))
        for (int v : mesh.connectivity.face(f)) area_[v] += mesh.plane[f].area / 3.0;
  }

  // --- the queue --------------------------------------------------------------------------------

  /// All that are small now.
  void offer_all() {
    queue_ = {};
    if (!several_) return;
    for (int v = 0; v < mesh_.connectivity.vertex_slots(); ++v)
      if (const std::optional<Part> part = small_part(v); part && part->vertices[0] == v)
        offer(*part, v);
  }

  /// The one around v, if it is small.
  void offer(int v) {
    if (!several_) return;
    if (const std::optional<Part> part = small_part(v)) offer(*part, v);
  }

  /// The cheapest, at what it costs now; nullopt where it costs more than the limit. It leaves the
  /// queue. most_faces: a larger one is passed over.
  std::optional<Part> take(Priority limit, int most_faces) {
    while (!queue_.empty() && !(limit < queue_.top().price)) {
      const Entry entry = queue_.top();
      queue_.pop();
      std::optional<Part> part = small_part(entry.vertex);
      if (!part || is_all(*part)) continue;
      const Priority price = price_of(*part);
      if (entry.price < price) {
        queue_.push({price, entry.vertex});
      } else if (static_cast<int>(part->faces.size()) <= most_faces) {
        return part;
      }
    }
    return std::nullopt;
  }

  /// No edge is left: those that waited come back, and larger ones may go, too. False: there is
  /// none.
  bool widen() {
    takes_larger_ = true;
    offer_all();
    return !queue_.empty();
  }

  // --- what happens to the mesh -----------------------------------------------------------------

  void make_room(int) override {}

  void before(const WorkingMesh&, const EdgeNeighborhood&, const EdgeCharts&,
              const VertexMerge& merge, int) override {
    area_[merge.keep] += area_[merge.gone];
    cut_[merge.keep] |= cut_[merge.gone];
    if (!into_.empty()) into_[merge.gone] = merge.keep;
  }

  void copied(const WorkingMesh&, int v, int source, const std::vector<Wedges::Parted>&,
              int) override {
    area_[v] = area_[source] *= 0.5;
    cut_[v] = cut_[source] = 1;
    several_ = true;
    if (!into_.empty()) into_[v] = v;
  }

  /// The queue is empty afterwards.
  void renumber(const Renumbering& numbers) override {
    numbers.vertices(area_), numbers.vertices(cut_);
    queue_ = {};
    for (int& v : vertex_of_)
      if (v != gone) v = numbers.vertex(standing(v));
    into_.resize(area_.size());
    std::iota(into_.begin(), into_.end(), 0);
  }

 private:
  static constexpr int gone = Renumbering::gone;

  struct Entry {
    Priority price;
    int vertex;
    bool operator<(const Entry& o) const {  // the queue has the greatest on top
      return price == o.price ? vertex > o.vertex : o.price < price;
    }
  };

  /// A part comes down to four faces first, where nothing keeps it from that.
  std::optional<Part> small_part(int v) const {
    return takes_larger_ ? part_around<32>(mesh_.connectivity, v)
                         : part_around<4>(mesh_.connectivity, v);
  }

  void offer(const Part& part, int v) {
    if (!is_all(part) && may_go(part)) queue_.push({least_price(part), v});
  }

  bool is_all(const Part& part) const {
    return static_cast<int>(part.faces.size()) == mesh_.connectivity.face_count();
  }

  bool may_go(const Part& part) const {
    return std::none_of(part.vertices.begin(), part.vertices.end(),
                        [&](int v) { return mesh_.locked[v] != 0; });
  }

  /// What it costs at least: most parts are not drawn before they have come down further.
  Priority least_price(const Part& part) {
    return is_sealed(part) ? Priority(0.0, 0.0) : priority(0.5 * price_of_center(part));
  }

  /// The mean of what its centre and what its vertices are away from the rest.
  Priority price_of(const Part& part) {
    if (is_sealed(part)) return Priority(0.0, 0.0);
    double price = price_of_center(part);
    for (int v : part.vertices) price += area_[v] * distance2(mesh_.position[v], part);
    return priority(0.5 * price);
  }

  double price_of_center(const Part& part) {
    Vector3 center = Vector3::Zero();
    double area = 0.0;
    for (int v : part.vertices) center += mesh_.position[v], area += area_[v];
    return area * distance2(center / static_cast<double>(part.vertices.size()), part);
  }

  Priority priority(double price) const { return Priority(price_unit_(price), 0.0); }

  /// A void that cuts have sealed: closed, and inside out.
  bool is_sealed(const Part& part) const {
    if (std::none_of(part.vertices.begin(), part.vertices.end(),
                     [&](int v) { return cut_[v] != 0; }))
      return false;
    double volume = 0.0;
    for (int f : part.faces) {
      const Face& face = mesh_.connectivity.face(f);
      for (int i = 0; i < 3; ++i)
        if (mesh_.connectivity.edge_valence(face[i], face[(i + 1) % 3]) != 2) return false;
      volume += volume_below(mesh_, f, Vector3::Zero());
    }
    return obstacle_price_.is_inside_out(volume);
  }

  /// To the nearest other surface.
  double distance2(const Vector3& p, const Part& part) {
    if (!tree_) make_tree();
    const auto is_other = [&](int point) {
      const int v = standing(vertex_of_[point]);
      return v != gone && mesh_.connectivity.faces_of(v).size() > 0 &&
             !std::binary_search(part.vertices.begin(), part.vertices.end(), v);
    };
    const int point = tree_->nearest(p, is_other);
    if (point == PointTree::none) return HUGE_VAL;
    double least = HUGE_VAL;
    for (int f : mesh_.connectivity.faces_of(standing(vertex_of_[point])))
      least = std::min(least, squared_distance(mesh_.triangle(f), p));
    return least;
  }

  /// The tree holds the vertices and the faces' centres.
  void make_tree() {
    std::vector<Vector3> points;
    for (int v = 0; v < mesh_.connectivity.vertex_slots(); ++v)
      if (mesh_.connectivity.faces_of(v).size() > 0)
        points.push_back(mesh_.position[v]), vertex_of_.push_back(v);
    for (int f = 0; f < mesh_.connectivity.face_slots(); ++f) {
      if (!mesh_.connectivity.alive(f)) continue;
      points.push_back(center_of(mesh_.triangle(f)));
      vertex_of_.push_back(mesh_.connectivity.face(f)[0]);
    }
    tree_.emplace(std::move(points));
    into_.resize(mesh_.position.size());
    std::iota(into_.begin(), into_.end(), 0);
  }

  /// The vertex that stands for v now.
  int standing(int v) {
    if (v == gone) return gone;
    while (into_[v] != v) v = into_[v] = into_[into_[v]];
    return v;
  }

  const WorkingMesh& mesh_;
  const PriceUnit price_unit_;
  const ObstaclePrice& obstacle_price_;
  std::vector<double> area_;       // by vertex: of the input, that has gone into it
  std::vector<std::uint8_t> cut_;  // by vertex
  bool several_;                   // false: nothing may vanish
  bool takes_larger_ = false;
  std::priority_queue<Entry> queue_;
  std::optional<PointTree> tree_;
  std::vector<int> vertex_of_;  // by point of the tree: a vertex that it belonged to
  std::vector<int> into_;       // by vertex: what it went into, or itself
};

}  // namespace curvdecim::detail
