// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/allocate.h>
#include <vcg/complex/complex.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <optional>
#include <type_traits>
#include <vector>

#include "vcg_ext/attributes/carried.h"
#include "vcg_ext/host_mesh/attributes.h"
#include "vcg_ext/host_mesh/change_mesh.h"
#include "vcg_ext/host_mesh/traced_input.h"
#include "vcg_ext/host_mesh/working_copy.h"
#include "vcg_ext/report.h"

namespace curvdecim::detail {

/// Puts the decimated arrays back into the vcg mesh that they were taken from. What was not touched
/// keeps its bits. Afterwards the mesh is compact and its adjacency relations are empty.
template <class MeshType>
class WriteBack {
 public:
  WriteBack(MeshType& mesh, const WorkingCopy& copy, const Carried& carried,
            const Parallel& parallel)
      : mesh_(mesh),
        copy_(copy),
        carried_(carried),
        parallel_(parallel),
        used_before_(used_vertices()),
        moved_(copy.mesh.position.size(), false),
        place_of_(hosts().size(), none),
        speaker_(place_of_.size(), none) {
    find_speakers();
  }

  /// traced: for the maps; nullptr: there are to be none.
  void run(TracedInput<MeshType>* traced) {
    add_faces();
    place_vertices();
    blend_attributes();
    fill_new_faces();
    if (!copy_.mesh.texture.empty()) write_texture();
    move_vertices();
    connect_faces();
    delete_vertices();
    if (traced) traced->write(mesh_, copy_.mesh.merges, places(), parallel_);
    compact_mesh(mesh_);
    drop_polygons(mesh_, copy_.selected_only);
  }

 private:
  using Vertex = typename MeshType::VertexType;

  using Marks = std::vector<std::atomic<std::uint8_t>>;  // set from several threads

  static constexpr int none = -1;

  const TriangleConnectivity& connectivity() const { return copy_.mesh.connectivity; }

  // What is carried belongs to wedges, or to vertices by the numbers that they had at the start. Of
  // the wedges that come from one vertex of the host the lowest speaks for the others.

  /// By wedge or vertex: the host's vertex that it was.
  const std::vector<int>& hosts() const { return copy_.vertex_of; }

  /// The wedge or vertex that a corner of face f belongs to.
  int carrier(int f, int corner) const {
    return copy_.mesh.wedges.exist() ? copy_.mesh.wedges.of_face(f)[corner]
                                     : copy_.mesh.vertex_origin[connectivity().face(f)[corner]];
  }

  Vertex& vertex(int f, int corner) { return mesh_.vert[place_of_[speaker_[carrier(f, corner)]]]; }

  /// Whether two wedges of one vertex are written to one vertex.
  bool are_one(int wedge, int other) const {
    return !carried_.copies_differ || hosts()[wedge] == hosts()[other];
  }

  void find_speakers() {
    if (!copy_.mesh.wedges.exist()) return std::iota(speaker_.begin(), speaker_.end(), 0);
    std::vector<int> carriers;
    for (int v = 0; v < connectivity().vertex_slots(); ++v) {
      carriers.clear();
      for (int f : connectivity().faces_of(v))
        carriers.push_back(carrier(f, connectivity().corner(f, v)));
      std::sort(carriers.begin(), carriers.end());
      for (int wedge : carriers)
        speaker_[wedge] = *std::find_if(carriers.begin(), carriers.end(),
                                        [&](int other) { return are_one(wedge, other); });
    }
  }

  /// use(speaker, v), once for every vertex that is written.
  template <class Use>
  void for_each_speaker(Use use) const {
    std::vector<bool> seen(hosts().size(), false);
    for (int v = 0; v < connectivity().vertex_slots(); ++v)
      for (int f : connectivity().faces_of(v)) {
        const int wedge = carrier(f, connectivity().corner(f, v));
        if (speaker_[wedge] == wedge && !seen[wedge]) use(wedge, v);
        if (!copy_.mesh.wedges.exist()) break;  // all corners are of the same
        seen[wedge] = true;
      }
  }

  /// By number at the start or later: the first place of what is left of it.
  std::vector<int> places() const {
    std::vector<int> places(copy_.mesh.vertex_origins, none);
    for_each_speaker([&](int wedge, int v) {
      int& place = places[copy_.mesh.vertex_origin[v]];
      place = place == none ? place_of_[wedge] : std::min(place, place_of_[wedge]);
    });
    return places;
  }

  /// Those that the run was given beyond the host's; what they carry comes from others.
  void add_faces() {
    const std::size_t more = copy_.mesh.face_origins - mesh_.face.size();
    if (more > 0) vcg::tri::Allocator<MeshType>::AddFaces(mesh_, more);
  }

  /// The first of those that are left of a host's vertex goes there, and each of the others to a
  /// new one with all that it carries.
  void place_vertices() {
    std::vector<bool> taken(mesh_.vert.size(), false);
    std::vector<int> copied;
    for_each_speaker([&](int wedge, int) {
      const int own = hosts()[wedge];
      place_of_[wedge] = taken[own] ? static_cast<int>(taken.size() + copied.size()) : own;
      if (taken[own]) copied.push_back(own);
      taken[own] = true;
    });
    add_copies_of(copied);
  }

  void add_copies_of(const std::vector<int>& vertices) {
    if (vertices.empty()) return;
    std::size_t place = mesh_.vert.size();
    vcg::tri::Allocator<MeshType>::AddVertices(mesh_, vertices.size());
    for (int v : vertices) {
      mesh_.vert[place].ImportData(mesh_.vert[v]);
      copy_custom(mesh_.vert_attr, place, v);
      ++place;
    }
  }

