// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/host_mesh/read_carried.h"
#include "vcg_ext/host_mesh/read_mesh.h"
#include "vcg_ext/host_mesh/write_back.h"
#include "vcg_ext/params.h"
#include "vcg_ext/removal/remove_vertices.h"
#include "vcg_ext/report.h"
#include "vcg_ext/run/conclude.h"
#include "vcg_ext/run/plan_removal.h"
#include "vcg_ext/run/run.h"

namespace curvdecim {

/// Decimates a vcg triangle mesh by vertex removal @cite schroeder1992, in place.
///
/// The mesh needs faces with vertex references and selection flags; no adjacency. The vertices that
/// stay keep all that they carry, to the bit. The mesh is left exactly as it was when the
/// parameters or the mesh cannot be used (throws InputError), when it is already small enough, and
/// when `progress` asks to stop (the report says Cancelled). It may stop short of the target; the
/// report says why. max_error of the report is a bound on the two-sided distance to the input.
///
/// Time O(n log n) for bounded valence, 400 bytes of memory a vertex.
template <class MeshType>
DecimationReport decimate_vertex_removal(MeshType& mesh, const VertexRemovalParams& params,
                                         const Progress& progress = {}) {
  using namespace detail;
  return reported<DecimationReport>(counts_of(mesh), params, progress, [&](const auto& run) {
    if (const auto plan = plan_removal(params, facts_ahead(counts_of(mesh))))
      plan->times.begin_preparing(run.parallel.progress());
    const ReadingPlan reading = plan_reading(params);
    WorkingCopy copy = read_mesh(mesh, reading, run.parallel);
    const InputFacts facts = facts_of(mesh, copy, params.selected_only);
    const auto plan = plan_removal(params, facts);
    auto traced = traced_input(mesh, copy, params.keep_map, run.parallel);
    if (!plan) return leave_alone(mesh, reached_target(params, facts), traced, run);
    Carried carried = read_carried(mesh, copy, reading, run.parallel, run.report);
    const Tally tally = remove_vertices(copy.mesh, *plan, {}, run.parallel);
    write_back(mesh, copy, carried, std::move(traced), run.parallel, run.report);
    conclude(tally, *plan, copy.mesh, copy.box.diagonal, run.report);
  });
}

/// Returns the class of every vertex of a face, by vcg vertex; nullopt: no face uses it. Throws
/// InputError.
template <class MeshType>
std::vector<std::optional<VertexClass>> vertex_classes(const MeshType& mesh,
                                                       const VertexRemovalParams& params) {
  using namespace detail;
  validate(params);
  const Parallel parallel(params.threads);
  ReadingPlan reading = plan_reading(params);
  reading.selected_only = false;
  WorkingCopy copy = read_mesh(mesh, reading, parallel);
  const RemovalPlan plan = plan_without_target(params, copy.box.diagonal);
  const auto classes_in_copy = classify(copy.mesh, plan, parallel);
  std::vector<std::optional<VertexClass>> classes(mesh.vert.size());
  for (int f = 0; f < copy.mesh.connectivity.face_slots(); ++f)
    for (int i = 0; i < 3; ++i)
      classes[vcg::tri::Index(mesh, mesh.face[copy.mesh.face_origin[f]].cV(i))] =
          classes_in_copy[copy.mesh.connectivity.face(f)[i]];
  return classes;
}

}  // namespace curvdecim
