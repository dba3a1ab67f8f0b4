// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "vcg_ext/mesh/attribute_notes.h"
#include "vcg_ext/mesh/decimation_setup.h"
#include "vcg_ext/mesh/sharp_edges.h"
#include "vcg_ext/mesh/write_back.h"
#include "vcg_ext/operators/vertex_removal.h"
#include "vcg_ext/validation.h"

namespace curvdecim {

/// The sharp edges, and the seams of a wedge texture, which nothing leaves.
inline FeatureEdges feature_edges(const WorkingMesh& mesh, const VertexRemovalParams& params,
                                  const std::optional<WedgeTexture>& wedges,
                                  const Parallel& parallel) {
  const SharpEdges sharp(mesh, params.feature_angle);
  return FeatureEdges(mesh.connectivity, parallel, [&](int f, int g, int a, int b) {
    if (wedges && wedges->is_seam(mesh, f, g, a, b)) return EdgeMark::Held;
    if (!sharp.between(f, g)) return EdgeMark::None;
    return params.preserve_features ? EdgeMark::Held : EdgeMark::Feature;
  });
}

/// The smaller of both bounds on the accumulated error; 0: there is none.
inline double tighter_bound(const VertexRemovalParams& params) {
  const auto [low, high] = std::minmax(params.max_error, params.distance_bound);
  return low > 0.0 ? low : high;
}

/// The run itself; the mesh changes at its end only. Throws InputError and CancelRequest.
template <class MeshType>
void run_vertex_removal(MeshType& mesh, VertexRemovalParams params, ProgressMeter& progress,
                        DecimationReport& report) {
  const Parallel parallel(params.threads, [&] { progress.ask(); });
  params.max_error = tighter_bound(params);
  Snapshot snapshot = take_snapshot(mesh, parallel);
  const std::optional<StopCriterion> stop = set_up(mesh, params, snapshot, report);
  if (!stop) return;
  note_open_seams(snapshot, report);
  params.max_error /= snapshot.box.diagonal;
  std::optional<WedgeTexture> wedges = read_wedges(mesh, snapshot);
  note_faux_edges(mesh, report);
  VertexRemover remover(snapshot.mesh, feature_edges(snapshot.mesh, params, wedges, parallel),
                        params);
  if (wedges) remover.add_observer(*wedges);
  VertexRemoval(snapshot.mesh, remover, params, *stop).run(parallel, progress, report);
  report.max_error *= snapshot.box.diagonal;
  WriteBack<MeshType>(mesh, snapshot).run(BlendRecord(), {}, wedges);
}

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
  return reported(mesh, params, progress, "no vertex is left that may go",
                  [&](ProgressMeter& meter, DecimationReport& report) {
                    run_vertex_removal(mesh, params, meter, report);
                  });
}

/// The class of every vertex of a face, by vcg vertex; nullopt: no face uses it. Throws InputError.
template <class MeshType>
std::vector<std::optional<VertexClass>> vertex_classes(const MeshType& mesh,
                                                       const VertexRemovalParams& params) {
  validate(params);
  const Parallel parallel(params.threads);
  Snapshot snapshot = take_snapshot(mesh, parallel);
  const VertexRemover remover(snapshot.mesh,
                              feature_edges(snapshot.mesh, params, std::nullopt, parallel), params);
  std::vector<std::optional<VertexClass>> classes(mesh.vert.size());
  VertexFan fan;
  for (std::size_t v = 0; v < snapshot.vertex_of.size(); ++v)
    classes[snapshot.vertex_of[v]] = remover.class_at(static_cast<int>(v), fan);
  return classes;
}

}  // namespace curvdecim
