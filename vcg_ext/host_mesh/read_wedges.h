// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "vcg_ext/host_mesh/attributes.h"
#include "vcg_ext/host_mesh/face_groups.h"
#include "vcg_ext/host_mesh/host_texture.h"
#include "vcg_ext/host_mesh/join_borders.h"
#include "vcg_ext/host_mesh/working_copy.h"

namespace curvdecim::detail {

/// Tells the corners at each vertex apart by what they carry: their texture coordinates, the groups
/// of their faces, and the host's vertices, of which the vertex may stand for several.
template <class MeshType>
class WedgeReader {
 public:
  WedgeReader(const MeshType& mesh, WorkingCopy& copy, const HostTexture<MeshType>& texture,
              const FaceGroups<MeshType>& groups, const Parallel& parallel)
      : mesh_(mesh),
        copy_(copy),
        texture_(texture),
        groups_(groups),
        parallel_(parallel),
        vertices_(static_cast<int>(copy.vertex_of.size())),
        wedges_(copy.mesh.face_origin.size()),
        others_(vertices_ + 1, 0) {}

  /// Gives the copy its wedges, if some vertex needs them or the faces have a texture. Returns
  /// whether wedges of a vertex differ in what the host's vertices carry.
  bool read() {
    for_each_vertex([&](int v, const std::vector<Corner>& wedges) {
      others_[v + 1] = std::max(0, static_cast<int>(wedges.size()) - 1);
    });
    for (int v = 0; v < vertices_; ++v) others_[v + 1] += others_[v];
    if (others_.back() == 0 && !texture_.exists() && !groups_.exist()) return false;
    copy_.vertex_of.resize(count());
    if (texture_.exists()) copy_.mesh.texture.resize(count());
    for_each_vertex([&](int v, const std::vector<Corner>& wedges) { number(v, wedges); });
    copy_.mesh.wedges = Wedges(std::move(wedges_), count());
    return differ();
  }

 private:
  struct Corner {
    int host = Wedges::none;
    int face = Wedges::none;  // of the host, or another one of its group
    WedgeCoordinate at;
  };

  int count() const { return vertices_ + others_.back(); }

  /// use(v, wedges), after the wedges of v are numbered from 0 in the faces around it.
  template <class Use>
  void for_each_vertex(Use use) {
    parallel_.for_ranges(vertices_, [&](int begin, int end, int) {
      std::vector<Corner> wedges;
      for (int v = begin; v < end; ++v) {
        tell_apart(v, wedges);
        use(v, wedges);
      }
    });
  }

  /// In the order in which they are met.
  void tell_apart(int v, std::vector<Corner>& wedges) {
    wedges.clear();
    for (int f : copy_.mesh.connectivity.faces_of(v)) {
      const int i = copy_.mesh.connectivity.corner(f, v);
      Corner corner = corner_of(copy_.mesh.face_origin[f], i);
      const auto known = std::find_if(wedges.begin(), wedges.end(),
                                      [&](const Corner& other) { return are_one(corner, other); });
      wedges_[f][i] = static_cast<int>(known - wedges.begin());
      if (known != wedges.end()) continue;
      corner.host = spokesman(v, corner.host, wedges);
      wedges.push_back(corner);
    }
  }

  /// The vertex of the host that stands for those in one place that carry the same.
  int spokesman(int v, int host, const std::vector<Corner>& wedges) const {
    if (are_one_host(copy_.vertex_of[v], host)) return copy_.vertex_of[v];
    for (const Corner& known : wedges)
      if (are_one_host(known.host, host)) return known.host;
    return host;
  }

  /// Vertex v has wedge v; the others come after all vertices.
  void number(int v, const std::vector<Corner>& wedges) {
    const auto number_of = [&](int k) { return k == 0 ? v : vertices_ + others_[v] + k - 1; };
    for (std::size_t k = 0; k < wedges.size(); ++k) {
      const int wedge = number_of(static_cast<int>(k));
      copy_.vertex_of[wedge] = wedges[k].host;
      if (texture_.exists()) copy_.mesh.texture[wedge] = {wedges[k].at.u, wedges[k].at.v};
    }
    for (int f : copy_.mesh.connectivity.faces_of(v)) {
      int& wedge = wedges_[f][copy_.mesh.connectivity.corner(f, v)];
      wedge = number_of(wedge);
    }
  }

  bool differ() const {
    for (int v = 0; v < vertices_; ++v)
      for (int other = others_[v]; other < others_[v + 1]; ++other)
        if (copy_.vertex_of[vertices_ + other] != copy_.vertex_of[v]) return true;
    return false;
  }

  Corner corner_of(int f, int i) const {
    const auto& face = mesh_.face[f];
    return {static_cast<int>(vcg::tri::Index(mesh_, face.cV(i))), f, texture_.at(f, i)};
  }

  bool are_one(const Corner& a, const Corner& b) const {
    return are_one_host(a.host, b.host) && same(a.at, b.at) && groups_.are_one(a.face, b.face);
  }

  bool are_one_host(int host, int other) const {
    return host == other || carry_the_same(mesh_, host, other);
  }

  /// A coordinate that is not a number is the same as another such one.
  static bool same(const WedgeCoordinate& a, const WedgeCoordinate& b) {
    const auto equal = [](double x, double y) { return x == y || (x != x && y != y); };
    return equal(a.u, b.u) && equal(a.v, b.v) && a.page == b.page;
  }

  const MeshType& mesh_;
  WorkingCopy& copy_;
  const HostTexture<MeshType>& texture_;
  const FaceGroups<MeshType>& groups_;
  const Parallel& parallel_;
  const int vertices_;
  std::vector<Face> wedges_;  // by face
  std::vector<int> others_;   // by vertex: wedges beyond the first, of all before it
};

/// Tells corners apart where what they carry asks for it. Returns whether wedges of a vertex differ
/// in what the host's vertices carry. Appends the wedges beyond the vertices to copy.vertex_of.
template <class MeshType>
bool read_wedges(const MeshType& mesh, WorkingCopy& copy, KeepBordersOf keep_borders_of,
                 const Parallel& parallel) {
  const HostTexture<MeshType> texture(mesh, parallel);
  const FaceGroups<MeshType> groups(mesh, keep_borders_of);
  if (copy.borders_joined == 0 && !texture.exists() && !groups.exist()) return false;
  return WedgeReader<MeshType>(mesh, copy, texture, groups, parallel).read();
}

}  // namespace curvdecim::detail
