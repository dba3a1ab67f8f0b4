// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/collapse/collapse_observer.h"
#include "vcg_ext/collapse/free_slots.h"
#include "vcg_ext/collapse/parts.h"
#include "vcg_ext/collapse/surface_cut.h"
#include "vcg_ext/guard/collapse_guards.h"
#include "vcg_ext/mesh/tally.h"
#include "vcg_ext/mesh/vertex_ring.h"

namespace curvdecim::detail {

/// How the topology gives way: clears obstacles by cuts, closes holes, takes parts away. A manifold
/// stays one. MetricType: metric/metric.h.
template <class MetricType>
class TopologyOperator {
 public:
  TopologyOperator(WorkingMesh& mesh, MetricType& metric, CollapseGuards& guards,
                   const CollapseObservers& observers)
      : mesh_(mesh),
        metric_(metric),
        guards_(guards),
        observers_(observers),
        classifier_(mesh.connectivity),
        slots_(mesh.connectivity) {}

  /// The obstacle to the edge's collapse gives way. Returns the vertices that have other faces now;
  /// none: it is not possible here. next_number: of the next record; moves on.
  std::vector<int> clear(Edge edge, const Obstacle& obstacle, int& next_number, Tally& tally) {
    if (obstacle.kind == Obstacle::Kind::Junction) return part(obstacle.vertex, next_number, tally);
    std::vector<int> path{edge.a, edge.b};
    if (obstacle.kind == Obstacle::Kind::Loop) path.push_back(obstacle.vertex);
    return cut(SurfaceCut(mesh_, path), next_number, tally);
  }

  void remove(const Part& part, Tally& tally) {
    Vector3 low = mesh_.position[part.vertices[0]], high = low;
    for (int v : part.vertices)
      low = low.cwiseMin(mesh_.position[v]), high = high.cwiseMax(mesh_.position[v]);
    for (int f : part.faces) mesh_.connectivity.count(mesh_.connectivity.remove_face(f));
    ++tally.parts_removed;
    tally.note_size((high - low).norm());
  }

 private:
  std::vector<int> cut(const SurfaceCut& cut, int& next_number, Tally& tally) {
    constexpr int fewest = 6;  // that may leave a closed part of four on each side, with two more
    if (!cut.is_possible() || mesh_.connectivity.face_count() < fewest) return {};
    const auto vertices = slots_.vertices(cut.new_vertices());
    const auto faces = slots_.faces(cut.new_faces());
    if (!vertices || !faces || closing_crosses(cut, *faces)) return {};
    for (int i = 0; i < cut.new_vertices(); ++i)
      hand_over(cut.path()[i], cut.right(i), (*vertices)[i], next_number++);
    close(cut, *vertices, *faces);
    for (int f : *faces) {
      if (mesh_.wedges.exist()) mesh_.wedges.add(mesh_.connectivity, f);
      for (CollapseObserver* observer : observers_) observer->added(mesh_, f);
    }
    for (int i = 0; i < cut.new_vertices(); ++i) renew((*vertices)[i], cut.path()[i]);
    for (int v : cut.path()) renew(v, v);
    ++(cut.fills() ? tally.holes_closed : tally.handles_cut);
    tally.note_size(longest_edge(cut.path()));
    return joined(cut.path(), *vertices);
  }

  /// The sheets that meet in v go apart: all but one to copies.
  std::vector<int> part(int v, int& next_number, Tally& tally) {
    const std::vector<int> sheets = partable_sheets(mesh_, v);
    if (sheets.empty()) return {};
    const int count = *std::max_element(sheets.begin(), sheets.end());
    const auto copies = slots_.vertices(count);
    if (!copies) return {};
    const std::vector<int> along = curve_neighbors(v);
    const std::vector<int> faces(mesh_.connectivity.faces_of(v).begin(),
                                 mesh_.connectivity.faces_of(v).end());
    for (int i = 0; i < count; ++i)
      hand_over(v, of_sheet(faces, sheets, i + 1), (*copies)[i], next_number++);
    for (int copy : *copies) renew(copy, v);
    for (int u : joined({v}, along)) renew(u, u);
    ++tally.junctions_parted;
    for (int u : along) tally.note_size((mesh_.position[u] - mesh_.position[v]).norm());
    return joined(joined(along, {v}), *copies);
  }

