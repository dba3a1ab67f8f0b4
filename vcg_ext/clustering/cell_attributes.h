// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "vcg_ext/clustering/cell_members.h"
#include "vcg_ext/clustering/representatives.h"
#include "vcg_ext/geometry/blend.h"
#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/mesh/wedge_coordinate.h"

namespace curvdecim::detail {

/// The vertices, and their parts, that a cell's vertex has its attributes from.
class CellBlend {
 public:
  /// Each cell from its own vertices; weight: by vertex; empty: 1.
  static CellBlend of_members(const Clusters& clusters, const std::vector<double>& weight) {
    const Groups members = vertices_by_cell(clusters);
    CellBlend blend;
    for (int c = 0; c < clusters.cells(); ++c) {
      for (int v : members[c]) blend.parts_.push_back({v, weight.empty() ? 1.0 : weight[v]});
      blend.end_cell();
    }
    return blend;
  }

  /// Each cell from one vertex.
  static CellBlend of_vertices(const std::vector<int>& vertices) {
    CellBlend blend;
    for (int v : vertices) {
      blend.parts_.push_back({v, 1.0});
      blend.end_cell();
    }
    return blend;
  }

  /// Each cell from the point of its faces nearest to its new vertex, so that what is affine in
  /// position stays so.
  static CellBlend of_surface(const FlatMesh& mesh, const Clusters& clusters,
                              const Representatives& representatives, const Parallel& parallel) {
    const Groups faces = faces_by_cell(mesh, clusters);
    std::vector<FacePoint> nearest(clusters.cells());
    parallel.for_each(
        clusters.cells(),
        [&](int c) { nearest[c] = nearest_point(faces[c], mesh, representatives.position[c]); },
        Parallel::heavy);
    CellBlend blend;
    for (const FacePoint& point : nearest) {
      for (int i = 0; i < 3; ++i)
        if (point.weight[i] != 0.0)
          blend.parts_.push_back({mesh.faces[point.face][i], point.weight[i]});
      blend.end_cell();
    }
    return blend;
  }

  /// value(v): of a vertex; otherwise: where no part counts.
  template <class Value, class ValueOf>
  Value at(int cell, ValueOf value, const Value& otherwise) const {
    Blend<Value> blend(otherwise);
    for (int i = begin_[cell]; i < begin_[cell + 1]; ++i)
      blend.add(parts_[i].weight, value(parts_[i].vertex));
    return blend.mean();
  }

 private:
  struct Part {
    int vertex;
    double weight;
  };

  void end_cell() { begin_.push_back(static_cast<int>(parts_.size())); }

  std::vector<int> begin_ = {0};  // by cell, and the end of the last
  std::vector<Part> parts_;
};

/// What cells carry: how it follows from what the input carried.
struct CarriedByCells {
  CellBlend blend;
  std::optional<std::vector<FaceWedges>> wedges;  // by the faces of the clusters, if there are any
};

}  // namespace curvdecim::detail
