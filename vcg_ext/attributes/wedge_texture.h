// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "vcg_ext/attributes/charts.h"
#include "vcg_ext/attributes/corner_values.h"
#include "vcg_ext/collapse/collapse_observer.h"
#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/mesh/wedges.h"
#include "vcg_ext/removal/removal_observer.h"

namespace curvdecim::detail {

/// Carries wedge texture coordinates through the collapses, or through removals of vertices, where
/// every corner keeps those that its vertex has on its side of a seam. In a collapse the corners
/// around the edge fall into charts (charts.h). All corners of a chart take the coordinates of the
/// chart's surface point nearest to the merged vertex, so that a chart does not tear and two charts
/// do not mix.
class WedgeTexture : public CollapseObserver, public RemovalObserver {
 public:
  explicit WedgeTexture(std::vector<FaceWedges> wedges) : wedges_(std::move(wedges)) {}

  void make_room(int) override {}

  void before(const WorkingMesh& mesh, const EdgeNeighborhood& around, const VertexMerge& merge,
              int) override {
    const auto charts = charts_around<WedgeCoordinate>(mesh, around, merge,
                                                       [&](int f, int i) { return wedges_[f][i]; });
    for (const Charted& chart : charts) move_corners(mesh, chart, around, merge);
  }

  void before(const WorkingMesh& mesh, const VertexFan&,
              const std::vector<NewFace>& faces) override {
    std::vector<FaceWedges> now(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (int k = 0; k < 3; ++k)
        now[i][k] = wedges_.at(mesh, faces[i].source[k], faces[i].corners[k]);
    for (std::size_t i = 0; i < faces.size(); ++i) wedges_[faces[i].slot] = now[i];
  }

  void added(const WorkingMesh& mesh, int f) override { wedges_.add(mesh, f); }

  void renumber(const Renumbering& numbers) override { wedges_.renumber(numbers); }

  const FaceWedges& of_face(int f) const { return wedges_[f]; }

  // --- refinement, once the collapses are done ---------------------------------------------------

  CornerValues<WedgeCoordinate>& values() { return wedges_; }
  const CornerValues<WedgeCoordinate>& values() const { return wedges_; }

  /// Before vertices that are on no seam go from the mesh's positions to others.
  void move(const WorkingMesh& mesh, const std::vector<Vector3>& now) {
    std::vector<std::pair<int, WedgeCoordinate>> moved;
    for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v) {
      if (now[v] == mesh.position[v]) continue;
      moved.push_back({v, nearest(mesh, mesh.connectivity.faces_of(v), now[v])});
    }
    for (const auto& [v, coordinate] : moved)
      for (int f : mesh.connectivity.faces_of(v)) wedges_.at(mesh, f, v) = coordinate;
  }

 private:
  using Charted = Chart<WedgeCoordinate>;

  /// Corners of a vertex that stays keep their bits.
  void move_corners(const WorkingMesh& mesh, const Charted& chart, const EdgeNeighborhood& around,
                    const VertexMerge& merge) {
    const WedgeCoordinate moved = nearest(mesh, chart.faces, merge.now);
    const bool keep_stays = merge.now == merge.keep_was;
    for (int f : chart.faces)
      for (int i = 0; i < 3; ++i) {
        const int v = mesh.connectivity.face(f)[i];
        if (is_wing(around, f)) continue;  // goes anyway, and others still read it
        if (v == merge.gone || (v == merge.keep && !keep_stays)) wedges_[f][i] = moved;
      }
  }

  template <class Faces>
  WedgeCoordinate nearest(const WorkingMesh& mesh, const Faces& faces, const Vector3& x) const {
    const FacePoint point = nearest_point(faces, mesh, x);
    if (point.face < 0) return {};
    const FaceWedges& wedges = wedges_[point.face];
    return {point.blended(wedges, &WedgeCoordinate::u), point.blended(wedges, &WedgeCoordinate::v),
            wedges[0].page};
  }

  CornerValues<WedgeCoordinate> wedges_;
};

}  // namespace curvdecim::detail