  static std::vector<int> of_sheet(const std::vector<int>& faces, const std::vector<int>& sheets,
                                   int sheet) {
    std::vector<int> found;
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (sheets[i] == sheet) found.push_back(faces[i]);
    return found;
  }

  static std::vector<int> joined(std::vector<int> a, const std::vector<int>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  /// The neighbours of v at edges of more than two faces, and others that are not manifold.
  std::vector<int> curve_neighbors(int v) const {
    VertexRing ring;
    gather_ring(mesh_, v, ring);
    std::vector<int> found;
    for (const RingVertex& u : ring)
      if (mesh_.kind[u.vertex] >= VertexKind::Curve) found.push_back(u.vertex);
    return found;
  }

  /// The faces go over to a copy of v.
  void hand_over(int v, const std::vector<int>& faces, int copy, int number) {
    mesh_.position[copy] = mesh_.position[v];
    mesh_.locked[copy] = 0;
    if (!mesh_.importance.empty()) mesh_.importance[copy] = mesh_.importance[v];
    for (int f : faces) {
      Face face = mesh_.connectivity.face(f);
      std::replace(face.begin(), face.end(), v, copy);
      assign(f, face);
    }
    const std::vector<Wedges::Parted> wedges = part_wedges(copy);
    for (CollapseObserver* observer : observers_) {
      observer->make_room(number + 1);
      observer->copied(mesh_, copy, v, wedges, number);
    }
  }

  /// Those of a vertex that has taken over faces become its own.
  std::vector<Wedges::Parted> part_wedges(int v) {
    if (!mesh_.wedges.exist()) return {};
    std::vector<Wedges::Parted> parted = mesh_.wedges.part(mesh_.connectivity, v);
    for (const auto [now, source] : parted) {
      if (!mesh_.texture.empty()) mesh_.texture.push_back(mesh_.texture[source]);
      if (!mesh_.color.empty()) mesh_.color.push_back(mesh_.color[source]);
    }
    return parted;
  }

  /// Where faces may not cross, a loop is closed by one face; two would lie on each other.
  bool closing_crosses(const SurfaceCut& cut, const std::vector<int>& faces) const {
    const CrossingGuard* guard = guards_.crossing_guard();
    if (!guard || faces.empty()) return false;
    const auto at = [&](int i) { return mesh_.position[cut.path()[i]]; };
    return faces.size() > 1 || !guard->allows_face(faces[0], {at(0), at(2), at(1)});
  }

  /// A face on each side of a loop.
  void close(const SurfaceCut& cut, const std::vector<int>& copies, const std::vector<int>& faces) {
    if (faces.empty()) return;
    const std::vector<int>& path = cut.path();
    assign(faces[0], {path[0], path[2], path[1]});
    if (faces.size() > 1) assign(faces[1], {copies[0], copies[1], copies[2]});
    for (int f : faces) mesh_.update_plane(f), guards_.renew(f);
  }

  void assign(int f, const Face& face) {
    mesh_.connectivity.count(mesh_.connectivity.assign(f, face));
  }

  /// source: what v is a copy of, or itself.
  void renew(int v, int source) {
    mesh_.kind[v] = classifier_.classify(v);
    update_seam(mesh_, v);
    metric_.renew(v, source);
  }

  double longest_edge(const std::vector<int>& path) const {
    double longest = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i)
      longest = std::max(
          longest, (mesh_.position[path[i]] - mesh_.position[path[(i + 1) % path.size()]]).norm());
    return longest;
  }

  WorkingMesh& mesh_;
  MetricType& metric_;
  CollapseGuards& guards_;
  const CollapseObservers& observers_;
  VertexClassifier classifier_;
  FreeSlots slots_;
};

}  // namespace curvdecim::detail
