// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <utility>
#include <vector>

#include "vcg_ext/clustering/cell_attributes.h"
#include "vcg_ext/mesh/wedge_coordinate.h"

namespace curvdecim::detail {

/// Texture coordinates by wedge. The corners in a cell fall into charts: those at one vertex with
/// the same coordinates, and those that a face joins within the cell. A chart takes the coordinates
/// of its own surface point nearest to the cell's new vertex, so that no face spans two charts.
class CellTexture {
 public:
  /// wedges: by face.
  CellTexture(const FlatMesh& mesh, const Clusters& clusters, std::vector<FaceWedges> wedges)
      : mesh_(mesh), clusters_(clusters), wedges_(std::move(wedges)) {
    number_corners();
    join_charts();
  }

  /// By the faces of the clusters: what their corners have now.
  std::vector<FaceWedges> at(const Representatives& representatives,
                             const Parallel& parallel) const {
    const Groups faces = faces_by_chart();
    std::vector<FaceWedges> result(clusters_.faces.size());
    parallel.for_each(
        static_cast<int>(result.size()),
        [&](int i) {
          const CellFace& face = clusters_.faces[i];
          for (int k = 0; k < 3; ++k)
            result[i][k] = nearest(faces[chart_[3 * face.origin + k]],
                                   representatives.position[face.cells[k]]);
        },
        Parallel::heavy);
    return result;
  }

  /// True if one vertex has different coordinates in different faces.
  bool has_seams() const { return has_seams_; }

 private:
  int faces() const { return static_cast<int>(mesh_.faces.size()); }
  bool exists(int f) const { return FlatMesh::is_face(mesh_.faces[f]); }

  static std::uint64_t bits(double number) {
    std::uint64_t result;
    std::memcpy(&result, &number, sizeof result);
    return result;
  }

  /// One number for the corners at a vertex with the same coordinates.
  void number_corners() {
    FirstSeen<std::array<std::uint64_t, 3>> seen;
    std::vector<bool> known(mesh_.position.size(), false);
    chart_.resize(3 * mesh_.faces.size());
    for (int f = 0; f < faces(); ++f)
      for (int k = 0; k < 3 && exists(f); ++k) {
        const int v = mesh_.faces[f][k], before = seen.size();
        const WedgeCoordinate& at = wedges_[f][k];
        const auto place = std::uint64_t(std::uint32_t(v)) << 32 | std::uint32_t(at.page);
        chart_[3 * f + k] = seen.number({place, bits(at.u), bits(at.v)});
        has_seams_ = has_seams_ || (seen.size() > before && known[v]);
        known[v] = true;
      }
    parent_.resize(seen.size());
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// Then a chart has one number.
  void join_charts() {
    for (int f = 0; f < faces(); ++f)
      for (int k = 0; k < 3 && exists(f); ++k) {
        const int next = (k + 1) % 3;
        const Face cells = clusters_.cells_of(mesh_.faces[f]);
        if (cells[k] == cells[next]) join(chart_[3 * f + k], chart_[3 * f + next]);
      }
    for (int f = 0; f < faces(); ++f)
      for (int k = 0; k < 3 && exists(f); ++k) chart_[3 * f + k] = root(chart_[3 * f + k]);
  }

  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int i, int j) {
    const int a = root(i), b = root(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  Groups faces_by_chart() const {
    return Groups(static_cast<int>(parent_.size()), faces(), [&](int f, auto take) {
      if (exists(f)) for_different({chart_[3 * f], chart_[3 * f + 1], chart_[3 * f + 2]}, take);
    });
  }

  WedgeCoordinate nearest(IndexRange faces, const Vector3& x) const {
    const FacePoint point = nearest_point(faces, mesh_, x);
    const FaceWedges& wedges = wedges_[point.face];
    return {point.blended(wedges, &WedgeCoordinate::u), point.blended(wedges, &WedgeCoordinate::v),
            wedges[0].page};
  }

  const FlatMesh& mesh_;
  const Clusters& clusters_;
  std::vector<FaceWedges> wedges_;  // by face
  std::vector<int> chart_;          // by corner, three a face
  std::vector<int> parent_;         // of the forest of numbers that are joined
  bool has_seams_ = false;
};

}  // namespace curvdecim::detail
