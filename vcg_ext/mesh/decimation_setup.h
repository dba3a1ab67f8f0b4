// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "vcg_ext/mesh/snapshot.h"
#include "vcg_ext/operators/stop_criterion.h"
#include "vcg_ext/params.h"
#include "vcg_ext/progress_meter.h"
#include "vcg_ext/report.h"
#include "vcg_ext/validation.h"

namespace curvdecim {

template <class MeshType>
DecimationReport initial_report(const MeshType& mesh) {
  DecimationReport report;
  report.faces_before = report.faces = mesh.fn;
  report.vertices_before = report.vertices = mesh.vn;
  return report;
}

/// Faces outside the selection stay, also unusable ones, and so do their vertices. Throws
/// InputError where nothing is selected.
template <class MeshType>
void lock_unselected(const MeshType& mesh, Snapshot& snapshot) {
  if (std::none_of(snapshot.selected.begin(), snapshot.selected.end(), [](bool s) { return s; }))
    throw InputError("Selected is on, but no face is selected. Select faces or turn Selected off.");
  std::vector<bool> locked(mesh.vert.size(), false);
  for (const auto& face : mesh.face)
    if (!face.IsD() && !face.IsS())
      for (int i = 0; i < 3; ++i) locked[vcg::tri::Index(mesh, face.cV(i))] = true;
  for (std::size_t v = 0; v < snapshot.vertex_of.size(); ++v)
    snapshot.mesh.locked[v] = locked[snapshot.vertex_of[v]];
  const auto stay = std::stable_partition(snapshot.unusable.begin(), snapshot.unusable.end(),
                                          [&](int f) { return mesh.face[f].IsS(); });
  snapshot.left_alone.assign(stay, snapshot.unusable.end());
  snapshot.unusable.erase(stay, snapshot.unusable.end());
}

/// The quality of these vertices, scaled to a largest value of 1, as a factor on the cost. Values
/// at or below zero count as nearly nothing; empty: no vertex has one above zero. Throws InputError
/// where one is not finite.
template <class MeshType>
std::vector<double> importance_from_quality(const MeshType& mesh,
                                            const std::vector<int>& vertices) {
  constexpr double least = 1e-6;  // of the largest: still ordered by error among themselves
  if (!vcg::tri::HasPerVertexQuality(mesh)) return {};
  std::vector<double> importance;
  for (int v : vertices) {
    importance.push_back(static_cast<double>(mesh.vert[v].cQ()));
    if (!std::isfinite(importance.back()))
      throw InputError("Vertex quality is used as a weight, but that of vertex " +
                       std::to_string(v) + " is not finite.");
  }
  const double largest = *std::max_element(importance.begin(), importance.end());
  if (!(largest > 0.0)) return {};
  for (double& value : importance) value = std::max(value / largest, least);
  return importance;
}

/// At least one face.
inline int faces_of_fraction(double fraction, int candidates) {
  return std::max(1, static_cast<int>(fraction * candidates));
}

/// Faces to keep among `candidates`, by the parameter that rules.
inline int target_faces(const DecimationParams& params, int candidates) {
  if (params.target_fraction > 0.0) return faces_of_fraction(params.target_fraction, candidates);
  if (params.target_vertices > 0) return 0;
  return params.target_faces == DecimationParams::no_target ? 0 : params.target_faces;
}

/// Border vertices that lie where another one lies: faces that were never joined. Vertices are in
/// the order of a space-filling curve, so that coincident ones are neighbours.
inline int count_coincident_borders(const WorkingMesh& mesh) {
  int count = 0;
  for (std::size_t v = 1; v < mesh.position.size(); ++v)
    count += mesh.kind[v] == VertexKind::Boundary && mesh.position[v] == mesh.position[v - 1];
  return count;
}

inline void note_repairs(const Snapshot& snapshot, bool preserve_topology,
                         DecimationReport& report) {
  if (!snapshot.unusable.empty())
    report.notes.push_back("Removed " + std::to_string(snapshot.unusable.size()) +
                           " faces that used a vertex twice or repeated another face.");
  const auto& kinds = snapshot.mesh.kind;
  const auto non_manifold = std::count_if(kinds.begin(), kinds.end(),
                                          [](VertexKind k) { return k >= VertexKind::Curve; });
  if (non_manifold > 0)
    report.notes.push_back(std::to_string(non_manifold) + " vertices are non-manifold" +
                           (preserve_topology ? "; there will not be more." : "."));
}

/// Where nothing joins them.
inline void note_open_seams(const Snapshot& snapshot, DecimationReport& report) {
  if (const int coincident = count_coincident_borders(snapshot.mesh); coincident > 0)
    report.notes.push_back(
        std::to_string(coincident) +
        " border vertices lie where another one lies. Such seams do not close and "
        "hinder decimation; merge close vertices first.");
}

inline void note_small_enough(DecimationReport& report) {
  report.notes.push_back(
      "The target is not below the current count: nothing to do, the mesh is unchanged.");
}

/// use: the parameter that asks for the quality.
inline void note_no_quality(const std::string& use, DecimationReport& report) {
  report.notes.push_back(use + " is on, but no vertex has a quality above zero: it has no effect.");
}

inline void require_target(const DecimationParams& params) {
  if (params.target_faces == DecimationParams::no_target && params.target_vertices == 0 &&
      params.target_fraction == 0.0 && params.max_error == 0.0)
    throw InputError(
        "No target is given. Set TargetFaceNum, TargetVertNum, TargetPerc or MaxError.");
}

/// Living faces that may change.
template <class MeshType>
int count_candidates(const MeshType& mesh, bool selected_only) {
  if (!selected_only) return mesh.fn;
  return static_cast<int>(std::count_if(mesh.face.begin(), mesh.face.end(),
                                        [](const auto& f) { return !f.IsD() && f.IsS(); }));
}

/// Locks, weights and the target in terms of the working mesh; notes what the user should know.
/// nullopt: the mesh is small enough as it is.
template <class MeshType>
std::optional<StopCriterion> set_up(const MeshType& mesh, const DecimationParams& params,
                                    Snapshot& snapshot, DecimationReport& report) {
  require_target(params);
  if (params.selected_only) lock_unselected(mesh, snapshot);
  const int candidates = count_candidates(mesh, params.selected_only),
            target = target_faces(params, candidates);
  const bool by_vertices = params.target_vertices > 0;
  if (target >= candidates || (by_vertices && params.target_vertices >= mesh.vn)) {
    note_small_enough(report);
    return std::nullopt;
  }
  if (params.quality_weight) {
    snapshot.mesh.importance = importance_from_quality(mesh, snapshot.vertex_of);
    if (snapshot.mesh.importance.empty()) note_no_quality("QualityWeight", report);
  }
  note_repairs(snapshot, params.preserve_topology, report);
  const auto outside = params.selected_only
                           ? std::count(snapshot.selected.begin(), snapshot.selected.end(), false)
                           : 0;
  const int unused = mesh.vn - snapshot.mesh.connectivity.vertex_count();
  return StopCriterion{target + static_cast<int>(outside),
                       by_vertices ? std::max(0, params.target_vertices - unused) : 0,
                       snapshot.mesh.connectivity.face_count()};
}

/// What is left, and why it is more than was asked for. exhausted: what the run had no more of.
template <class MeshType>
void finish(const MeshType& mesh, DecimationReport& report, const char* exhausted) {
  report.faces = mesh.fn;
  report.vertices = mesh.vn;
  if (report.stopped_by == StopReason::Cancelled)
    report.notes.push_back("Cancelled: the mesh is unchanged.");
  if (report.stopped_by != StopReason::NothingLeft) return;
  const auto most = std::max_element(report.rejected.begin(), report.rejected.end());
  std::string note =
      "Stopped at " + std::to_string(mesh.fn) + " faces, above the target: " + exhausted + '.';
  if (*most > 0)
    note += std::string(" Most were refused by ") +
            rejection_names[most - report.rejected.begin()] + '.';
  report.notes.push_back(note);
}

/// What every step by step decimation has around its run(meter, report): parameters that are
/// refused, cancel, time, and the report's end.
template <class MeshType, class Params, class Run>
DecimationReport reported(MeshType& mesh, const Params& params, const Progress& progress,
                          const char* exhausted, Run run) {
  const auto start = std::chrono::steady_clock::now();
  validate(params);
  ProgressMeter meter(progress);
  DecimationReport report = initial_report(mesh);
  try {
    run(meter, report);
  } catch (const CancelRequest&) {
    report.stopped_by = StopReason::Cancelled;
    report.max_error = 0.0;  // nothing changed
  }
  finish(mesh, report, exhausted);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace curvdecim
