// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "vcg_ext/errors.h"
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
  explicit SnapshotReader(const MeshType& mesh) : mesh_(mesh), working_of_(mesh.vert.size(), unused) {}

  /// Throws InputError where there is nothing to decimate or a face uses a vertex that it cannot.
  Snapshot read() {
    if (mesh_.vn == 0) throw InputError("The mesh is empty; load a triangle mesh first.");
    if (mesh_.fn == 0)
      throw InputError("The mesh has " + std::to_string(mesh_.vn) +
                       " points but no faces; decimation needs a triangle mesh. Reconstruct a surface first.");
    for (std::size_t f = 0; f < mesh_.face.size(); ++f)
      if (!mesh_.face[f].IsD()) read_face(static_cast<int>(f));
    if (faces_.empty()) throw InputError("Every face of the mesh uses a vertex twice; nothing is left to decimate.");
    drop_duplicates();
    number_vertices();
    normalize();
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
      throw InputError("Face " + std::to_string(f) + " refers to a vertex that does not exist. Clean the mesh first.");
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(static_cast<double>(vertex->cP()[k])))
        throw InputError("Vertex " + std::to_string(index) + " of face " + std::to_string(f) +
                         " has a coordinate that is not finite. Delete it or its faces first.");
    return static_cast<int>(index);
  }

  /// Of the faces with the same three vertices, the first stays.
  void drop_duplicates() {
    std::vector<std::pair<Face, int>> sorted;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      sorted.emplace_back(faces_[i], static_cast<int>(i));
      std::sort(sorted.back().first.begin(), sorted.back().first.end());
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<bool> keep(faces_.size(), true);
    for (std::size_t i = 1; i < sorted.size(); ++i)
      if (sorted[i].first == sorted[i - 1].first) keep[sorted[i].second] = false;
    std::size_t end = 0;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (!keep[i]) snapshot_.unusable.push_back(snapshot_.face_of[i]);
      if (!keep[i]) continue;
      faces_[end] = faces_[i];
      snapshot_.face_of[end++] = snapshot_.face_of[i];
    }
    faces_.resize(end);
    snapshot_.face_of.resize(end);
  }

  void number_vertices() {
    for (const Face& face : faces_)
      for (int v : face) working_of_[v] = 0;
    for (std::size_t v = 0; v < working_of_.size(); ++v) {
      if (working_of_[v] == unused) continue;
      working_of_[v] = static_cast<int>(snapshot_.vertex_of.size());
      snapshot_.vertex_of.push_back(static_cast<int>(v));
    }
    for (Face& face : faces_)
      for (int& v : face) v = working_of_[v];
  }

  Vector3 point(int v) const {
    const auto& p = mesh_.vert[snapshot_.vertex_of[v]].cP();
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  }

  /// Divides by the largest side before squaring, so that no unit of length overflows.
  void normalize() {
    const int count = static_cast<int>(snapshot_.vertex_of.size());
    Vector3 low = point(0), high = low;
    for (int v = 1; v < count; ++v) low = low.cwiseMin(point(v)), high = high.cwiseMax(point(v));
    const double side = (high - low).maxCoeff();
    if (!(side > 0.0) || !std::isfinite(side))
      throw InputError("All faces lie in one point, or the coordinates are too large to subtract.");
    snapshot_.center = 0.5 * low + 0.5 * high;
    snapshot_.diagonal = side * ((high - low) / side).norm();
    for (int v = 0; v < count; ++v)
      snapshot_.mesh.position.push_back(snapshot_.to_box(point(v)));
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
