// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/allocate.h>
#include <vcg/complex/complex.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "vcg_ext/mesh/attribute_blend.h"
#include "vcg_ext/mesh/snapshot.h"
#include "vcg_ext/mesh/wedge_texture.h"

namespace curvdecim {

/// Puts the decimated arrays back into the vcg mesh that they were taken from. What was not touched
/// keeps its bits. Afterwards the mesh is compact and its adjacency relations are empty.
template <class MeshType>
class WriteBack {
 public:
  WriteBack(MeshType& mesh, const Snapshot& snapshot)
      : mesh_(mesh), snapshot_(snapshot), moved_(snapshot.mesh.position.size(), false) {}

  /// resampled: vertices that take their attributes from the input, after all other steps. wedges:
  /// where the mesh has wedge texture coordinates.
  void run(const BlendRecord& record, const std::vector<BlendStep>& resampled,
           const std::optional<WedgeTexture>& wedges) {
    blend_attributes({record, resampled});
    if (wedges) write_wedges(*wedges);
    move_vertices();
    const std::vector<bool> used_before = used_vertices();
    connect_faces();
    delete_vertices(used_before);
    clear_adjacency();
    vcg::tri::Allocator<MeshType>::CompactEveryVector(mesh_);
    vcg::tri::UpdateBounding<MeshType>::Box(mesh_);
  }

 private:
  using Scalar = typename MeshType::ScalarType;
  using Vertex = typename MeshType::VertexType;

  const TriangleConnectivity& connectivity() const { return snapshot_.mesh.connectivity; }
  bool in_use(int v) const { return connectivity().faces_of(v).size() > 0; }
  Vertex& vertex(int v) { return start_vertex(snapshot_.mesh.vertex_origin[v]); }
  /// By the number at the start.
  Vertex& start_vertex(int v) { return mesh_.vert[snapshot_.vertex_of[v]]; }
  typename MeshType::FaceType& face(int f) { return mesh_.face[snapshot_.mesh.face_origin[f]]; }

  void move_vertices() {
    for (int v = 0; v < connectivity().vertex_slots(); ++v) {
      auto& p = vertex(v).P();
      const Vector3& x = snapshot_.mesh.position[v];
      moved_[v] = in_use(v) && x != snapshot_.to_box({double(p[0]), double(p[1]), double(p[2])});
      if (!moved_[v]) continue;
      const Vector3 user = snapshot_.to_user(x);
      for (int k = 0; k < 3; ++k) p[k] = static_cast<Scalar>(user[k]);
    }
  }

  void connect_faces() {
    std::vector<bool> stays(mesh_.face.size(), false);
    for (int f : snapshot_.left_alone) stays[f] = true;
    for (int f = 0; f < connectivity().face_slots(); ++f) {
      if (!connectivity().alive(f)) continue;
      stays[snapshot_.mesh.face_origin[f]] = true;
      connect_face(face(f), f);
    }
    for (std::size_t f = 0; f < stays.size(); ++f)
      if (!stays[f] && !mesh_.face[f].IsD())
        vcg::tri::Allocator<MeshType>::DeleteFace(mesh_, mesh_.face[f]);
  }

  /// Faces that did not change keep their normals and their marks of edges inside polygons, which
  /// mean nothing once the polygon is cut.
  void connect_face(typename MeshType::FaceType& face, int f) {
    bool changed = false;
    for (int i = 0; i < 3; ++i) {
      const int v = connectivity().face(f)[i];
      changed = changed || face.cV(i) != &vertex(v) || moved_[v];
      face.V(i) = &vertex(v);
    }
    if (!changed) return;
    face.ClearAllF();
    if (vcg::tri::HasPerFaceNormal(mesh_))
      for (int k = 0; k < 3; ++k)
        face.N()[k] = static_cast<Scalar>(snapshot_.mesh.plane[f].normal[k]);
  }

  /// By vcg vertex: whether a face uses it.
  std::vector<bool> used_vertices() const {
    std::vector<bool> used(mesh_.vert.size(), false);
    for (const auto& face : mesh_.face)
      for (int i = 0; i < 3 && !face.IsD(); ++i) used[vcg::tri::Index(mesh_, face.cV(i))] = true;
    return used;
  }

