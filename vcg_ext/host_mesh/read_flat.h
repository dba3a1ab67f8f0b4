// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/clustering/flat_mesh.h"
#include "vcg_ext/host_mesh/working_copy.h"
#include "vcg_ext/parallel/pieces.h"

namespace curvdecim::detail {

/// What becomes of faces that use a vertex twice. Left out, they are among the faces that are read,
/// but count neither as faces nor for the vertices in use.
enum class DegenerateFaces { Count, AreLeftOut };

/// Reads the faces that may change: all, or the selected ones.
template <class MeshType>
class FlatReader {
 public:
  FlatReader(const MeshType& mesh, bool selected_only, DegenerateFaces degenerate,
             const Parallel& parallel)
      : mesh_(mesh),
        selected_only_(selected_only),
        degenerate_count_(degenerate == DegenerateFaces::Count),
        parallel_(parallel),
        marks_(mesh.vert.size()) {}

  /// Throws InputError where there is nothing to decimate or a face uses a vertex that it cannot.
  FlatMesh read() {
    require_faces();
    read_faces();
    if (selected_only_) read_staying();
    measure();
    read_positions();
    return std::move(flat_);
  }

 private:
  static constexpr std::uint8_t in_use = 1, at_staying_face = 2, at_left_out_face = 4;

  int vertices() const { return static_cast<int>(mesh_.vert.size()); }
  Vector3 point_at(int v) const { return vector_of(mesh_.vert[v].cP()); }
  int face_slots() const { return static_cast<int>(mesh_.face.size()); }
  bool may_change(int f) const {
    return !mesh_.face[f].IsD() && (!selected_only_ || mesh_.face[f].IsS());
  }
  bool counts(const Face& face) const { return degenerate_count_ || !is_degenerate(face); }
  std::uint8_t mark_of(int v) const { return marks_[v].load(std::memory_order_relaxed); }

  void mark(int v, std::uint8_t mark) {
    if ((mark_of(v) & mark) == 0) marks_[v].fetch_or(mark, std::memory_order_relaxed);
  }

  void require_faces() const {
    if (mesh_.vn == 0) throw InputError("The mesh is empty; load a triangle mesh first.");
    if (mesh_.fn == 0)
      throw InputError(
          "The mesh has " + std::to_string(mesh_.vn) +
          " points but no faces; decimation needs a triangle mesh. Reconstruct a surface first.");
  }

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
        usable = read_face(f) && usable;
        living += counts(flat_.faces[f]);
      }
      count += living;
      if (!usable) all_usable = false;
    });
    if (!all_usable) refuse_first();
    flat_.face_count = count;
  }

  /// False where a vertex is missing.
  bool read_face(int f) {
    const Face face = corners_of(f);
    if (*std::min_element(face.begin(), face.end()) < 0) return false;
    for (int v : face) mark(v, counts(face) ? in_use : at_left_out_face);
    flat_.faces[f] = face;
    return true;
  }

  /// The vertices of a face; -1 where it uses no living vertex of the mesh.
  Face corners_of(int f) const {
    const auto vertex_at = [&](int corner) {
      const auto* vertex = mesh_.face[f].cV(corner);
      const auto index = vertex ? vertex - mesh_.vert.data() : -1;
      const bool exists = index >= 0 && index < static_cast<std::ptrdiff_t>(mesh_.vert.size());
      return exists && !vertex->IsD() ? static_cast<int>(index) : -1;
    };
    return {vertex_at(0), vertex_at(1), vertex_at(2)};
  }

  /// The first one in the order of the faces, so that the message is always the same.
  void refuse_first() const {
    for (int f = 0; f < face_slots(); ++f)
      if (may_change(f))
        for (int v : corners_of(f)) require_usable(f, v);
  }

  void require_usable(int f, int v) const {
    if (v < 0)
      throw InputError("Face " + std::to_string(f) +
                       " refers to a vertex that does not exist. Clean the mesh first.");
    if (!point_at(v).allFinite())
      throw InputError("Vertex " + std::to_string(v) + " of face " + std::to_string(f) +
                       " has a coordinate that is not finite. Delete it or its faces first.");
  }

  [[noreturn]] void refuse_all() const {
    if (selected_only_) refuse_empty_selection();
    throw InputError("Every face of the mesh uses a vertex twice; nothing is left to decimate.");
  }

  void read_staying() {
    for (int f = 0; f < face_slots(); ++f) {
      if (mesh_.face[f].IsD() || mesh_.face[f].IsS()) continue;
      flat_.staying.push_back(corners_of(f));
      for (int v : flat_.staying.back())
        if (v >= 0) mark(v, at_staying_face);
    }
  }

  struct Bounds {
    Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
    Vector3 high = -low;
    bool finite = true;

    void add(const Vector3& p, std::uint8_t mark) {
      if ((mark & (in_use | at_left_out_face)) != 0) finite = finite && p.allFinite();
      if ((mark & in_use) != 0) low = low.cwiseMin(p), high = high.cwiseMax(p);
    }
  };

  /// In consecutive pieces: of 0 and -0 the first stays, whatever the number of threads.
  void measure() {
    std::vector<Bounds> part(pieces_of(vertices(), parallel_));
    for_pieces(vertices(), static_cast<int>(part.size()), parallel_,
               [&](int piece, int begin, int end) {
                 Bounds bounds;
                 for (int v = begin; v < end; ++v) bounds.add(point_at(v), mark_of(v));
                 part[piece] = bounds;
               });
    Bounds all;
    for (const Bounds& bounds : part) {
      if (!bounds.finite) refuse_first();
      all.low = all.low.cwiseMin(bounds.low), all.high = all.high.cwiseMax(bounds.high);
    }
    if (flat_.face_count == 0) refuse_all();
    flat_.box = unit_box(all.low, all.high);
    flat_.half_size = flat_.box.to_box(all.high).cwiseMax(-flat_.box.to_box(all.low));
  }

  void read_positions() {
    flat_.position.resize(vertices()), flat_.role.resize(vertices());
    parallel_.for_each(vertices(), [&](int v) {
      const std::uint8_t mark = mark_of(v);
      flat_.role[v] = !(mark & in_use)         ? VertexRole::Unused
                      : mark & at_staying_face ? VertexRole::Fixed
                                               : VertexRole::Free;
      if (mark & in_use) flat_.position[v] = flat_.box.to_box(point_at(v));
    });
  }

  const MeshType& mesh_;
  const bool selected_only_, degenerate_count_;
  const Parallel& parallel_;
  std::vector<std::atomic<std::uint8_t>> marks_;  // by vertex
  FlatMesh flat_;
};

template <class MeshType>
FlatMesh read_flat(const MeshType& mesh, bool selected_only, const Parallel& parallel,
                   DegenerateFaces degenerate = DegenerateFaces::Count) {
  return FlatReader<MeshType>(mesh, selected_only, degenerate, parallel).read();
}

/// How far a vertex moves at most when it is written as the host's numbers are, in the mesh's unit.
template <class MeshType>
double rounding_in(const UnitBox& box) {
  constexpr double unit = 0.5 * std::numeric_limits<typename MeshType::ScalarType>::epsilon();
  return unit * (box.center.norm() + box.diagonal);
}

}  // namespace curvdecim::detail
