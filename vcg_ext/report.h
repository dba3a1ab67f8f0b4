// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "vcg_ext/field.h"

namespace curvdecim {

/// Called many times a second with 0..100, which never falls, and the name of the stage; false asks
/// to cancel. Not called while the result is written to the mesh.
using Progress = std::function<bool(int percent, const char* stage)>;

enum class StopReason { Target, ErrorBound, NothingLeft, Cancelled };
constexpr auto labels(StopReason) {
  return std::array{"target", "error bound", "nothing left to collapse", "cancelled"};
}

/// Why a guard refused a collapse or the removal of a vertex.
enum class Rejection {
  LinkCondition,
  NormalFlip,
  TriangleShape,
  ErrorBound,
  HubAtRest,    ///< not asked: a vertex of very many faces, of which an edge was refused before
  TextureFlip,  ///< a face would be turned over in the texture
  VertexClass,  ///< a complex vertex, or a corner
  LoopSplit,    ///< no line parts the loop around the vertex
  Crossing,     ///< a face would cross another that it does not cross now
};
constexpr auto labels(Rejection) {
  return std::array{"link_condition", "normal_flip", "triangle_shape",
                    "error_bound",    "hub_at_rest", "texture_flip",
                    "vertex_class",   "loop_split",  "crossing"};
}

static_assert(labels(StopReason()).size() == static_cast<std::size_t>(StopReason::Cancelled) + 1);
static_assert(labels(Rejection()).size() == static_cast<std::size_t>(Rejection::Crossing) + 1);

/// How often each reason stood against a step, by Rejection.
struct Rejections {
  std::array<std::int64_t, labels(Rejection()).size()> count{};

  std::int64_t& operator[](Rejection reason) { return count[static_cast<std::size_t>(reason)]; }
  std::int64_t operator[](Rejection reason) const {
    return count[static_cast<std::size_t>(reason)];
  }
  bool operator==(const Rejections& o) const { return count == o.count; }
};

/// What a decimation did. Lengths are in the mesh's unit.
struct DecimationReport {
  std::int64_t faces_before = 0, faces = 0;
  std::int64_t vertices_before = 0, vertices = 0;
  StopReason stopped_by = StopReason::Target;
  double max_error = 0.0;  ///< no point of either surface is further from the other; 0: not known
  double cost_last = 0.0;  ///< cost of the last step, for a mesh of diagonal 1
  Rejections rejected;
  std::int64_t pairs_contracted = 0;  ///< merges of unconnected vertices, with pair_distance
  std::int64_t parts_removed = 0;     ///< pieces of the surface that vanished
  std::int64_t holes_closed = 0;      ///< that had come down to three edges
  std::int64_t handles_cut = 0;       ///< handles, tunnels and necks
  std::int64_t junctions_parted = 0;  ///< vertices where sheets met that came apart
  double largest_removed = 0.0;       ///< diameter of the largest of these when it went
  /// Faces that cross or touch others beside their neighbours, as they did in the input; with
  /// prevent_intersections.
  std::int64_t crossing = 0;
  double seconds = 0.0;
  std::vector<std::string> notes;  ///< repairs, warnings and the reason of the stop, for the log
};

struct ClusteringReport : DecimationReport {
  double cell_size = 0.0;       ///< diameter of the cells
  double largest_move = 0.0;    ///< the furthest that a vertex went to its cell's representative
  std::int64_t degenerate = 0;  ///< faces with two vertices in one cell
  std::int64_t duplicate = 0;   ///< faces between the same three cells as another
  std::int64_t crowded = 0;     ///< faces dropped by manifold_edges
};

/// What stands around a vertex that may go @cite schroeder1992.
enum class VertexClass : std::uint8_t {
  Simple,        ///< a closed fan of faces, no sharp edge
  Complex,       ///< no fan of faces that are oriented alike
  Boundary,      ///< half a fan, no sharp edge
  InteriorEdge,  ///< a closed fan with a line of two sharp edges through it
  Corner,        ///< a line of sharp edges ends here, or more than two meet
};
constexpr auto labels(VertexClass) {
  return std::array{"simple", "complex", "boundary", "interior_edge", "corner"};
}

}  // namespace curvdecim