  /// Those that lost their last face, be it by a collapse or by a repair.
  void delete_vertices(const std::vector<bool>& used_before) {
    const std::vector<bool> used = used_vertices();
    for (std::size_t v = 0; v < used.size(); ++v)
      if (used_before[v] && !used[v])
        vcg::tri::Allocator<MeshType>::DeleteVertex(mesh_, mesh_.vert[v]);
  }

  void write_wedges(const WedgeTexture& wedges) {
    for (int f = 0; f < connectivity().face_slots(); ++f)
      for (int i = 0; i < 3 && connectivity().alive(f); ++i) {
        auto& texture = face(f).WT(i);
        texture.u() = static_cast<decltype(texture.u() + 0)>(wedges.of_face(f)[i].u);
        texture.v() = static_cast<decltype(texture.v() + 0)>(wedges.of_face(f)[i].v);
      }
  }

  /// Compaction follows these pointers; after the collapses they lead nowhere.
  void clear_adjacency() {
    if (vcg::tri::HasVFAdjacency(mesh_)) {
      for (auto& v : mesh_.vert) v.VFClear();
      for (auto& f : mesh_.face)
        for (int i = 0; i < 3; ++i) f.VFClear(i);
    }
    if (vcg::tri::HasFFAdjacency(mesh_))
      for (auto& f : mesh_.face)
        for (int i = 0; i < 3; ++i) f.FFp(i) = nullptr;
  }

  // --- attributes: double while they are blended, so that rounding does not add up ---------------

  struct Steps {
    const BlendRecord& blended;
    const std::vector<BlendStep>& resampled;
  };

  /// read(vertex) -> Value, write(vertex, Value).
  template <class Value, class Read, class Write>
  void blend(const Steps& steps, Read read, Write write) {
    std::vector<Value> values(snapshot_.vertex_of.size());
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
      if (changed[v]) write(start_vertex(static_cast<int>(v)), values[v]);
  }

  void blend_attributes(const Steps& steps) {
    if (vcg::tri::HasPerVertexQuality(mesh_))
      blend<double>(
          steps, [](const Vertex& v) { return double(v.cQ()); },
          [](Vertex& v, double q) { v.Q() = static_cast<decltype(v.cQ() + 0)>(q); });
    if (vcg::tri::HasPerVertexRadius(mesh_))
      blend<double>(
          steps, [](const Vertex& v) { return double(v.cR()); },
          [](Vertex& v, double r) { v.R() = static_cast<decltype(v.cR() + 0)>(r); });
    if (vcg::tri::HasPerVertexColor(mesh_)) blend<Eigen::Vector4d>(steps, read_color, write_color);
    if (vcg::tri::HasPerVertexNormal(mesh_)) blend<Vector3>(steps, read_normal, write_normal);
    if (vcg::tri::HasPerVertexTexCoord(mesh_))
      blend<Eigen::Vector2d>(
          steps, [](const Vertex& v) { return Eigen::Vector2d(v.cT().u(), v.cT().v()); },
          [](Vertex& v, const Eigen::Vector2d& t) { v.T().u() = t.x(), v.T().v() = t.y(); });
  }

  static Eigen::Vector4d read_color(const Vertex& v) {
    return {double(v.cC()[0]), double(v.cC()[1]), double(v.cC()[2]), double(v.cC()[3])};
  }
  static void write_color(Vertex& v, const Eigen::Vector4d& c) {
    for (int k = 0; k < 4; ++k)
      v.C()[k] = static_cast<unsigned char>(std::lround(std::clamp(c[k], 0.0, 255.0)));
  }

  static Vector3 read_normal(const Vertex& v) {
    return {double(v.cN()[0]), double(v.cN()[1]), double(v.cN()[2])};
  }
  static void write_normal(Vertex& v, const Vector3& n) {
    const double length = n.norm();
    for (int k = 0; k < 3 && length > 0.0; ++k) v.N()[k] = static_cast<Scalar>(n[k] / length);
  }

  MeshType& mesh_;
  const Snapshot& snapshot_;
  std::vector<bool> moved_;  // by working vertex
};

}  // namespace curvdecim
