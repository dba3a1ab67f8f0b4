// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/morton.h"
#include "vcg_ext/host_mesh/join_borders.h"
#include "vcg_ext/host_mesh/read_flat.h"
#include "vcg_ext/host_mesh/working_copy.h"
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
    progress.along(0.0, 0.2, [&] { number_vertices(read_faces()); });
    progress.along(0.2, 0.35, [&] { order_faces(); });
    progress.along(0.35, 0.45, [&] { finish(); });
    return std::move(copy_);
  }

 private:
  /// The vertices that they use come with them.
  FlatMesh read_faces() {
    FlatMesh flat = read_flat(mesh_, false, parallel_, DegenerateFaces::AreLeftOut);
    copy_.box = flat.box;
    copy_.vertex_of = vertices_in_use(flat);
    copy_.vertices_read = static_cast<int>(copy_.vertex_of.size());
    faces_.swap(flat.faces);
    face_of_.reserve(flat.face_count);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const Face face = faces_[f];
      if (!FlatMesh::is_face(face)) continue;
      const bool usable = !is_degenerate(face);
      if (usable) faces_[face_of_.size()] = face;
      (usable ? face_of_ : copy_.unusable).push_back(static_cast<int>(f));
    }
    faces_.resize(face_of_.size());
    return flat;
  }

  /// Neighbours in space become neighbours in memory: the collapses jump about in the mesh, but
  /// each touches a small region only.
  void number_vertices(const FlatMesh& flat) {
    const int count = static_cast<int>(copy_.vertex_of.size());
    std::vector<std::pair<std::uint64_t, int>> order(count);
    parallel_.for_each(count, [&](int i) {
      const int v = copy_.vertex_of[i];
      order[i] = {morton_code(flat.position[v]), v};
    });
    parallel_.sort(order.begin(), order.end());
    copy_.mesh.position.resize(count);
    std::vector<int> working_of(flat.position.size());
    parallel_.for_each(count, [&](int i) {
      const int v = order[i].second;
      copy_.vertex_of[i] = v;
      working_of[v] = i;
      copy_.mesh.position[i] = flat.position[v];
    });
    parallel_.for_each(static_cast<int>(faces_.size()), [&](int f) {
      for (int& v : faces_[f]) v = working_of[v];
    });
  }

  /// The vertices of a face in ascending order, and where it stands.
  using FaceKey = std::array<int, 4>;

  FaceKey key_of(int f) const {
    const auto [a, b, c] = faces_[f];
    const int least = std::min({a, b, c}), largest = std::max({a, b, c});
    return {least, a ^ b ^ c ^ least ^ largest, largest, f};
  }

  /// Faces by their vertices: buckets by the least one, sorted inside.
  std::vector<FaceKey> ordered_keys() const {
    const int vertices = static_cast<int>(copy_.vertex_of.size());
    std::vector<int> begin(vertices + 1, 0);
    for (const Face& face : faces_) ++begin[std::min({face[0], face[1], face[2]}) + 1];
    for (int v = 0; v < vertices; ++v) begin[v + 1] += begin[v];
    std::vector<FaceKey> keys(faces_.size());
    std::vector<int> end(begin.begin(), begin.end() - 1);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const FaceKey key = key_of(static_cast<int>(f));
      keys[end[key[0]]++] = key;
    }
    parallel_.for_each(
        vertices, [&](int v) { std::sort(keys.begin() + begin[v], keys.begin() + begin[v + 1]); });
    return keys;
  }

  /// By their vertices, too.
  void order_faces() {
    const std::vector<FaceKey> keys = keys_without_duplicates();
    const int count = static_cast<int>(keys.size());
    std::vector<Face> faces(count);
    std::vector<int> face_of(count);
    parallel_.for_each(count, [&](int i) {
      faces[i] = faces_[keys[i].back()];
      face_of[i] = face_of_[keys[i].back()];
    });
    faces_.swap(faces);
    face_of_.swap(face_of);
  }

  /// Same vertices, same orientation.
  bool are_doubles(const FaceKey& a, const FaceKey& b) const {
    if (!std::equal(a.begin(), a.end() - 1, b.begin())) return false;
    const Face &f = faces_[a.back()], &g = faces_[b.back()];
    const auto after = [&](const Face& face) {
      return face[(std::find(face.begin(), face.end(), a[0]) - face.begin() + 1) % 3];
    };
    return after(f) == after(g);
  }

  /// The faces in order; of doubles the first stays. Two faces back to back on the same three
  /// vertices are none: closed parts that touch have such.
  std::vector<FaceKey> keys_without_duplicates() {
    std::vector<FaceKey> keys = ordered_keys();
    std::size_t kept = 1;
    for (std::size_t i = 1; i < keys.size(); ++i)
      if (are_doubles(keys[i], keys[kept - 1]) ||
          (kept > 1 && are_doubles(keys[i], keys[kept - 2])))
        copy_.unusable.push_back(face_of_[keys[i].back()]);
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
          copy.box.diagonal};
}

}  // namespace curvdecim::detail
