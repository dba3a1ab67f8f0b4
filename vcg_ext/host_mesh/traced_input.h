// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "vcg_ext/host_mesh/input_vertices.h"
#include "vcg_ext/host_mesh/working_copy.h"

namespace curvdecim::detail {

/// The vertices of the input of a run step by step, which is noted.
template <class MeshType>
class TracedInput {
 public:
  /// From now on the copy notes its merges.
  TracedInput(const MeshType& mesh, WorkingCopy& copy, const Parallel& parallel)
      : vertices_(mesh, copy.box, parallel), number_(mesh.vert.size(), none) {
    copy.mesh.merges.begin(copy.mesh.vertex_origins);
    for (int f = 0; f < copy.mesh.connectivity.face_slots(); ++f)
      for (int i = 0; i < 3; ++i) {
        const auto* vertex = mesh.face[copy.mesh.face_origin[f]].cV(i);
        int& number = number_[vcg::tri::Index(mesh, vertex)];
        if (number == none) number = copy.mesh.connectivity.face(f)[i];
      }
  }

  /// Leaves the maps with the mesh, of which nothing but compacting is left to be done. place_of:
  /// by number of the working copy (WorkingMesh::vertex_origin), where it is in the mesh; or none.
  void write(MeshType& mesh, const MergeRecord& merges, const std::vector<int>& place_of,
             const Parallel& parallel) {
    const std::vector<int> ends = merges.ends();
    for (std::size_t v = 0; v < number_.size(); ++v)
      if (number_[v] != none) vertices_.set(static_cast<int>(v), place_of[ends[number_[v]]]);
    vertices_.write(mesh, parallel);
  }

  /// The maps of a mesh that stays as it is.
  void write(MeshType& mesh, const Parallel& parallel) const { vertices_.write(mesh, parallel); }

  static constexpr int none = InputVertices<MeshType>::none;

 private:
  InputVertices<MeshType> vertices_;
  std::vector<int>
      number_;  // by vertex of the mesh: that of the working copy; none: no face has it
};

template <class MeshType>
std::optional<TracedInput<MeshType>> traced_input(const MeshType& mesh, WorkingCopy& copy,
                                                  bool is_asked_for, const Parallel& parallel) {
  if (!is_asked_for) return std::nullopt;
  return TracedInput<MeshType>(mesh, copy, parallel);
}

}  // namespace curvdecim::detail
