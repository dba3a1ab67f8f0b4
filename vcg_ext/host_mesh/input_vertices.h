// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/allocate.h>
#include <vcg/complex/complex.h>

#include <optional>
#include <vector>

#include "vcg_ext/geometry/morton.h"
#include "vcg_ext/geometry/point_tree.h"
#include "vcg_ext/geometry/unit_box.h"
#include "vcg_ext/parallel/pieces.h"
#include "vcg_ext/run/notes.h"
#include "vcg_ext/vertex_map.h"

namespace curvdecim::detail {

/// The vertices of a vcg mesh before it changes, for the maps of keep_map (vertex_map.h).
template <class MeshType>
class InputVertices {
 public:
  static constexpr int none = -1;

  /// box: of the vertices that faces use.
  InputVertices(const MeshType& mesh, const UnitBox& box, const Parallel& parallel)
      : box_(box),
        index_(along_curve(mesh, parallel)),
        tree_(points_of(mesh)),
        goes_to_(mesh.vert.size()) {
    for (std::size_t v = 0; v < goes_to_.size(); ++v) goes_to_[v] = static_cast<int>(v);
  }

  /// Vertex v of the input goes to this place of the mesh, or none; by itself it stays where it is.
  void set(int v, int place) { goes_to_[v] = place; }

  int count() const { return static_cast<int>(goes_to_.size()); }

  /// Leaves the maps with the mesh, of which nothing but compacting is left to be done.
  void write(MeshType& mesh, const Parallel& parallel) const {
    write_nearest(mesh, parallel);
    write_goes_to(mesh);
  }

 private:
  using Scalar = typename MeshType::ScalarType;
  using Allocator = vcg::tri::Allocator<MeshType>;

  Vector3 point_of(const MeshType& mesh, int v) const {
    return box_.to_box(vector_of(mesh.vert[v].cP()));
  }

  /// Those that are in use or could be, so that those in a row lie near each other.
  std::vector<int> along_curve(const MeshType& mesh, const Parallel& parallel) const {
    const std::vector<int> all =
        indices_where(static_cast<int>(mesh.vert.size()), parallel,
                      [&](int v) { return !mesh.vert[v].IsD() && point_of(mesh, v).allFinite(); });
    const auto inside = [&](int i) -> Vector3 {  // some that no face uses are not
      return point_of(mesh, all[i]).cwiseMax(-0.5).cwiseMin(0.5);
    };
    std::vector<int> ordered;
    ordered.reserve(all.size());
    for (const Keyed& each : detail::along_curve(static_cast<int>(all.size()), parallel, inside))
      ordered.push_back(all[each.value]);
    return ordered;
  }

  std::vector<Vector3> points_of(const MeshType& mesh) const {
    std::vector<Vector3> points;
    points.reserve(index_.size());
    for (int v : index_) points.push_back(point_of(mesh, v));
    return points;
  }

  void write_nearest(MeshType& mesh, const Parallel& parallel) const {
    auto nearest = Allocator::template GetPerVertexAttribute<Scalar>(mesh, nearest_input_vertex);
    parallel.for_each(static_cast<int>(mesh.vert.size()), [&](int v) {
      if (mesh.vert[v].IsD()) return;
      const int i = tree_.nearest(point_of(mesh, v), [](int) { return true; });
      nearest[v] = static_cast<Scalar>(i == PointTree::none ? v : index_[i]);
    });
  }

  void write_goes_to(MeshType& mesh) const {
    std::vector<int> number(mesh.vert.size(), none);  // once the mesh is compact
    int next = 0;
    for (std::size_t v = 0; v < number.size(); ++v)
      if (!mesh.vert[v].IsD()) number[v] = next++;
    auto goes_to = Allocator::template GetPerMeshAttribute<std::vector<int>>(mesh, result_vertex);
    goes_to().clear();
    for (int place : goes_to_) goes_to().push_back(place == none ? none : number[place]);
  }

  const UnitBox box_;
  const std::vector<int> index_;  // by point of the tree
  const PointTree tree_;
  std::vector<int> goes_to_;  // by vertex of the input: a place in the mesh
};

/// The end of a run with nothing to do: the report says why, and the maps are there all the same.
template <class MeshType, class Input, class Run>
void leave_alone(MeshType& mesh, const ReachedTarget& reached, const std::optional<Input>& input,
                 const Run& run) {
  note_nothing_to_do(reached, run.report);
  if (input) input->write(mesh, run.parallel);
}

}  // namespace curvdecim::detail
