// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/allocate.h>
#include <vcg/complex/complex.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <vector>

#include "vcg_ext/clustering/cell_attributes.h"
#include "vcg_ext/clustering/clustering_operator.h"
#include "vcg_ext/host_mesh/attributes.h"
#include "vcg_ext/host_mesh/change_mesh.h"
#include "vcg_ext/host_mesh/input_vertices.h"
#include "vcg_ext/report.h"

namespace curvdecim::detail {

/// Makes a vcg mesh what the clustering of it gave. One vertex of each cell stays and goes to the
/// representative; faces that are left keep what they carry. Afterwards the mesh is compact and its
/// adjacency relations are empty.
template <class MeshType>
class ClusterWriteBack {
 public:
  ClusterWriteBack(MeshType& mesh, const FlatMesh& flat, const Clustering& clustering,
                   const Parallel& parallel)
      : mesh_(mesh),
        flat_(flat),
        clusters_(clustering.clusters),
        representatives_(clustering.representatives),
        parallel_(parallel),
        in_use_(clusters_.cells(), false) {
    for (const CellFace& face : clusters_.faces)
      for (int c : face.cells) in_use_[c] = true;
    place();
  }

  /// Returns the furthest that a vertex of a cell in use is from where it goes, in the mesh's unit,
  /// rounded as the mesh will hold it.
  double furthest_move() const {
    std::vector<double> furthest2(parallel_.threads(), 0.0);
    parallel_.for_ranges(static_cast<int>(clusters_.cell_of.size()),
                         [&](int begin, int end, int worker) {
                           for (int v = begin; v < end; ++v)
                             furthest2[worker] = std::max(furthest2[worker], move2(v));
                         });
    return flat_.box.diagonal * std::sqrt(*std::max_element(furthest2.begin(), furthest2.end()));
  }

  /// input: for the maps; nullptr: there are to be none.
  void run(const CarriedByCells& carried, InputVertices<MeshType>* input) {
    blend_attributes(carried.blend);
    connect_faces(carried.wedges);
    move_vertices();
    delete_vertices();
    if (input) write_map(*input);
    compact_mesh(mesh_);
    drop_polygons(mesh_, !flat_.staying.empty());
  }

 private:
  using Coordinates = typename MeshType::CoordType;
  using Vertex = typename MeshType::VertexType;

  Vertex& vertex(int c) { return mesh_.vert[representatives_.vertex[c]]; }
  bool moves(int c) { return vertex(c).cP() != point_[c]; }

  /// Where the vertex stays, it keeps its bits.
  void place() {
    point_.resize(clusters_.cells());
    for (int c = 0; c < clusters_.cells(); ++c) {
      const int v = representatives_.vertex[c];
      const Vector3& x = representatives_.position[c];
      if (x == flat_.position[v])
        point_[c] = mesh_.vert[v].cP();
      else
        assign(point_[c], flat_.box.to_user(x));
    }
  }

  /// Squared, in the unit box.
  double move2(int v) const {
    const int c = clusters_.cell_of[v];
    if (c == Clusters::none || !in_use_[c]) return 0.0;
    const Vector3 step = vector_of(point_[c]) - vector_of(mesh_.vert[v].cP());
    return (step / flat_.box.diagonal).squaredNorm();
  }

  /// All values are read before the first is written.
  void blend_attributes(const CellBlend& blend) {
    VertexAttributes(mesh_).for_each([&](auto read, auto write) {
      using Attribute = std::decay_t<decltype(read(0))>;
      std::vector<Attribute> values(clusters_.cells());
      for (int c = 0; c < clusters_.cells(); ++c)
        if (in_use_[c]) values[c] = blend.at<Attribute>(c, read, read(representatives_.vertex[c]));
      for (int c = 0; c < clusters_.cells(); ++c)
        if (in_use_[c] && !Clusters::is_fixed(clusters_.keys[c]))
          write(representatives_.vertex[c], values[c]);
    });
  }

  void connect_faces(const std::optional<std::vector<FaceWedges>>& wedges) {
    std::vector<bool> left(flat_.faces.size(), false);
    for (std::size_t i = 0; i < clusters_.faces.size(); ++i) {
      const CellFace& face = clusters_.faces[i];
      left[face.origin] = true;
      if (wedges) write_wedges(mesh_.face[face.origin], (*wedges)[i]);
      const auto [a, b, c] = face.cells;
      const std::vector<Vector3>& at = representatives_.position;
      connect_face(mesh_, face.origin, {&vertex(a), &vertex(b), &vertex(c)},
                   moves(a) || moves(b) || moves(c), face_plane({at[a], at[b], at[c]}).normal);
    }
    for (std::size_t f = 0; f < left.size(); ++f)
      if (!left[f] && FlatMesh::is_face(flat_.faces[f]))
        vcg::tri::Allocator<MeshType>::DeleteFace(mesh_, mesh_.face[f]);
  }

  void move_vertices() {
    for (int c = 0; c < clusters_.cells(); ++c)
      if (in_use_[c]) vertex(c).P() = point_[c];
  }

  /// Those that no face uses any more, and, where all faces may change, those that none used
  /// before.
  void delete_vertices() {
    const bool all_may_change = flat_.staying.empty();
    for (std::size_t v = 0; v < mesh_.vert.size(); ++v) {
      if (mesh_.vert[v].IsD() || flat_.role[v] == VertexRole::Fixed) continue;
      const int c = clusters_.cell_of[v];
      const bool stays = c == Clusters::none
                             ? !all_may_change
                             : in_use_[c] && representatives_.vertex[c] == static_cast<int>(v);
      if (!stays) vcg::tri::Allocator<MeshType>::DeleteVertex(mesh_, mesh_.vert[v]);
    }
  }

  void write_map(InputVertices<MeshType>& input) {
    for (int v = 0; v < input.count(); ++v)
      if (const int c = clusters_.cell_of[v]; c != Clusters::none)
        input.set(v, in_use_[c] ? representatives_.vertex[c] : InputVertices<MeshType>::none);
    input.write(mesh_, parallel_);
  }

  MeshType& mesh_;
  const FlatMesh& flat_;
  const Clusters& clusters_;
  const Representatives& representatives_;
  const Parallel& parallel_;
  std::vector<bool> in_use_;        // by cell: whether a face uses it
  std::vector<Coordinates> point_;  // by cell: where its vertex goes, in the mesh's own scalar
};

/// Makes the host's mesh what its clustering left.
template <class MeshType>
void write_back(MeshType& mesh, const FlatMesh& flat, const Clustering& clustering,
                const CarriedByCells& carried, std::optional<InputVertices<MeshType>> input,
                const Parallel& parallel, ClusteringReport& report) {
  ClusterWriteBack<MeshType> back(mesh, flat, clustering, parallel);
  report.largest_move = back.furthest_move();
  back.run(carried, input ? &*input : nullptr);
  report.faces = mesh.fn, report.vertices = mesh.vn;
}

}  // namespace curvdecim::detail
