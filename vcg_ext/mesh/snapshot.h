// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "vcg_ext/errors.h"
#include "vcg_ext/geometry/morton.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim {

/// A vcg mesh as index arrays, with the way back.
struct Snapshot {
  WorkingMesh mesh;
  std::vector<int> vertex_of;  // by working vertex: index in the vcg mesh
  std::vector<int> face_of;    // by working face
  std::vector<int> unusable;   // vcg faces left out: an index twice, or a duplicate
  std::vector<bool> selected;  // by working face
  Vector3 center = Vector3::Zero();
  double diagonal = 1.0;  // of the bounding box, in the mesh's unit

  Vector3 to_box(const Vector3& p) const { return (p - center) / diagonal; }
  Vector3 to_user(const Vector3& p) const { return diagonal * p + center; }
};

/// Reads the living faces and the vertices that they use.
template <class MeshType>
class SnapshotReader {
 public:
  explicit SnapshotReader(const MeshType& mesh)
      : mesh_(mesh), working_of_(mesh.vert.size(), unused) {}

  /// Throws InputError where there is nothing to decimate or a face uses a vertex that it cannot.
  Snapshot read() {
    if (mesh_.vn == 0) throw InputError("The mesh is empty; load a triangle mesh first.");
    if (mesh_.fn == 0)
      throw InputError(
          "The mesh has " + std::to_string(mesh_.vn) +
          " points but no faces; decimation needs a triangle mesh. Reconstruct a surface first.");
    for (std::size_t f = 0; f < mesh_.face.size(); ++f)
      if (!mesh_.face[f].IsD()) read_face(static_cast<int>(f));
    if (faces_.empty())
      throw InputError("Every face of the mesh uses a vertex twice; nothing is left to decimate.");
    collect_vertices();
    normalize();
    number_vertices();
    order_faces();
    finish();
    return std::move(snapshot_);
  }

 private:
  static constexpr int unused = -1;

  void read_face(int f) {
    Face face;
    for (int i = 0; i < 3; ++i) face[i] = vertex_index(f, i);
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) {
      snapshot_.unusable.push_back(f);
      return;
    }
    faces_.push_back(face);
    snapshot_.face_of.push_back(f);
  }

  int vertex_index(int f, int i) const {
    const auto* vertex = mesh_.face[f].cV(i);
    const auto index = vertex ? vertex - mesh_.vert.data() : -1;
    if (index < 0 || index >= static_cast<std::ptrdiff_t>(mesh_.vert.size()) || vertex->IsD())
      throw InputError("Face " + std::to_string(f) +
                       " refers to a vertex that does not exist. Clean the mesh first.");
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(static_cast<double>(vertex->cP()[k])))
        throw InputError("Vertex " + std::to_string(index) + " of face " + std::to_string(f) +
                         " has a coordinate that is not finite. Delete it or its faces first.");
    return static_cast<int>(index);
  }

  void collect_vertices() {
    for (const Face& face : faces_)
      for (int v : face) working_of_[v] = 0;
    for (std::size_t v = 0; v < working_of_.size(); ++v) {
      if (working_of_[v] != unused) snapshot_.vertex_of.push_back(static_cast<int>(v));
    }
  }

  /// Neighbours in space become neighbours in memory: the collapses jump about in the mesh, but
  /// each touches a small region only.
  void number_vertices() {
    std::vector<std::pair<std::uint64_t, int>> order;
    for (int v : snapshot_.vertex_of)
      order.emplace_back(morton_code(snapshot_.to_box(point(v))), v);
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i) {
      snapshot_.vertex_of[i] = order[i].second;
      working_of_[order[i].second] = static_cast<int>(i);
      snapshot_.mesh.position.push_back(snapshot_.to_box(point(order[i].second)));
    }
    for (Face& face : faces_)
      for (int& v : face) v = working_of_[v];
  }

  /// By their vertices, too. Of the faces with the same three vertices, the first stays.
  void order_faces() {
    std::vector<std::pair<Face, int>> order;
    order.reserve(faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      order.emplace_back(faces_[f], static_cast<int>(f));
      sort_corners(order.back().first);
    }
    std::sort(order.begin(), order.end());
    std::vector<Face> faces;
    std::vector<int> face_of;
    faces.reserve(order.size()), face_of.reserve(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto& [key, f] = order[i];
      if (i > 0 && key == order[i - 1].first) {
        snapshot_.unusable.push_back(snapshot_.face_of[f]);
        continue;
      }
      faces.push_back(faces_[f]);
      face_of.push_back(snapshot_.face_of[f]);
    }
    faces_.swap(faces);
    snapshot_.face_of.swap(face_of);
  }

  static void sort_corners(Face& face) {
    if (face[0] > face[1]) std::swap(face[0], face[1]);
    if (face[1] > face[2]) std::swap(face[1], face[2]);
    if (face[0] > face[1]) std::swap(face[0], face[1]);
  }

  Vector3 point(int v) const {
    const auto& p = mesh_.vert[v].cP();
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  }

  /// Divides by the largest side before squaring, so that no unit of length overflows.
  void normalize() {
    Vector3 low = point(snapshot_.vertex_of[0]), high = low;
    for (int v : snapshot_.vertex_of) low = low.cwiseMin(point(v)), high = high.cwiseMax(point(v));
    const double side = (high - low).maxCoeff();
    if (!(side > 0.0) || !std::isfinite(side))
      throw InputError("All faces lie in one point, or the coordinates are too large to subtract.");
    snapshot_.center = 0.5 * low + 0.5 * high;
    snapshot_.diagonal = side * ((high - low) / side).norm();
  }

  void finish() {
    WorkingMesh& mesh = snapshot_.mesh;
    const int count = static_cast<int>(mesh.position.size());
    mesh.connectivity = TriangleConnectivity(std::move(faces_), count);
    mesh.kind = classify_vertices(mesh.connectivity);
    mesh.locked.assign(count, false);
    mesh.plane.resize(mesh.connectivity.face_slots());
    for (int f = 0; f < mesh.connectivity.face_slots(); ++f) {
      mesh.update_plane(f);
      snapshot_.selected.push_back(mesh_.face[snapshot_.face_of[f]].IsS());
    }
  }

  const MeshType& mesh_;
  std::vector<int> working_of_;  // by vcg vertex
  std::vector<Face> faces_;
  Snapshot snapshot_;
};

template <class MeshType>
Snapshot take_snapshot(const MeshType& mesh) {
  return SnapshotReader<MeshType>(mesh).read();
}

}  // namespace curvdecim
