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

namespace curvdecim::detail {

/// How the topology gives way: clears obstacles by cuts, closes holes, takes parts away. A manifold
/// stays one. MetricType: metric/metric.h.
template <class MetricType>
class TopologyOperator {
 public:
  static constexpr int most_records = 3;  ///< of copies, that clearing an obstacle takes

  TopologyOperator(WorkingMesh& mesh, MetricType& metric, CollapseGuards& guards,
                   const CollapseObservers& observers)
      : mesh_(mesh),
        metric_(metric),
        guards_(guards),
        observers_(observers),
        classifier_(mesh.connectivity),
        slots_(mesh.connectivity) {}

  /// The obstacle to the edge's collapse gives way. Returns the vertices that have other faces now;
  /// none: it is not possible here. number: of the first record.
  std::vector<int> clear(Edge edge, const Obstacle& obstacle, int number, Tally& tally) {
    std::vector<int> path{edge.a, edge.b};
    if (obstacle.kind == Obstacle::Kind::Loop) path.push_back(obstacle.third);
    const SurfaceCut cut(mesh_, path);
    if (!cut.is_possible()) return {};
    const auto vertices = slots_.vertices(cut.new_vertices());
    const auto faces = slots_.faces(cut.new_faces());
    if (!vertices || !faces) return {};
    for (int i = 0; i < cut.new_vertices(); ++i) part_vertex(cut, i, (*vertices)[i], number + i);
    std::vector<int> touched = path;
    touched.insert(touched.end(), vertices->begin(), vertices->end());
    close(cut, *vertices, *faces);
    renew(touched, path.size());
    for (int f : *faces)
      for (CollapseObserver* observer : observers_) observer->added(mesh_, f);
    ++(cut.fills() ? tally.holes_closed : tally.handles_cut);
    tally.note_size(longest_edge(path));
    return touched;
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
  /// The faces to the right of the path go over to a copy of its i-th vertex.
  void part_vertex(const SurfaceCut& cut, int i, int copy, int number) {
    const int v = cut.path()[i];
    mesh_.position[copy] = mesh_.position[v];
    mesh_.locked[copy] = 0;
    if (!mesh_.importance.empty()) mesh_.importance[copy] = mesh_.importance[v];
    for (int f : cut.right(i)) {
      Face face = mesh_.connectivity.face(f);
      std::replace(face.begin(), face.end(), v, copy);
      assign(f, face);
    }
    for (CollapseObserver* observer : observers_) observer->copied(mesh_, copy, v, number);
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

  /// touched: the path, then its copies.
  void renew(const std::vector<int>& touched, std::size_t path) {
    for (int v : touched) mesh_.kind[v] = classifier_.classify(v);
    for (std::size_t i = path; i < touched.size(); ++i)
      metric_.renew(touched[i], touched[i - path]);
    for (std::size_t i = 0; i < path; ++i) metric_.renew(touched[i], touched[i]);
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