  void fill_new_faces() {
    for (const auto [to, from] : carried_.new_faces.copies()) {
      mesh_.face[to].ImportData(mesh_.face[from]);
      copy_custom(mesh_.face_attr, to, from);
    }
  }

  void move_vertices() {
    for_each_speaker([&](int wedge, int v) {
      auto& p = mesh_.vert[place_of_[wedge]].P();
      const Vector3& x = copy_.mesh.position[v];
      if (x == copy_.box.to_box(vector_of(p))) return;
      moved_[v] = true;
      assign(p, copy_.box.to_user(x));
    });
  }

  void connect_faces() {
    std::vector<bool> stays(mesh_.face.size(), false);
    for (int f : copy_.left_alone) stays[f] = true;
    for (int f = 0; f < connectivity().face_slots(); ++f) {
      if (!connectivity().alive(f)) continue;
      stays[copy_.mesh.face_origin[f]] = true;
      const auto [a, b, c] = connectivity().face(f);
      connect_face(mesh_, copy_.mesh.face_origin[f], {&vertex(f, 0), &vertex(f, 1), &vertex(f, 2)},
                   moved_[a] || moved_[b] || moved_[c], copy_.mesh.plane[f].normal);
    }
    for (std::size_t f = 0; f < stays.size(); ++f)
      if (!stays[f] && !mesh_.face[f].IsD())
        vcg::tri::Allocator<MeshType>::DeleteFace(mesh_, mesh_.face[f]);
  }

  /// Tells by vertex of the host's mesh whether a face uses it.
  Marks used_vertices() const {
    Marks used(mesh_.vert.size());
    parallel_.for_each(static_cast<int>(mesh_.face.size()), [&](int f) {
      const auto& face = mesh_.face[f];
      for (int i = 0; i < 3 && !face.IsD(); ++i)
        used[vcg::tri::Index(mesh_, face.cV(i))].store(1, std::memory_order_relaxed);
    });
    return used;
  }

  /// Deletes vertices that lost their last face, be it by a collapse or by a repair.
  void delete_vertices() {
    const Marks used = used_vertices();
    for (std::size_t v = 0; v < used_before_.size(); ++v)
      if (used_before_[v] && !used[v])
        vcg::tri::Allocator<MeshType>::DeleteVertex(mesh_, mesh_.vert[v]);
  }

  /// To wedges, or where the mesh has it by vertex, there.
  void write_texture() {
    const std::vector<Vector2>& texture = copy_.mesh.texture;
    if (!vcg::tri::HasPerWedgeTexCoord(mesh_))
      return for_each_speaker([&](int wedge, int) {
        set_coordinate(mesh_.vert[place_of_[wedge]].T(), texture[wedge].x(), texture[wedge].y());
      });
    parallel_.for_each(connectivity().face_slots(), [&](int f) {
      for (int i = 0; i < 3 && connectivity().alive(f); ++i) {
        const Vector2& at = texture[copy_.mesh.wedges.of_face(f)[i]];
        set_coordinate(mesh_.face[copy_.mesh.face_origin[f]].WT(i), at.x(), at.y());
      }
    });
  }

  // --- attributes: double while they are blended, so that rounding does not add up ---------------

  /// read(v) -> Value, write(v, Value).
  template <class Value, class Read, class Write>
  void blend(Read read, Write write) {
    const int count = static_cast<int>(hosts().size());
    std::vector<Value> values(count);
    parallel_.for_each(count, [&](int c) { values[c] = read(hosts()[c]); });
    const std::vector<Value> input = carried_.resampled.empty() ? std::vector<Value>() : values;
    std::vector<std::uint8_t> changed(count, 0);
    carried_.blended.for_each(parallel_, [&](const BlendStep& step) {
      changed[step.keep] = 1;
      take(step, values, values);
    });
    for (const BlendStep& step : carried_.resampled) {
      changed[step.keep] = 1;
      take(step, input, values);
    }
    parallel_.for_each(count, [&](int c) {
      if (changed[c] && place_of_[c] != none) write(place_of_[c], values[c]);
    });
  }

  void blend_attributes() {
    VertexAttributes(mesh_).for_each(
        [&](auto read, auto write) { blend<std::decay_t<decltype(read(0))>>(read, write); });
  }

  MeshType& mesh_;
  const WorkingCopy& copy_;
  const Carried& carried_;
  const Parallel& parallel_;
  const Marks used_before_;    // by the host's vertex
  std::vector<bool> moved_;    // by working vertex
  std::vector<int> place_of_;  // by speaker: where in the host's mesh it goes
  std::vector<int> speaker_;   // by wedge or vertex
};

/// Makes the host's mesh what the run made of its working copy.
template <class MeshType>
void write_back(MeshType& mesh, WorkingCopy& copy, const Carried& carried,
                std::optional<TracedInput<MeshType>> traced, const Parallel& parallel,
                DecimationReport& report) {
  parallel.progress().fall_silent();
  for (int source : copy.mesh.wedges.sources()) copy.vertex_of.push_back(copy.vertex_of[source]);
  if (!copy.mesh.wedges.exist())
    copy.vertex_of.resize(copy.mesh.vertex_origins, copy.vertex_of[0]);  // any: they are blended
  WriteBack<MeshType>(mesh, copy, carried, parallel).run(traced ? &*traced : nullptr);
  report.faces = mesh.fn, report.vertices = mesh.vn;
}

}  // namespace curvdecim::detail
