// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/collapse/collapse_observer.h"
#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/mesh/wedges.h"
#include "vcg_ext/removal/removal_observer.h"

namespace curvdecim::detail {

/// Carries wedge texture coordinates through the collapses, or through removals of vertices, where
/// every corner keeps those that its vertex has on its side of a seam. In a collapse the corners
/// around the edge fall into charts: those at one vertex with the same coordinates, and those that
/// a face at the edge joins. All corners of a chart take the coordinates of the chart's surface
/// point nearest to the merged vertex, so that a chart does not tear and two charts do not mix.
class WedgeTexture : public CollapseObserver, public RemovalObserver {
 public:
  explicit WedgeTexture(std::vector<FaceWedges> wedges) : wedges_(std::move(wedges)) {}

  void make_room(int) override {}

  void before(const WorkingMesh& mesh, const EdgeNeighborhood& around, const VertexMerge& merge,
              int) override {
    std::vector<Chart> charts;
    for (const auto* faces : {&around.wings(), &around.star()})
      for (int f : *faces) join_chart(mesh, f, merge, charts);
    for (const Chart& chart : charts) move_corners(mesh, chart, around, merge);
  }

  void before(const WorkingMesh& mesh, const VertexFan&,
              const std::vector<NewFace>& faces) override {
    std::vector<FaceWedges> now(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (int k = 0; k < 3; ++k) now[i][k] = corner(mesh, faces[i].source[k], faces[i].corners[k]);
    for (std::size_t i = 0; i < faces.size(); ++i) wedges_[faces[i].slot] = now[i];
  }

  void renumber(const Renumbering& numbers) override { numbers.faces(wedges_); }

  const FaceWedges& of_face(int f) const { return wedges_[f]; }

  // --- refinement, once the collapses are done ---------------------------------------------------

  /// True if a vertex has different coordinates in different faces.
  bool on_seam(const WorkingMesh& mesh, int v) const {
    const auto faces = mesh.connectivity.faces_of(v);
    const auto differs = [&](int f) {
      return !(corner(mesh, f, v) == corner(mesh, *faces.begin(), v));
    };
    return std::any_of(faces.begin(), faces.end(), differs);
  }

  /// True if two faces do not agree about an end of their edge.
  bool is_seam(const WorkingMesh& mesh, int f, int g, int a, int b) const {
    return !(corner(mesh, f, a) == corner(mesh, g, a)) ||
           !(corner(mesh, f, b) == corner(mesh, g, b));
  }

  /// Before TriangleConnectivity::flip of an edge that is no seam.
  void flip(const WorkingMesh& mesh, int f, int g, int a, int b) {
    const int c = mesh.connectivity.third_vertex(f, a, b);
    const int d = mesh.connectivity.third_vertex(g, a, b);
    const WedgeCoordinate at_c = corner(mesh, f, c), at_d = corner(mesh, g, d);
    wedges_[f][mesh.connectivity.corner(f, b)] = at_d;
    wedges_[g][mesh.connectivity.corner(g, a)] = at_c;
  }

  /// Before vertices that are on no seam go from the mesh's positions to others.
  void move(const WorkingMesh& mesh, const std::vector<Vector3>& now) {
    std::vector<std::pair<int, WedgeCoordinate>> moved;
    for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v) {
      if (now[v] == mesh.position[v]) continue;
      const auto faces = mesh.connectivity.faces_of(v);
      moved.push_back({v, nearest(mesh, {{}, {faces.begin(), faces.end()}}, now[v])});
    }
    for (const auto& [v, coordinate] : moved)
      for (int f : mesh.connectivity.faces_of(v))
        wedges_[f][mesh.connectivity.corner(f, v)] = coordinate;
  }

 private:
  const WedgeCoordinate& corner(const WorkingMesh& mesh, int f, int v) const {
    return wedges_[f][mesh.connectivity.corner(f, v)];
  }

  struct Corner {
    int vertex;
    WedgeCoordinate at;
  };
  struct Chart {
    std::vector<Corner> corners;
    std::vector<int> faces;
  };

  void join_chart(const WorkingMesh& mesh, int f, const VertexMerge& merge,
                  std::vector<Chart>& charts) const {
    std::vector<Corner> corners;
    for (int i = 0; i < 3; ++i)
      if (const int v = mesh.connectivity.face(f)[i]; v == merge.keep || v == merge.gone)
        corners.push_back({v, wedges_[f][i]});
    for (Chart& chart : charts)
      if (shares_corner(chart, corners)) {
        chart.corners.insert(chart.corners.end(), corners.begin(), corners.end());
        chart.faces.push_back(f);
        return;
      }
    charts.push_back({corners, {f}});
  }

  static bool shares_corner(const Chart& chart, const std::vector<Corner>& corners) {
    for (const Corner& known : chart.corners)
      for (const Corner& corner : corners)
        if (known.vertex == corner.vertex && known.at == corner.at) return true;
    return false;
  }

  /// Corners of a vertex that stays keep their bits.
  void move_corners(const WorkingMesh& mesh, const Chart& chart, const EdgeNeighborhood& around,
                    const VertexMerge& merge) {
    const WedgeCoordinate moved = nearest(mesh, chart, merge.now);
    const bool keep_stays = merge.now == merge.keep_was;
    for (int f : chart.faces)
      for (int i = 0; i < 3; ++i) {
        const int v = mesh.connectivity.face(f)[i];
        if (is_wing(around, f)) continue;  // goes anyway, and others still read it
        if (v == merge.gone || (v == merge.keep && !keep_stays)) wedges_[f][i] = moved;
      }
  }

  static bool is_wing(const EdgeNeighborhood& around, int f) {
    for (int wing : around.wings())
      if (wing == f) return true;
    return false;
  }

  WedgeCoordinate nearest(const WorkingMesh& mesh, const Chart& chart, const Vector3& x) const {
    WedgeCoordinate result;
    double least = std::numeric_limits<double>::infinity();
    for (int f : chart.faces) {
      const Triangle triangle = mesh.triangle(f);
      const Barycentric w = closest_point(triangle, x);
      const double distance2 = (at(triangle, w) - x).squaredNorm();
      if (distance2 >= least) continue;
      least = distance2;
      result = {0.0, 0.0, wedges_[f][0].page};
      for (int i = 0; i < 3; ++i) {
        if (w[i] == 0.0) continue;  // the corner may not be a number
        result.u += w[i] * wedges_[f][i].u, result.v += w[i] * wedges_[f][i].v;
      }
    }
    return result;
  }

  std::vector<FaceWedges> wedges_;  // by face
};

}  // namespace curvdecim::detail
