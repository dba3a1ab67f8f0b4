// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "vcg_ext/geometry/triangle.h"
#include "vcg_ext/geometry/unit_box.h"
#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/parallel/array.h"
#include "vcg_ext/parallel/pieces.h"

namespace curvdecim::detail {

/// use(i) once for each number in a triple, in its order.
template <class Use>
void for_different(const std::array<int, 3>& triple, Use use) {
  const auto [a, b, c] = triple;
  use(a);
  if (b != a) use(b);
  if (c != a && c != b) use(c);
}

/// What a vertex is to the faces that may change.
enum class VertexRole : std::uint8_t {
  Unused,  ///< no such face uses it
  Free,
  Fixed,  ///< a face that must stay uses it, too
};

/// The faces of the host's mesh that may change and their vertices, under the host's own indices:
/// for operators that go over all elements once and need no adjacency.
struct FlatMesh {
  static constexpr Face no_face = {-1, -1, -1};

  Array<Vector3> position;              // by vertex, in the unit box; set where it is in use
  Array<VertexRole> role;               // by vertex
  Array<Face> faces;                    // by face; no_face: it is deleted or must stay
  std::vector<Face> staying;            // the living faces that must stay
  int face_count = 0;                   // of those that may change
  UnitBox box;                          // of the vertices in use
  Vector3 half_size = Vector3::Zero();  // of their bounding box, in the unit box

  static bool is_face(const Face& face) { return face[0] >= 0; }

  Triangle triangle(int f) const { return triangle_of(position, faces[f]); }
};

/// The vertices that faces use which may change, ascending.
inline std::vector<int> vertices_in_use(const FlatMesh& flat, const Parallel& parallel) {
  return indices_where(static_cast<int>(flat.role.size()), parallel,
                       [&](int v) { return flat.role[v] != VertexRole::Unused; });
}

}  // namespace curvdecim::detail
