// SPDX-License-Identifier: GPL-3.0-or-later
// Where the topology may give way: what stands against a collapse, and what it costs to clear it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/guard/link_condition.h"
#include "vcg_ext/mesh/sheets.h"

namespace curvdecim::detail {

/// Why the collapse of an edge would spoil the surface.
struct Obstacle {
  enum class Kind : std::uint8_t {
    None,
    Loop,      ///< a closed path of three edges that is no face: around a handle, a hole, a neck
    Bridge,    ///< an inner edge with both ends on the boundary
    Junction,  ///< sheets that meet in a vertex
    Fixed,     ///< it cannot be cleared
  };

  Kind kind = Kind::None;
  int vertex = -1;  ///< Loop: the one beside the edge's ends. Junction: where the sheets meet

  bool exists() const { return kind != Kind::None; }
};

/// True if the surface may be cut open at v.
inline bool may_be_cut(const WorkingMesh& mesh, int v) {
  return mesh.kind[v] <= VertexKind::Boundary && !mesh.locked[v];
}

/// What a loop of three edges takes: the area of its triangle times its longest edge squared.
inline double loop_size(const WorkingMesh& mesh, int a, int b, int c) {
  const Triangle t{mesh.position[a], mesh.position[b], mesh.position[c]};
  const double longest2 = std::max(
      {(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
  return area_vector(t).norm() * longest2;
}

/// Finds the smallest closed path of three edges through the edge that may be cut. Returns its
/// third vertex, or -1.
inline int smallest_loop(const WorkingMesh& mesh, const EdgeNeighborhood& around) {
  const TriangleConnectivity& connectivity = mesh.connectivity;
  const auto [a, b] = around.edge();
  const std::vector<int>& thirds = around.thirds();
  int third = -1;
  double least = HUGE_VAL;
  for (std::size_t i = around.star_of_a(); i < around.star().size(); ++i)
    for (int u : connectivity.face(around.star()[i])) {
      if (u == b || u == third || !connectivity.has_edge(a, u) || !may_be_cut(mesh, u) ||
          std::find(thirds.begin(), thirds.end(), u) != thirds.end())
        continue;
      const double size = loop_size(mesh, a, b, u);
      if (size < least || (size == least && u < third)) least = size, third = u;
    }
  return third;
}

/// Finds the first vertex of the edge, or of a closed path of three edges through it, where sheets
/// can be parted. Returns -1 if there is none.
inline int partable_vertex(const WorkingMesh& mesh, const EdgeNeighborhood& around) {
  const auto [a, b] = around.edge();
  for (int v : {a, b})
    if (!partable_sheets(mesh, v).empty()) return v;
  for (std::size_t i = around.star_of_a(); i < around.star().size(); ++i)
    for (int u : mesh.connectivity.face(around.star()[i]))
      if (u != b && mesh.connectivity.has_edge(a, u) && !partable_sheets(mesh, u).empty()) return u;
  return -1;
}

/// may_merge: the kinds of the ends allow it (collapse_rule.h).
inline Obstacle find_obstacle(const WorkingMesh& mesh, const EdgeNeighborhood& around,
                              bool may_merge) {
  if (may_merge && satisfies_link_condition(mesh, around)) return {};
  if (const int v = partable_vertex(mesh, around); v >= 0) return {Obstacle::Kind::Junction, v};
  const auto [a, b] = around.edge();
  if (!may_be_cut(mesh, a) || !may_be_cut(mesh, b)) return {Obstacle::Kind::Fixed};
  if (has_other_common_neighbor(mesh.connectivity, around)) {
    const int third = smallest_loop(mesh, around);
    return third < 0 ? Obstacle{Obstacle::Kind::Fixed} : Obstacle{Obstacle::Kind::Loop, third};
  }
  const bool bridge = around.thirds().size() == 2 && mesh.kind[a] == VertexKind::Boundary &&
                      mesh.kind[b] == VertexKind::Boundary;
  return {bridge ? Obstacle::Kind::Bridge : Obstacle::Kind::Fixed};
}

/// The small piece of surface on one side of a loop, if it is closed but for the loop.
class SideOfLoop {
 public:
  static constexpr int most_faces = 24;

  /// start: a face at an edge of the loop.
  SideOfLoop(const WorkingMesh& mesh, const Face& loop, int start) : mesh_(mesh), loop_(loop) {
    faces_.push_back(start);
    for (std::size_t i = 0; i < faces_.size() && is_closed_; ++i) visit_neighbors(faces_[i]);
  }

  bool is_closed() const { return is_closed_; }

  /// Six times the volume between it and the loop's triangle, above 0 where it faces outward.
  double volume() const {
    double sum = 0.0;
    for (int f : faces_) sum += volume_below(mesh_, f, mesh_.position[loop_[0]]);
    return sum;
  }

  /// Area times the squared distance to the loop's triangle.
  double distance_to_loop() const {
    const Triangle cap{mesh_.position[loop_[0]], mesh_.position[loop_[1]],
                       mesh_.position[loop_[2]]};
    double sum = 0.0;
    for (int f : faces_) {
      const Vector3 center = center_of(mesh_.triangle(f));
      sum += mesh_.plane[f].area * squared_distance(cap, center);
    }
    return sum;
  }

 private:
  bool on_loop(int v) const { return v == loop_[0] || v == loop_[1] || v == loop_[2]; }

  void visit_neighbors(int f) {
    const Face& face = mesh_.connectivity.face(f);
    for (int i = 0; i < 3; ++i) {
      const int a = face[i], b = face[(i + 1) % 3];
      if (on_loop(a) && on_loop(b)) continue;
      const int across = mesh_.connectivity.face_across(f, a, b);
      is_closed_ = is_closed_ && across >= 0;
      if (across >= 0 && std::find(faces_.begin(), faces_.end(), across) == faces_.end())
        faces_.push_back(across);
    }
    is_closed_ = is_closed_ && faces_.size() <= most_faces;
  }

  const WorkingMesh& mesh_;
  const Face loop_;
  std::vector<int> faces_;
  bool is_closed_ = true;
};

/// What it costs to clear obstacles, in area times squared distance.
class ObstaclePrice {
 public:
  explicit ObstaclePrice(const WorkingMesh& mesh) : mesh_(mesh) {
    for (int f = 0; f < mesh.connectivity.face_slots(); ++f)
      volume_ += volume_below(mesh, f, Vector3::Zero());
  }

  /// True if a closed surface with this volume has its inside out, other than the input.
  bool is_inside_out(double volume) const { return volume * volume_ < 0.0; }

  /// obstacle: one that can be cleared.
  double of(const EdgeNeighborhood& around, const Obstacle& obstacle) const {
    const auto [a, b] = around.edge();
    if (obstacle.kind == Obstacle::Kind::Bridge) return share * edge_size(a, b);
    if (obstacle.kind == Obstacle::Kind::Junction) return share * junction_size(obstacle.vertex);
    return share * loop_size(mesh_, a, b, obstacle.vertex) +
           sealed_share * sealed(around, {a, b, obstacle.vertex});
  }

 private:
  static constexpr double share = 0.03;  // .01 to .1 measure alike
  static constexpr double sealed_share = 0.1;

  /// As of a path there and back.
  double edge_size(int a, int b) const {
    const double length2 = (mesh_.position[a] - mesh_.position[b]).squaredNorm();
    return 0.5 * length2 * length2;
  }

  /// The edges of more than two faces that are parted at v; each face there counts its part.
  double junction_size(int v) const {
    double sum = 0.0;
    for (int f : mesh_.connectivity.faces_of(v))
      for (int u : mesh_.connectivity.face(f))
        if (const int valence = u == v ? 0 : mesh_.connectivity.edge_valence(u, v); valence > 2)
          sum += edge_size(u, v) / valence;
    return sum;
  }

  /// The walls of a small void that the cut would seal, as at the last open end of a tunnel.
  double sealed(const EdgeNeighborhood& around, const Face& loop) const {
    double sum = 0.0;
    for (int f : around.wings()) {
      const SideOfLoop side(mesh_, loop, f);
      if (side.is_closed() && is_inside_out(side.volume())) sum += side.distance_to_loop();
    }
    return sum;
  }

  const WorkingMesh& mesh_;
  double volume_ = 0.0;  // of the input: its sign tells the outside
};

}  // namespace curvdecim::detail
