// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/morton.h"
#include "vcg_ext/host_mesh/join_borders.h"
#include "vcg_ext/host_mesh/read_flat.h"
#include "vcg_ext/host_mesh/working_copy.h"
#include "vcg_ext/mesh/face_keys.h"
#include "vcg_ext/parallel/pieces.h"
#include "vcg_ext/run/plan_reading.h"
#include "vcg_ext/run/target.h"

namespace curvdecim::detail {

/// Reads the living faces and the vertices that they use.
template <class MeshType>
class WorkingCopyReader {
 public:
  WorkingCopyReader(const MeshType& mesh, const Parallel& parallel)
      : mesh_(mesh), parallel_(parallel) {}

  /// Throws InputError where there is nothing to decimate or a face uses a vertex that it cannot.
  WorkingCopy read() {
    ProgressMeter& progress = parallel_.progress();  // parts of the time of the preparation
    progress.along(0.0, 0.2, [&] {
      flat_ = read_flat(mesh_, false, parallel_, DegenerateFaces::AreLeftOut);
      copy_.box = flat_.box;
      copy_.unusable = indices_where(face_slots(), parallel_, [&](int f) {
        return FlatMesh::is_face(flat_.faces[f]) && is_degenerate(flat_.faces[f]);
      });
      number_vertices();
    });
    progress.along(0.2, 0.35, [&] { order_faces(); });
    progress.along(0.35, 0.45, [&] { finish(); });
    return std::move(copy_);
  }

 private:
  int face_slots() const { return static_cast<int>(flat_.faces.size()); }
  bool is_usable(int f) const {
    return FlatMesh::is_face(flat_.faces[f]) && !is_degenerate(flat_.faces[f]);
  }

  /// Neighbours in space become neighbours in memory: the collapses jump about in the mesh, but
  /// each touches a small region only.
  void number_vertices() {
    const std::vector<int> used = vertices_in_use(flat_, parallel_);
    const int count = copy_.vertices_read = static_cast<int>(used.size());
    const Array<Keyed> order =
        along_curve(count, parallel_, [&](int i) { return flat_.position[used[i]]; });
    copy_.vertex_of.resize(count), copy_.mesh.position.resize(count);
    Array<int> working_of(flat_.position.size());
    parallel_.for_each(count, [&](int i) {
      const int v = used[order[i].value];
      copy_.vertex_of[i] = v;
      working_of[v] = i;
      copy_.mesh.position[i] = flat_.position[v];
    });
    parallel_.for_each(face_slots(), [&](int f) {
      if (is_usable(f))
        for (int& v : flat_.faces[f]) v = working_of[v];
    });
  }

  /// By their vertices, too.
  void order_faces() {
    const Array<FaceKey> keys = keys_without_doubles();
    const int count = static_cast<int>(keys.size());
    faces_.resize(count), face_of_.resize(count);
    parallel_.for_each(count, [&](int i) {
      face_of_[i] = keys[i].back();
      faces_[i] = flat_.faces[face_of_[i]];
    });
    flat_ = {};
  }

  /// Same vertices, same orientation.
  bool are_doubles(const FaceKey& a, const FaceKey& b) const {
    return have_the_same_vertices(a, b) &&
           next_in(flat_.faces[a.back()], a[0]) == next_in(flat_.faces[b.back()], b[0]);
  }

  /// The faces in order; of doubles the first stays. Two faces back to back on the same three
  /// vertices are none: closed parts that touch have such.
  Array<FaceKey> keys_without_doubles() {
    Array<FaceKey> keys = ordered_keys(
        face_slots(), copy_.vertices_read, parallel_,
        [&](int f) -> const Face& { return flat_.faces[f]; }, [&](int f) { return is_usable(f); });
    const auto doubles_before = [&](int i, int end) {
      return (end > 0 && are_doubles(keys[i], keys[end - 1])) ||
             (end > 1 && are_doubles(keys[i], keys[end - 2]));
    };
    const int count = static_cast<int>(keys.size());
    if (!any_where(count, parallel_, [&](int i) { return doubles_before(i, i); })) return keys;
    int kept = 0;
    for (int i = 0; i < count; ++i)
      if (doubles_before(i, kept))
        copy_.unusable.push_back(keys[i].back());
      else
        keys[kept++] = keys[i];
    keys.resize(kept);
    return keys;
  }

  void finish() {
    WorkingMesh& mesh = copy_.mesh;
    connect(mesh, std::move(faces_), parallel_);
    mesh.locked.assign(mesh.position.size(), 0);
    mesh.update_planes(parallel_);
    copy_.selected.resize(face_of_.size());
    parallel_.for_each(static_cast<int>(face_of_.size()),
                       [&](int f) { copy_.selected[f] = mesh_.face[face_of_[f]].IsS(); });
    mesh.face_origin = std::move(face_of_);
    mesh.face_origins = static_cast<int>(mesh_.face.size());
  }

  const MeshType& mesh_;
  const Parallel& parallel_;
  FlatMesh flat_;  // its faces are numbered anew
  std::vector<Face> faces_;
  std::vector<int> face_of_;  // by working face: index in the vcg mesh
  WorkingCopy copy_;
};

/// A working copy of the mesh, in which only selected faces may change if that was asked for.
/// Throws InputError where there is nothing to decimate or a face uses a vertex that it cannot.
template <class MeshType>
WorkingCopy read_mesh(const MeshType& mesh, bool selected_only, const Parallel& parallel) {
  WorkingCopy copy = WorkingCopyReader<MeshType>(mesh, parallel).read();
  if (selected_only) lock_unselected(mesh, copy);
  return copy;
}

/// The same, with vertices that are not the host's where the plan asks for it.
template <class MeshType>
WorkingCopy read_mesh(const MeshType& mesh, const ReadingPlan& plan, const Parallel& parallel) {
  WorkingCopy copy = read_mesh(mesh, plan.selected_only, parallel);
  if (plan.joins_borders) join_borders(copy, parallel);
  if (plan.sheets == Sheets::AreSeparated) separate_sheets(copy, parallel);
  return copy;
}

template <class MeshType>
Counts counts_of(const MeshType& mesh) {
  return {mesh.fn, mesh.vn};
}

/// copy: as it was read.
template <class MeshType>
InputFacts facts_of(const MeshType& mesh, const WorkingCopy& copy, bool selected_only) {
  const auto staying =
      selected_only ? std::count(copy.selected.begin(), copy.selected.end(), std::uint8_t{0}) : 0;
  return {counts_of(mesh),
          count_candidates(mesh, selected_only),
          copy.mesh.connectivity.face_count(),
          static_cast<int>(staying),
          copy.vertices_read,
          copy.box.diagonal,
          rounding_in<MeshType>(copy.box)};
}

}  // namespace curvdecim::detail
