// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// A neighbour of a vertex.
struct RingVertex {
  int vertex;
  Vector3 wings;  // sum of the area vectors of the faces at the edge to it
};

/// The neighbours of a vertex, each once. Reused from vertex to vertex.
using VertexRing = std::vector<RingVertex>;

/// Sum of the area vectors of the faces at the edge.
inline Vector3 wings_of(const WorkingMesh& mesh, Edge edge) {
  const TriangleConnectivity& connectivity = mesh.connectivity;
  const bool a_has_fewer =
      connectivity.faces_of(edge.a).size() <= connectivity.faces_of(edge.b).size();
  const int near = a_has_fewer ? edge.a : edge.b, far = a_has_fewer ? edge.b : edge.a;
  Vector3 sum = Vector3::Zero();
  for (int f : connectivity.faces_of(near))
    if (connectivity.face_has(f, far)) sum += mesh.plane[f].area_vector();
  return sum;
}

/// Adds to the entry of `u`, looked for one by one: rings are short.
inline void add_to_ring(int u, const Vector3& area_vector, VertexRing& ring) {
  for (RingVertex& known : ring)
    if (known.vertex == u) {
      known.wings += area_vector;
      return;
    }
  ring.push_back({u, area_vector});
}

/// The ring of a hub: two entries a face, sorted, then joined.
inline void gather_long_ring(const WorkingMesh& mesh, int v, VertexRing& ring) {
  for (int f : mesh.connectivity.faces_of(v))
    for (int u : mesh.connectivity.face(f))
      if (u != v) ring.push_back({u, mesh.plane[f].area_vector()});
  std::stable_sort(ring.begin(), ring.end(),
                   [](const RingVertex& a, const RingVertex& b) { return a.vertex < b.vertex; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < ring.size(); ++i)
    if (ring[i].vertex == ring[last].vertex)
      ring[last].wings += ring[i].wings;
    else
      ring[++last] = ring[i];
  ring.resize(std::min(ring.size(), last + 1));
}

inline void gather_ring(const WorkingMesh& mesh, int v, VertexRing& ring) {
  constexpr int long_ring = 64;  // faces, from which on sorting is quicker
  ring.clear();
  const auto faces = mesh.connectivity.faces_of(v);
  if (faces.size() > long_ring) return gather_long_ring(mesh, v, ring);
  for (int f : faces) {
    const Vector3 area_vector = mesh.plane[f].area_vector();
    for (int u : mesh.connectivity.face(f))
      if (u != v) add_to_ring(u, area_vector, ring);
  }
}

}  // namespace curvdecim::detail
