// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/dispatch.h"
#include "vcg_ext/mesh/attribute_notes.h"
#include "vcg_ext/mesh/decimation_setup.h"
#include "vcg_ext/mesh/write_back.h"
#include "vcg_ext/operators/edge_collapse.h"
#include "vcg_ext/refine/refinement.h"
#include "vcg_ext/validation.h"

namespace curvdecim {

/// Only moves that keep what was asked for: with MaxError no bound is known for a vertex that moves
/// on its own, with HalfEdge no vertex moves at all.
inline bool may_refine(const EdgeCollapseParams& params) {
  return params.refine_sweeps > 0 && params.max_error == 0.0 &&
         params.placement != Placement::HalfEdge;
}

inline bool may_refine(const SphereParams& params) {
  return params.refine_sweeps > 0 && params.max_error == 0.0;
}

/// What the mesh was before the collapses, read once more rather than kept through them.
template <class MeshType, class Params>
InputSurface read_input(const MeshType& mesh, const Params& params, const Parallel& parallel) {
  Snapshot snapshot = take_snapshot(mesh, parallel);
  if (params.quality_weight)
    snapshot.mesh.importance = importance_from_quality(mesh, snapshot.vertex_of);
  return input_surface(std::move(snapshot.mesh), params, snapshot.box.diagonal, parallel);
}

/// So that what is gone needs no memory.
inline void pack(WorkingMesh& mesh, std::optional<WedgeTexture>& wedges) {
  const Renumbering without_gaps(mesh.connectivity);
  mesh.renumber(without_gaps);
  mesh = WorkingMesh(mesh);  // a copy has no room to spare
  if (wedges) wedges->renumber(without_gaps);
}

/// Returns the vertices that the refinement moved, with where on the input they take their
/// attributes from.
template <class MeshType, class Params>
std::vector<BlendStep> refine(const MeshType& mesh, WorkingMesh& decimated, const Params& params,
                              std::optional<WedgeTexture>& wedges, const Parallel& parallel,
                              ProgressMeter& progress) {
  pack(decimated, wedges);
  if (decimated.connectivity.face_count() == 0) return {};  // may be without the link condition
  const InputSurface input = read_input(mesh, params, parallel);
  Refinement refinement(decimated, input, params, wedges ? &*wedges : nullptr, parallel);
  refinement.run(params.refine_sweeps, progress);
  return refinement.attributes();
}

/// What only PairDistance allows, and what came of it.
inline void note_pairs(const WorkingMesh& mesh, DecimationReport& report) {
  int non_manifold = 0;
  for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v)
    non_manifold += mesh.kind[v] >= VertexKind::Curve && mesh.connectivity.faces_of(v).size() > 0;
  report.notes.push_back("PreserveTopology was off because of PairDistance: " +
                         std::to_string(report.pairs_contracted) +
                         " unconnected pairs were contracted, and " + std::to_string(non_manifold) +
                         " vertices are non-manifold now.");
}

/// To have room for: the rounds number some that are refused in the end.
inline std::size_t expected_collapses(const WorkingMesh& mesh, const StopCriterion& stop) {
  constexpr double ample = 1.2;
  return static_cast<std::size_t>(ample * std::max(0.0, stop.collapses_left(mesh.connectivity)));
}

