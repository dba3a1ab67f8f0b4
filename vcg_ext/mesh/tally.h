// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/report.h"

namespace curvdecim::detail {

/// The target as absolute counts; faces and vertices that take no part are counted by the caller.
struct StopCriterion {
  int faces = 0;     ///< stop at this many faces of the working mesh
  int vertices = 0;  ///< stop at this many vertices of the working mesh
  int start = 0;     ///< faces of the working mesh at the start
  int staying = 0;   ///< of these, faces that may not change

  /// False where a run goes as far as its bound lets it.
  bool has_target() const { return faces > staying || vertices > 0; }

  /// once_removed: what is about to go.
  bool reached(const TriangleConnectivity& connectivity, const Removed& once_removed = {}) const {
    return connectivity.face_count() - once_removed.faces <= faces ||
           connectivity.vertex_count() - once_removed.vertices <= vertices;
  }

  /// How many faces the next collapse may remove so that the target is missed by one at the most.
  int most_faces(const TriangleConnectivity& connectivity, const Removed& once_removed = {}) const {
    return connectivity.face_count() - once_removed.faces - faces + 1;
  }

  /// Collapses until the target, if each removes two faces and a vertex.
  double collapses_left(const TriangleConnectivity& connectivity) const {
    return std::min(0.5 * (connectivity.face_count() - faces),
                    1.0 * (connectivity.vertex_count() - vertices));
  }

  /// The part of the faces to go that is gone, 0..1. left: faces of the working mesh.
  double progress(int left) const {
    return std::clamp((start - left) / std::max(1.0, faces_to_go()), 0.0, 1.0);
  }
  double progress(const TriangleConnectivity& connectivity) const {
    return progress(connectivity.face_count());
  }

  /// From the start to the target, if each collapse removes two faces and a vertex.
  double faces_to_go() const {
    const double by_vertices = vertices > 0 ? start - 2.0 * vertices : HUGE_VAL;
    return std::min<double>(start - faces, by_vertices);
  }
};

/// What the steps of a run came to, in the box of diagonal 1.
struct Tally {
  StopReason stopped_by = StopReason::Target;
  double largest_error = 0.0;  // bound on the two-sided distance to the input, where it is known
  double cost_last = 0.0;
  Rejections rejected;
  Rejections before_look;  // of rejected, those before all that was left was asked once more
  std::int64_t pairs_contracted = 0;
  std::int64_t parts_removed = 0, holes_closed = 0, handles_cut = 0, junctions_parted = 0;
  double largest_removed = 0.0;  // of these: diameter of the box, or longest edge of the cut

  void note_size(double size) { largest_removed = std::max(largest_removed, size); }

  void note_error(double error) { largest_error = std::max(largest_error, error); }

  void count_step(double cost, double error) {
    cost_last = cost;
    note_error(error);
  }

  /// To be told when all that is left is asked about.
  void begin_look() { before_look = rejected; }

  /// What stood against steps when all that was left was asked for the last time.
  Rejections last_look() const {
    Rejections last = rejected;
    for (std::size_t i = 0; i < last.count.size(); ++i) last.count[i] -= before_look.count[i];
    return last;
  }

  /// Where nothing is left to do and the bound stood against some steps, the bound was the reason.
  void end(StopReason reason) {
    const bool bound = reason == StopReason::NothingLeft && rejected[Rejection::ErrorBound] > 0;
    stopped_by = bound ? StopReason::ErrorBound : reason;
  }
};

}  // namespace curvdecim::detail
