// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "vcg_ext/mesh/tally.h"
#include "vcg_ext/params.h"
#include "vcg_ext/run/notes.h"

namespace curvdecim::detail {

/// Elements of the host's mesh that are not deleted.
struct Counts {
  int faces = 0, vertices = 0;
};

/// What a plan needs to know of the input.
struct InputFacts {
  Counts all;             // in the host's mesh
  int candidates = 0;     // faces that may change
  int faces = 0;          // in the working copy
  int staying_faces = 0;  // of these, faces that may not change
  int used_vertices = 0;  // of the host's mesh, read for the working copy
  double diagonal = 1.0;  // of the bounding box, in the mesh's unit
  double rounding = 0.0;  // of a vertex that is written, in the same
};

/// What is known of them before the mesh is read.
inline InputFacts facts_ahead(const Counts& all) {
  return {all, all.faces, all.faces, 0, all.vertices, 1.0, 0.0};
}

/// A bound in the box of diagonal 1, with room for the rounding of what is written, in the mesh's
/// unit; 0: none.
inline double bound_in_box(double max_error, double rounding, double diagonal) {
  if (max_error == 0.0) return 0.0;
  constexpr double least = std::numeric_limits<double>::min();
  return std::max(least, (max_error - rounding) / diagonal);
}

/// The faces that a fraction of some faces keeps: at least one.
inline int faces_of_fraction(double fraction, int candidates) {
  return std::max(1, static_cast<int>(fraction * candidates));
}

/// The faces to keep among those that may change, by the parameter that rules.
inline int target_faces(const DecimationParams& params, int candidates) {
  if (params.target_fraction > 0.0) return faces_of_fraction(params.target_fraction, candidates);
  if (params.target_vertices > 0) return 0;
  return params.target_faces == DecimationParams::no_target ? 0 : params.target_faces;
}

/// Where a run ends, in terms of the working copy; nullopt: the mesh is small enough as it is.
inline std::optional<StopCriterion> stop_criterion(const DecimationParams& params,
                                                   const InputFacts& input) {
  const int faces = target_faces(params, input.candidates);
  const bool by_vertices = params.target_vertices > 0;
  if (faces >= input.candidates || (by_vertices && params.target_vertices >= input.all.vertices))
    return std::nullopt;
  const int unused = input.all.vertices - input.used_vertices;
  return StopCriterion{faces + input.staying_faces,
                       by_vertices ? std::max(0, params.target_vertices - unused) : 0, input.faces,
                       input.staying_faces};
}

/// Where stop_criterion returns none: the target that rules.
inline ReachedTarget reached_target(const DecimationParams& params, const InputFacts& input) {
  const int faces = target_faces(params, input.candidates);
  if (faces < input.candidates) return {"vertices", input.all.vertices, params.target_vertices};
  return {params.selected_only ? "selected faces" : "faces", input.candidates, faces};
}

}  // namespace curvdecim::detail
