// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include "vcg_ext/clustering/clustering_operator.h"
#include "vcg_ext/host_mesh/cluster_write_back.h"
#include "vcg_ext/host_mesh/read_cells.h"
#include "vcg_ext/host_mesh/read_flat.h"
#include "vcg_ext/params.h"
#include "vcg_ext/report.h"
#include "vcg_ext/run/conclude.h"
#include "vcg_ext/run/plan_clustering.h"
#include "vcg_ext/run/run.h"

namespace curvdecim {

/// Decimates a vcg triangle mesh by vertex clustering, in place.
///
/// The mesh needs faces with vertex references and selection flags; no adjacency. Whatever
/// attributes it has are carried. It is left exactly as it was when the parameters or the mesh
/// cannot be used (throws InputError), when it is already small enough, and when `progress` asks to
/// stop (the report says Cancelled). No vertex moves further than largest_move of the report, which
/// is at most cell_size. With max_error no point of either surface is further from the other;
/// without it what is thinner than a cell may vanish. Edges may get more than two faces.
///
/// Time O(n), 100 bytes of memory a vertex and 200 an occupied cell.
template <class MeshType>
ClusteringReport decimate_vertex_clustering(MeshType& mesh, const ClusteringParams& params,
                                            const Progress& progress = {}) {
  using namespace detail;
  return reported<ClusteringReport>(counts_of(mesh), params, progress, [&](const auto& run) {
    clustering_times.begin_preparing(run.parallel.progress());
    const FlatMesh flat = read_flat(mesh, params.selected_only, run.parallel);
    const auto plan = plan_clustering(params, flat, rounding_in<MeshType>(flat.box));
    std::optional<InputVertices<MeshType>> input;
    if (params.keep_map) input.emplace(mesh, flat.box, run.parallel);
    if (!plan) return leave_alone(mesh, reached_target(params, flat), input, run);
    const ClusteringWeights weights = read_weights(mesh, flat, params.quality_weight, *plan, run);
    clustering_times.begin_steps("Clustering vertices", run.parallel.progress());
    const Clustering clustering = ClusteringOperator(flat, *plan, weights, run.parallel).run();
    const CarriedByCells carried = read_carried(mesh, flat, clustering, *plan, weights, run);
    run.parallel.progress().ask();
    write_back(mesh, flat, clustering, carried, std::move(input), run.parallel, run.report);
    conclude(clustering, *plan, flat, run.report);
  });
}

}  // namespace curvdecim
