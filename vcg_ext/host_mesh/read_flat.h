// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/clustering/flat_mesh.h"
#include "vcg_ext/host_mesh/input_checks.h"
#include "vcg_ext/host_mesh/working_copy.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// Reads the faces that may change: all, or the selected ones.
template <class MeshType>
class FlatReader {
 public:
  FlatReader(const MeshType& mesh, bool selected_only, const Parallel& parallel)
      : mesh_(mesh), selected_only_(selected_only), parallel_(parallel), marks_(mesh.vert.size()) {}

  /// Throws InputError where there is nothing to decimate or a face uses a vertex that it cannot.
  FlatMesh read() {
    require_faces(mesh_);
    read_faces();
    if (flat_.face_count == 0) refuse_empty_selection();
    if (selected_only_) read_staying();
    measure();
    read_positions();
    return std::move(flat_);
  }

 private:
  static constexpr std::uint8_t in_use = 1, at_staying_face = 2;

  int vertices() const { return static_cast<int>(mesh_.vert.size()); }
  int face_slots() const { return static_cast<int>(mesh_.face.size()); }
  bool may_change(int f) const {
    return !mesh_.face[f].IsD() && (!selected_only_ || mesh_.face[f].IsS());
  }
  bool is_in_use(int v) const { return marks_[v].load(std::memory_order_relaxed) & in_use; }

  void read_faces() {
    flat_.faces.resize(face_slots());
    std::atomic<int> count{0};
    std::atomic<bool> all_usable{true};
    parallel_.for_ranges(face_slots(), [&](int begin, int end, int) {
      int living = 0;
      bool usable = true;
      for (int f = begin; f < end; ++f) {
        flat_.faces[f] = FlatMesh::no_face;
        if (!may_change(f)) continue;
        ++living;
        usable = read_face(f) && usable;
      }
      count += living;
      if (!usable) all_usable = false;
    });
    if (!all_usable) refuse_first();
    flat_.face_count = count;
  }

  /// False where a vertex is missing.
  bool read_face(int f) {
    Face face;
    for (int i = 0; i < 3; ++i) {
      face[i] = vertex_at(mesh_, f, i);
      if (face[i] < 0) return false;
    }
    for (int v : face) marks_[v].store(in_use, std::memory_order_relaxed);
    flat_.faces[f] = face;
    return true;
  }

  /// The first one in the order of the faces, so that the message is always the same.
  void refuse_first() const {
    for (int f = 0; f < face_slots(); ++f)
      for (int i = 0; i < 3 && may_change(f); ++i) usable_vertex_at(mesh_, f, i);
  }

  void read_staying() {
    for (int f = 0; f < face_slots(); ++f) {
      if (mesh_.face[f].IsD() || mesh_.face[f].IsS()) continue;
      Face face;
      for (int i = 0; i < 3; ++i) {
        face[i] = vertex_at(mesh_, f, i);
        if (face[i] >= 0) marks_[face[i]].fetch_or(at_staying_face, std::memory_order_relaxed);
      }
      flat_.staying.push_back(face);
    }
  }

  struct Bounds {
    Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
    Vector3 high = -low;
    bool finite = true;
  };

  void measure() {
    std::vector<Bounds> part(parallel_.threads());
    parallel_.for_ranges(vertices(), [&](int begin, int end, int worker) {
      Bounds bounds = part[worker];
      for (int v = begin; v < end; ++v) {
        if (!is_in_use(v)) continue;
        const Vector3 p = point_of(mesh_, v);
        bounds.finite = bounds.finite && p.allFinite();
        bounds.low = bounds.low.cwiseMin(p), bounds.high = bounds.high.cwiseMax(p);
      }
      part[worker] = bounds;
    });
    Bounds all;
    for (const Bounds& bounds : part) {
      if (!bounds.finite) refuse_first();
      all.low = all.low.cwiseMin(bounds.low), all.high = all.high.cwiseMax(bounds.high);
    }
    flat_.box = unit_box(all.low, all.high);
    flat_.half_size = flat_.box.to_box(all.high).cwiseMax(-flat_.box.to_box(all.low));
  }

  void read_positions() {
    flat_.position.resize(vertices()), flat_.role.resize(vertices());
    parallel_.for_each(vertices(), [&](int v) {
      const std::uint8_t mark = marks_[v].load(std::memory_order_relaxed);
      flat_.role[v] = !(mark & in_use)         ? VertexRole::Unused
                      : mark & at_staying_face ? VertexRole::Fixed
                                               : VertexRole::Free;
      if (mark & in_use) flat_.position[v] = flat_.box.to_box(point_of(mesh_, v));
    });
  }

  const MeshType& mesh_;
  const bool selected_only_;
  const Parallel& parallel_;
  std::vector<std::atomic<std::uint8_t>> marks_;  // by vertex
  FlatMesh flat_;
};

template <class MeshType>
FlatMesh read_flat(const MeshType& mesh, bool selected_only, const Parallel& parallel) {
  return FlatReader<MeshType>(mesh, selected_only, parallel).read();
}

}  // namespace curvdecim::detail
