// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "vcg_ext/mesh/face_wedges.h"
#include "vcg_ext/mesh/snapshot.h"
#include "vcg_ext/report.h"

namespace curvdecim {

/// The wedge texture coordinates of the working faces, if the mesh has them.
template <class MeshType>
std::optional<WedgeTexture> read_wedges(const MeshType& mesh, const Snapshot& snapshot) {
  if (!vcg::tri::HasPerWedgeTexCoord(mesh)) return std::nullopt;
  std::vector<FaceWedges> wedges;
  for (int f : snapshot.mesh.face_origin) wedges.push_back(wedges_of(mesh.face[f]));
  return WedgeTexture(std::move(wedges));
}

/// True if one vertex has different texture coordinates in different faces.
inline bool has_seams(const WorkingMesh& mesh, const WedgeTexture& wedges) {
  std::vector<const WedgeCoordinate*> first(mesh.position.size(), nullptr);
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f)
    for (int i = 0; i < 3; ++i) {
      const WedgeCoordinate*& known = first[mesh.connectivity.face(f)[i]];
      if (!known) known = &wedges.of_face(f)[i];
      if (!(*known == wedges.of_face(f)[i])) return true;
    }
  return false;
}

/// True if a vertex attribute other than the normal differs among these vertices of the vcg mesh.
template <class MeshType>
bool has_varying_attributes(const MeshType& mesh, const std::vector<int>& vertices) {
  const auto& first = mesh.vert[vertices[0]];
  const auto differs = [&](int i) {
    const auto& v = mesh.vert[i];
    return (vcg::tri::HasPerVertexColor(mesh) && v.cC() != first.cC()) ||
           (vcg::tri::HasPerVertexQuality(mesh) && v.cQ() != first.cQ()) ||
           (vcg::tri::HasPerVertexRadius(mesh) && v.cR() != first.cR()) ||
           (vcg::tri::HasPerVertexTexCoord(mesh) && !(v.cT() == first.cT()));
  };
  return std::any_of(vertices.begin(), vertices.end(), differs);
}

inline void note_seams(DecimationReport& report) {
  report.notes.push_back(
      "The texture has seams. Its coordinates are carried, but seams may shift a little.");
}

template <class MeshType>
void note_faux_edges(const MeshType& mesh, DecimationReport& report) {
  for (const auto& face : mesh.face)
    if (!face.IsD() && face.IsAnyF()) {
      report.notes.push_back(
          "Marks of edges inside polygons (faux edges) are dropped where faces change.");
      break;
    }
}

/// What is not carried in full, apart from seams.
template <class MeshType>
void note_dropped_attributes(const MeshType& mesh, DecimationReport& report) {
  note_faux_edges(mesh, report);
  if (!mesh.vert_attr.empty())
    report.notes.push_back(
        "Custom vertex attributes stay with the vertices that remain; they are not interpolated.");
}

/// What is not carried in full.
template <class MeshType>
void note_attributes(const MeshType& mesh, const Snapshot& snapshot,
                     const std::optional<WedgeTexture>& wedges, DecimationReport& report) {
  if (wedges && has_seams(snapshot.mesh, *wedges)) note_seams(report);
  note_dropped_attributes(mesh, report);
}

}  // namespace curvdecim
