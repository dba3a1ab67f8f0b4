// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/report.h"
#include "vcg_ext/run/notes.h"
#include "vcg_ext/run/target.h"
#include "vcg_ext/run/validation.h"

namespace curvdecim::detail {

/// What a run has at hand.
template <class Report>
struct Run {
  const Parallel& parallel;
  Report& report;
};

/// The frame of every decimation around its body(run): parameters are checked before the mesh is
/// touched, a cancel leaves a report that says so, and the time is taken. Throws InputError.
template <class Report, class Params, class Body>
Report reported(const Counts& before, const Params& params, const Progress& progress, Body body) {
  const auto start = std::chrono::steady_clock::now();
  validate(params);
  require_target(params);
  Report unchanged;
  unchanged.faces_before = unchanged.faces = before.faces;
  unchanged.vertices_before = unchanged.vertices = before.vertices;
  Report report = unchanged;
  try {
    const Parallel parallel(params.threads, progress);
    body(Run<Report>{parallel, report});
  } catch (const CancelRequest&) {
    report = unchanged;
    note_cancelled(report);
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace curvdecim::detail
