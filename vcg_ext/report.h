// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace curvdecim {

/// Called on every long stage with 0..100 and the stage's name; false asks to cancel.
using Progress = std::function<bool(int percent, const char* stage)>;

enum class StopReason { Target, ErrorBound, NothingLeft, Cancelled };

inline const char* to_string(StopReason reason) {
  constexpr std::array<const char*, 4> names = {"target", "error bound", "nothing left to collapse",
                                                "cancelled"};
  return names[static_cast<std::size_t>(reason)];
}

/// Why a guard refused a collapse or the removal of a vertex.
enum class Rejection {
  LinkCondition,
  NormalFlip,
  TriangleShape,
  ErrorBound,
  HubAtRest,    ///< not asked: a vertex of very many faces, of which an edge was refused before
  VertexClass,  ///< a complex vertex, or a corner
  LoopSplit,    ///< no line parts the loop around the vertex
};

inline constexpr std::array<const char*, 7> rejection_names = {
    "link_condition", "normal_flip",  "triangle_shape", "error_bound",
    "hub_at_rest",    "vertex_class", "loop_split"};

struct DecimationReport {
  std::int64_t faces_before = 0, faces = 0;
  std::int64_t vertices_before = 0, vertices = 0;
  StopReason stopped_by = StopReason::Target;
  double max_error = 0.0;  ///< guaranteed two-sided bound in the mesh's unit; 0 when not asked for
  double cost_last = 0.0;  ///< cost of the last collapse, for a mesh of diagonal 1
  std::array<std::int64_t, rejection_names.size()> rejected{};  ///< by Rejection
  std::int64_t pairs_contracted = 0;  ///< merges of unconnected vertices, with PairDistance
  double seconds = 0.0;
  std::vector<std::string> notes;  ///< repairs, warnings and the reason of the stop, for the log

  std::int64_t& rejected_by(Rejection reason) { return rejected[static_cast<std::size_t>(reason)]; }
};

}  // namespace curvdecim
