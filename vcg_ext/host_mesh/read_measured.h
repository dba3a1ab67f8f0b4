// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "vcg_ext/errors.h"
#include "vcg_ext/host_mesh/host_texture.h"
#include "vcg_ext/host_mesh/join_borders.h"
#include "vcg_ext/host_mesh/read_mesh.h"
#include "vcg_ext/measure/measure_error.h"

namespace curvdecim::detail {

/// Where the vertices of a host's mesh lie: a host may place its mesh by a matrix, `Tr`.
template <class MeshType>
class HostPlaces {
 public:
  explicit HostPlaces(const MeshType& mesh) : mesh_(mesh) { read_matrix(mesh, 0); }

  Vector3 operator()(int v) const {
    const Vector3 p = vector_of(mesh_.vert[v].cP());
    return is_moved_ ? Vector3(turn_ * p + shift_) : p;
  }

 private:
  template <class Mesh>
  auto read_matrix(const Mesh& mesh, int) -> decltype(mesh.Tr, void()) {
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) turn_(i, k) = static_cast<double>(mesh.Tr.ElementAt(i, k));
      shift_[i] = static_cast<double>(mesh.Tr.ElementAt(i, 3));
    }
    is_moved_ = turn_ != Eigen::Matrix3d::Identity() || shift_ != Vector3::Zero();
  }
  template <class Mesh>
  void read_matrix(const Mesh&, long) {}  // the host has none

  const MeshType& mesh_;
  Eigen::Matrix3d turn_ = Eigen::Matrix3d::Identity();
  Vector3 shift_ = Vector3::Zero();
  bool is_moved_ = false;
};

template <class MeshType>
UnitBox box_of(const MeshType& mesh, const WorkingCopy& copy) {
  const HostPlaces<MeshType> place(mesh);
  Box box;
  for (int v : copy.vertex_of) box.add(place(v));
  return unit_box(box.low, box.high);
}

/// Puts the vertices where they are in the box around the original. Throws InputError where the
/// surfaces have nothing to do with each other: numbers would not be exact, or overflow.
template <class MeshType>
void place_in(const UnitBox& box, const MeshType& mesh, WorkingCopy& copy,
              const Parallel& parallel) {
  constexpr double most = 1e6;  // diagonals
  const HostPlaces<MeshType> place(mesh);
  WorkingMesh& now = copy.mesh;
  const int count = static_cast<int>(copy.vertex_of.size());
  parallel.for_each(count, [&](int v) { now.position[v] = box.to_box(place(copy.vertex_of[v])); });
  if (any_where(count, parallel,
                [&](int v) { return !(now.position[v].cwiseAbs().maxCoeff() < most); }))
    throw InputError(
        "The two meshes lie a million times as far apart as the original is large. Choose two "
        "meshes in the same coordinates.");
  now.update_planes(parallel);
  const auto has_area = [&](int f) { return now.plane[f].area > 0.0; };
  if (!any_where(now.connectivity.face_slots(), parallel, has_area))
    throw InputError("No face of the mesh has an area.");
}

/// The texture coordinates of the faces that are measured; empty: there are none.
template <class MeshType>
std::vector<FaceWedges> wedges_of(const MeshType& mesh, const MeasuredSurface& surface,
                                  const Parallel& parallel) {
  const HostTexture<MeshType> texture(mesh, parallel);
  std::vector<FaceWedges> wedges(texture.exists() ? surface.face_count() : 0);
  parallel.for_each(static_cast<int>(wedges.size()), [&](int i) {
    const int f = surface.mesh().face_origin[surface.number_in_mesh(i)];
    wedges[i] = {texture.at(f, 0), texture.at(f, 1), texture.at(f, 2)};
  });
  return wedges;
}

/// A mesh as it is measured, and the way back: the host's vertices, each of which gets its distance
/// also where several are joined.
struct ReadError {
  ErrorInput input;
  std::vector<int> vertex_of;  // in the host's mesh, by vertex of the surface
};

/// copy: as it was read.
template <class MeshType>
ReadError read_in_box(const UnitBox& box, const MeshType& mesh, WorkingCopy copy,
                      const Parallel& parallel) {
  place_in(box, mesh, copy, parallel);
  ReadError read;
  read.vertex_of = copy.vertex_of;
  std::vector<Vector3> vertices = copy.mesh.position;
  join_borders(copy, parallel);
  separate_sheets(copy, parallel);
  read.input.surface =
      std::make_unique<MeasuredSurface>(std::move(copy.mesh), std::move(vertices), parallel);
  read.input.wedges = wedges_of(mesh, *read.input.surface, parallel);
  read.input.faces = mesh.fn, read.input.vertices = mesh.vn;
  return read;
}

}  // namespace curvdecim::detail