/// The run itself; the mesh changes at its end only. Throws InputError and CancelRequest.
template <class MeshType, class Params>
void run_edge_collapse(MeshType& mesh, Params params, ProgressMeter& progress,
                       DecimationReport& report) {
  const Parallel parallel(params.threads, [&] { progress.ask(); });
  Snapshot snapshot = take_snapshot(mesh, parallel);
  params.max_error /= snapshot.box.diagonal;
  const double pair_distance = pair_distance_of(params) / snapshot.box.diagonal;
  if (pair_distance > 0.0) params.preserve_topology = false;
  const std::optional<StopCriterion> stop = set_up(mesh, params, snapshot, report);
  if (!stop) return;
  if (pair_distance == 0.0) note_open_seams(snapshot, report);
  BlendRecord blend(has_varying_attributes(mesh, snapshot.vertex_of),
                    expected_collapses(snapshot.mesh, *stop));
  std::optional<WedgeTexture> wedges = read_wedges(mesh, snapshot);
  note_attributes(mesh, snapshot, wedges, report);
  with_metric(snapshot.mesh, params, snapshot.box.diagonal, [&](auto metric) {
    EdgeCollapse operation(snapshot.mesh, metric, params, scheduler_of(params), pair_distance,
                           *stop);
    operation.add_observer(blend);
    if (wedges) operation.add_observer(*wedges);
    operation.run(parallel, progress, report);
  });
  if (pair_distance > 0.0) note_pairs(snapshot.mesh, report);
  std::vector<BlendStep> refined;
  if (may_refine(params)) refined = refine(mesh, snapshot.mesh, params, wedges, parallel, progress);
  report.max_error *= snapshot.box.diagonal;
  WriteBack<MeshType>(mesh, snapshot).run(blend, refined, wedges);
}

/// params: EdgeCollapseParams with its preset resolved, or SphereParams.
template <class MeshType, class Params>
DecimationReport report_edge_collapse(MeshType& mesh, const Params& params,
                                      const Progress& progress) {
  return reported(mesh, params, progress, "no edge is left that may collapse",
                  [&](ProgressMeter& meter, DecimationReport& report) {
                    run_edge_collapse(mesh, params, meter, report);
                  });
}

/// Decimates a vcg triangle mesh by edge collapse, in place.
///
/// The mesh needs faces with vertex references and selection flags; no adjacency. Whatever vertex
/// attributes it has are carried. It is left exactly as it was when the parameters or the mesh
/// cannot be used (throws InputError), when it is already small enough, and when `progress` asks to
/// stop (the report says Cancelled). It may stop short of the target; the report says why.
///
/// Worst case: time O(n log n) for bounded valence, 320 bytes of memory a vertex.
template <class MeshType>
DecimationReport decimate_edge_collapse(MeshType& mesh, const EdgeCollapseParams& requested,
                                        const Progress& progress = {}) {
  return report_edge_collapse(mesh, with_preset(requested), progress);
}

/// The same by algebraic spheres @cite michaud2017.
///
/// Worst case: as decimate_edge_collapse, with 500 bytes of memory a vertex.
template <class MeshType>
DecimationReport decimate_algebraic_sphere(MeshType& mesh, const SphereParams& params,
                                           const Progress& progress = {}) {
  return report_edge_collapse(mesh, params, progress);
}

/// Writes to the quality of every vertex of a face the curvature that CurvatureWeighted sees, in
/// the mesh's unit, or the factor that it makes of it: with ScaleFree that of an edge with this
/// curvature at both ends, with ModelUnits at one end and none at the other. Throws InputError.
template <class MeshType>
void curvature_importance(MeshType& mesh, const ImportanceParams& params) {
  validate(params);
  const Parallel parallel(0);
  const Snapshot snapshot = take_snapshot(mesh, parallel);
  CurvatureParams shown = params;
  if (!params.as_factor) shown.alpha_units = AlphaUnits::ModelUnits;  // the curvature as such
  const CurvatureField field = curvature_field(snapshot.mesh, shown, parallel);
  const CurvatureWeight weight = curvature_weight(shown, field, snapshot.box.diagonal);
  const double length = snapshot.box.diagonal;
  const double unit =
      params.curvature_kind == CurvatureKind::Gaussian ? 1.0 / (length * length) : 1.0 / length;
  for (std::size_t v = 0; v < field.value.size(); ++v) {
    const double k = field.value[v];
    auto& quality = mesh.vert[snapshot.vertex_of[v]].Q();
    quality = static_cast<std::decay_t<decltype(quality)>>(
        params.as_factor ? weight.factor(weight.saturation(k)) : k * unit);
  }
}

}  // namespace curvdecim
