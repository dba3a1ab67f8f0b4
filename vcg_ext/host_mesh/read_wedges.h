// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <utility>
#include <vector>

#include "vcg_ext/host_mesh/attributes.h"
#include "vcg_ext/host_mesh/face_groups.h"
#include "vcg_ext/host_mesh/join_borders.h"
#include "vcg_ext/host_mesh/working_copy.h"

namespace curvdecim::detail {

/// Tells the corners at each vertex apart by what they carry: their wedge texture coordinates, the
/// groups of their faces, and the host's vertices, of which the vertex may stand for several.
template <class MeshType>
class WedgeReader {
 public:
  WedgeReader(const MeshType& mesh, WorkingCopy& copy, const FaceGroups<MeshType>& groups)
      : mesh_(mesh),
        copy_(copy),
        groups_(groups),
        has_texture_(vcg::tri::HasPerWedgeTexCoord(mesh)),
        next_(copy.vertex_of.size(), Wedges::none),
        corner_(copy.vertex_of.size()) {}

  /// Gives the copy its wedges, if some vertex needs them or the faces have a texture. Returns
  /// whether wedges of a vertex differ in what the host's vertices carry.
  bool read() {
    std::vector<Face> of_face(copy_.mesh.face_origin.size());
    for (std::size_t f = 0; f < of_face.size(); ++f) {
      for (int i = 0; i < 3; ++i)
        of_face[f][i] = wedge_of(copy_.mesh.connectivity.face(static_cast<int>(f))[i],
                                 corner_of(copy_.mesh.face_origin[f], i));
    }
    if (!has_texture_ && !differ_ && !groups_.exist()) return false;
    copy_.mesh.wedges = Wedges(std::move(of_face), static_cast<int>(corner_.size()));
    for (const Corner& corner : corner_)
      if (has_texture_) copy_.mesh.texture.emplace_back(corner.at.u, corner.at.v);
    return differ_;
  }

 private:
  struct Corner {
    int host = Wedges::none;
    int face = Wedges::none;  // of the host, or another one of its group
    WedgeCoordinate at;
  };

  Corner corner_of(int f, int i) const {
    const auto& face = mesh_.face[f];
    return {static_cast<int>(vcg::tri::Index(mesh_, face.cV(i))), f,
            has_texture_ ? wedges_of(face)[i] : WedgeCoordinate()};
  }

  /// The wedge of v that carries what the corner does; a new one if there is none.
  int wedge_of(int v, const Corner& corner) {
    if (corner_[v].host == Wedges::none) return set_first(v, corner);
    int same_host = Wedges::none;
    for (int wedge = v;; wedge = next_[wedge]) {
      if (are_one(copy_.vertex_of[wedge], corner.host)) {
        if (same(corner_[wedge].at, corner.at) && groups_.are_one(corner_[wedge].face, corner.face))
          return wedge;
        same_host = wedge;
      }
      if (next_[wedge] == Wedges::none) return add(wedge, corner, same_host);
    }
  }

  int set_first(int v, const Corner& corner) {
    corner_[v] = corner;
    if (!are_one(copy_.vertex_of[v], corner.host)) copy_.vertex_of[v] = corner.host;
    return v;
  }

  /// After the last one of its vertex.
  int add(int last, const Corner& corner, int same_host) {
    const bool is_new_host = same_host == Wedges::none;
    differ_ = differ_ || is_new_host;
    next_[last] = static_cast<int>(corner_.size());
    next_.push_back(Wedges::none), corner_.push_back(corner);
    copy_.vertex_of.push_back(is_new_host ? corner.host : copy_.vertex_of[same_host]);
    return next_[last];
  }

  bool are_one(int host, int other) const {
    return host == other || carry_the_same(mesh_, host, other);
  }

  /// A coordinate that is not a number is the same as another such one.
  static bool same(const WedgeCoordinate& a, const WedgeCoordinate& b) {
    const auto equal = [](double x, double y) { return x == y || (x != x && y != y); };
    return equal(a.u, b.u) && equal(a.v, b.v) && a.page == b.page;
  }

  const MeshType& mesh_;
  WorkingCopy& copy_;
  const FaceGroups<MeshType>& groups_;
  const bool has_texture_;
  bool differ_ = false;
  std::vector<int> next_;       // by wedge: another one of its vertex
  std::vector<Corner> corner_;  // by wedge; the first ones are the vertices
};

/// Tells corners apart where what they carry asks for it. Returns whether wedges of a vertex differ
/// in what the host's vertices carry. Appends the wedges beyond the vertices to copy.vertex_of.
template <class MeshType>
bool read_wedges(const MeshType& mesh, WorkingCopy& copy, KeepBordersOf keep_borders_of) {
  const FaceGroups<MeshType> groups(mesh, keep_borders_of);
  if (copy.borders_joined == 0 && !vcg::tri::HasPerWedgeTexCoord(mesh) && !groups.exist())
    return false;
  return WedgeReader<MeshType>(mesh, copy, groups).read();
}

}  // namespace curvdecim::detail
