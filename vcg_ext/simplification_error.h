// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <utility>

#include "vcg_ext/error_params.h"
#include "vcg_ext/error_report.h"
#include "vcg_ext/host_mesh/read_measured.h"
#include "vcg_ext/parallel/timetable.h"
#include "vcg_ext/run/validation.h"

namespace curvdecim {

namespace detail {

inline constexpr Timetable error_times{300.0, 3000.0, 0.0, 10.0};  // of a face

inline void validate(const ErrorParams& params) {
  validate_fields(params);
  if (params.relative_to == RelativeTo::Tolerance && params.tolerance == 0.0)
    throw InputError(
        "relative_to is Tolerance, but tolerance is 0. Give one, or choose another "
        "unit.",
        {"relative_to", "tolerance"});
}

/// read(), with the mesh that cannot be read named in the error.
template <class Read>
auto reading(const std::string& which, Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw InputError(which + ": " + error.what(), error.fields);
  }
}

/// Reads both meshes, measures, and writes the qualities.
template <class MeshType>
ErrorReport measure_meshes(MeshType& original, MeshType& simplified, const ErrorParams& params,
                           const Parallel& parallel) {
  error_times.begin_preparing(parallel.progress());
  const std::string original_mesh = "The original mesh", simplified_mesh = "The simplified mesh";
  UnitBox box;
  const ReadError first = reading(original_mesh, [&] {
    WorkingCopy copy = read_mesh(original, false, parallel);
    box = box_of(original, copy);
    return read_in_box(box, original, std::move(copy), parallel);
  });
  const ReadError second = reading(simplified_mesh, [&] {
    return read_in_box(box, simplified, read_mesh(simplified, false, parallel), parallel);
  });
  error_times.begin_steps("Measuring", parallel.progress());
  const MeasuredError measured =
      ErrorMeasurement(first.input, second.input, box.diagonal, params, parallel).measure();
  parallel.progress().ask();
  if (params.save_quality) {
    write_quality(original, first.vertex_of, measured.at_original);
    write_quality(simplified, second.vertex_of, measured.at_simplified);
  }
  return measured.report;
}

}  // namespace detail

/// How far a simplified mesh is from its original, and what else has changed: two-sided distances
/// from samples, uniform by area, to the exact nearest points; their maximum also from all vertices
/// and along all edges. With save_quality, the quality of every vertex of a face becomes its
/// distance to the other mesh. Where `progress` asked to stop, the report says so, and both meshes
/// are as they were. Throws InputError.
template <class MeshType>
ErrorReport simplification_error(MeshType& original, MeshType& simplified,
                                 const ErrorParams& params = {}, const Progress& progress = {}) {
  using namespace detail;
  validate(params);
  const auto start = std::chrono::steady_clock::now();
  try {
    ErrorReport report =
        measure_meshes(original, simplified, params, Parallel(params.threads, progress));
    report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return report;
  } catch (const CancelRequest&) {
    ErrorReport report;
    report.stopped_by = StopReason::Cancelled;
    report.notes.emplace_back("Cancelled: the meshes are unchanged.");
    return report;
  }
}

}  // namespace curvdecim
