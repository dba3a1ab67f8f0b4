// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/attributes/corner_copies.h"
#include "vcg_ext/host_mesh/working_copy.h"
#include "vcg_ext/mesh/border_seams.h"

namespace curvdecim::detail {

template <class MeshType>
bool have_the_same_custom_values(const MeshType& mesh, int v, int w) {
  return std::all_of(mesh.vert_attr.begin(), mesh.vert_attr.end(), [&](const auto& attribute) {
    const auto* values = attribute._handle;
    return std::memcmp(values->At(v), values->At(w), values->SizeOf()) == 0;
  });
}

/// True if two vertices of the host's mesh carry the same. Normals do not count: a host computes
/// them, and at a crease every copy has that of its own faces.
template <class MeshType>
bool carry_the_same(const MeshType& mesh, int v, int w) {
  const auto &a = mesh.vert[v], &b = mesh.vert[w];
  return (!vcg::tri::HasPerVertexColor(mesh) || a.cC() == b.cC()) &&
         (!vcg::tri::HasPerVertexQuality(mesh) || a.cQ() == b.cQ()) &&
         (!vcg::tri::HasPerVertexRadius(mesh) || a.cR() == b.cR()) &&
         (!vcg::tri::HasPerVertexTexCoord(mesh) || a.cT() == b.cT()) &&
         (!vcg::tri::HasPerVertexCurvatureDir(mesh) ||
          (a.cPD1() == b.cPD1() && a.cPD2() == b.cPD2() && a.cK1() == b.cK1() &&
           a.cK2() == b.cK2())) &&
         have_the_same_custom_values(mesh, v, w);
}

/// Joins borders that lie on each other. The first one of the host's vertices in a place stands for
/// the others.
inline void join_borders(WorkingCopy& copy, const Parallel& parallel) {
  BorderSeams seams(copy.mesh, parallel);
  Revertexed joined = seams.join();
  if (joined.faces.empty()) return;
  copy.borders_joined = seams.joined();
  reconnect(copy, std::move(joined), parallel);
}

/// Tells the copies of each corner, where one vertex stands for several of the host's.
template <class MeshType>
class CopyReader {
 public:
  CopyReader(const MeshType& mesh, const WorkingCopy& copy)
      : mesh_(mesh), copy_(copy), host_(copy.vertex_of), next_(host_.size(), none) {}

  /// nullopt: all that were joined carry the same.
  std::optional<CornerCopies> read() {
    std::vector<Face> of_corner(copy_.mesh.face_origin.size());
    for (std::size_t f = 0; f < of_corner.size(); ++f) {
      const auto& face = mesh_.face[copy_.mesh.face_origin[f]];
      for (int i = 0; i < 3; ++i)
        of_corner[f][i] = copy_of(copy_.mesh.connectivity.face(static_cast<int>(f))[i],
                                  static_cast<int>(vcg::tri::Index(mesh_, face.cV(i))));
    }
    if (host_.size() == copy_.vertex_of.size()) return std::nullopt;
    return CornerCopies(std::move(of_corner), std::move(host_));
  }

 private:
  static constexpr int none = -1;

  /// The copy of v that carries what the host's vertex does; a new one if there is none.
  int copy_of(int v, int host) {
    int copy = v;
    for (; host_[copy] != host && !carry_the_same(mesh_, host_[copy], host); copy = next_[copy]) {
      if (next_[copy] != none) continue;
      next_[copy] = static_cast<int>(host_.size());
      host_.push_back(host), next_.push_back(none);
    }
    return copy;
  }

  const MeshType& mesh_;
  const WorkingCopy& copy_;
  std::vector<int> host_;  // by copy; the first ones are the vertices
  std::vector<int> next_;  // by copy: another one of its vertex
};

/// nullopt: no vertex stands for several that carry different values.
template <class MeshType>
std::optional<CornerCopies> read_copies(const MeshType& mesh, const WorkingCopy& copy) {
  if (copy.borders_joined == 0) return std::nullopt;
  return CopyReader<MeshType>(mesh, copy).read();
}

}  // namespace curvdecim::detail
