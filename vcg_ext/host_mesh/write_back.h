// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/allocate.h>
#include <vcg/complex/complex.h>

#include <algorithm>
#include <type_traits>
#include <vector>

#include "vcg_ext/attributes/carried.h"
#include "vcg_ext/host_mesh/attributes.h"
#include "vcg_ext/host_mesh/change_mesh.h"
#include "vcg_ext/host_mesh/working_copy.h"
#include "vcg_ext/report.h"

namespace curvdecim::detail {

/// Puts the decimated arrays back into the vcg mesh that they were taken from. What was not touched
/// keeps its bits. Afterwards the mesh is compact and its adjacency relations are empty.
template <class MeshType>
class WriteBack {
 public:
  WriteBack(MeshType& mesh, const WorkingCopy& copy)
      : mesh_(mesh),
        copy_(copy),
        moved_(copy.mesh.position.size(), false),
        place_of_(copy.vertex_of.size(), none) {}

  void run(const Carried& carried) {
    place_vertices();
    blend_attributes(carried);
    for (const auto [to, from] : carried.new_faces.copies())
      mesh_.face[to].ImportData(mesh_.face[from]);
    if (carried.wedges) write_all_wedges(*carried.wedges);
    move_vertices();
    const std::vector<bool> used_before = used_vertices();
    connect_faces();
    delete_vertices(used_before);
    compact_mesh(mesh_);
  }

 private:
  using Vertex = typename MeshType::VertexType;

  static constexpr int none = -1;

  const TriangleConnectivity& connectivity() const { return copy_.mesh.connectivity; }
  bool in_use(int v) const { return connectivity().faces_of(v).size() > 0; }
  int start_of(int v) const { return copy_.mesh.vertex_origin[v]; }
  Vertex& vertex(int v) { return mesh_.vert[place_of_[start_of(v)]]; }
  /// v: the number at the start.
  const Vertex& start_vertex(int v) const { return mesh_.vert[copy_.vertex_of[v]]; }

  /// The first of those that are left of a host's vertex goes there, and each of the others to a
  /// new one with all that it carries.
  void place_vertices() {
    std::vector<bool> taken(mesh_.vert.size(), false);
    std::vector<int> copied;
    for (int v = 0; v < connectivity().vertex_slots(); ++v) {
      if (!in_use(v)) continue;
      const int own = copy_.vertex_of[start_of(v)];
      place_of_[start_of(v)] = taken[own] ? static_cast<int>(taken.size() + copied.size()) : own;
      if (taken[own]) copied.push_back(own);
      taken[own] = true;
    }
    add_copies_of(copied);
  }

  void add_copies_of(const std::vector<int>& vertices) {
    if (vertices.empty()) return;
    std::size_t place = mesh_.vert.size();
    vcg::tri::Allocator<MeshType>::AddVertices(mesh_, vertices.size());
    for (int v : vertices) {
      mesh_.vert[place].ImportData(mesh_.vert[v]);
      for (const auto& attribute : mesh_.vert_attr)
        attribute._handle->CopyValue(place, v, attribute._handle);
      ++place;
    }
  }

  void move_vertices() {
    for (int v = 0; v < connectivity().vertex_slots(); ++v) {
      if (!in_use(v)) continue;
      auto& p = vertex(v).P();
      const Vector3& x = copy_.mesh.position[v];
      moved_[v] = x != copy_.box.to_box(vector_of(p));
      if (moved_[v]) assign(p, copy_.box.to_user(x));
    }
  }

  void connect_faces() {
    std::vector<bool> stays(mesh_.face.size(), false);
    for (int f : copy_.left_alone) stays[f] = true;
    for (int f = 0; f < connectivity().face_slots(); ++f) {
      if (!connectivity().alive(f)) continue;
      stays[copy_.mesh.face_origin[f]] = true;
      const auto [a, b, c] = connectivity().face(f);
      connect_face(mesh_, copy_.mesh.face_origin[f], {&vertex(a), &vertex(b), &vertex(c)},
                   moved_[a] || moved_[b] || moved_[c], copy_.mesh.plane[f].normal);
    }
    for (std::size_t f = 0; f < stays.size(); ++f)
      if (!stays[f] && !mesh_.face[f].IsD())
        vcg::tri::Allocator<MeshType>::DeleteFace(mesh_, mesh_.face[f]);
  }

  /// Tells by vertex of the host's mesh whether a face uses it.
  std::vector<bool> used_vertices() const {
    std::vector<bool> used(mesh_.vert.size(), false);
    for (const auto& face : mesh_.face)
      for (int i = 0; i < 3 && !face.IsD(); ++i) used[vcg::tri::Index(mesh_, face.cV(i))] = true;
    return used;
  }

  /// Deletes vertices that lost their last face, be it by a collapse or by a repair.
  void delete_vertices(const std::vector<bool>& used_before) {
    const std::vector<bool> used = used_vertices();
    for (std::size_t v = 0; v < used.size(); ++v)
      if (used_before[v] && !used[v])
        vcg::tri::Allocator<MeshType>::DeleteVertex(mesh_, mesh_.vert[v]);
  }

  void write_all_wedges(const WedgeTexture& wedges) {
    for (int f = 0; f < connectivity().face_slots(); ++f)
      if (connectivity().alive(f))
        write_wedges(mesh_.face[copy_.mesh.face_origin[f]], wedges.of_face(f));
  }

  // --- attributes: double while they are blended, so that rounding does not add up ---------------

  /// read(vertex) -> Value, write(vertex, Value).
  template <class Value, class Read, class Write>
  void blend(const Carried& steps, Read read, Write write) {
    std::vector<Value> values(copy_.vertex_of.size());
    for (std::size_t v = 0; v < values.size(); ++v)
      values[v] = read(start_vertex(static_cast<int>(v)));
    const std::vector<Value> input = steps.resampled.empty() ? std::vector<Value>() : values;
    replay(steps.blended, values);
    resample(steps.resampled, input, values);
    std::vector<bool> changed(values.size(), false);
    const auto note = [&](const BlendStep& step) { changed[step.keep] = true; };
    steps.blended.for_each(note);
    std::for_each(steps.resampled.begin(), steps.resampled.end(), note);
    for (std::size_t v = 0; v < values.size(); ++v)
      if (changed[v] && place_of_[v] != none) write(mesh_.vert[place_of_[v]], values[v]);
  }

  void blend_attributes(const Carried& steps) {
    VertexAttributes<MeshType>::for_each(mesh_, [&](auto read, auto write) {
      blend<std::decay_t<decltype(read(mesh_.vert[0]))>>(steps, read, write);
    });
  }

  MeshType& mesh_;
  const WorkingCopy& copy_;
  std::vector<bool> moved_;    // by working vertex
  std::vector<int> place_of_;  // by working vertex at the start: where in the host's mesh it goes
};

/// Makes the host's mesh what the run made of its working copy.
template <class MeshType>
void write_back(MeshType& mesh, const WorkingCopy& copy, const Carried& carried,
                DecimationReport& report) {
  WriteBack<MeshType>(mesh, copy).run(carried);
  report.faces = mesh.fn, report.vertices = mesh.vn;
}

}  // namespace curvdecim::detail
