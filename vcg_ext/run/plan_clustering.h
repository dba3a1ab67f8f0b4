// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "vcg_ext/clustering/cell_grid.h"
#include "vcg_ext/clustering/clustering_operator.h"
#include "vcg_ext/clustering/flat_mesh.h"
#include "vcg_ext/errors.h"
#include "vcg_ext/parallel/timetable.h"
#include "vcg_ext/run/target.h"
#include "vcg_ext/run/validation.h"

namespace curvdecim::detail {

inline constexpr Timetable clustering_times{57.0, 210.0, 0.0, 96.0};  // of a face

/// The diameter of a cell in the box. Throws InputError where the grid would have too many cells.
inline double cell_diameter(const ClusteringParams& params, const FlatMesh& mesh) {
  const double least = CellGrid::least_diameter(mesh.half_size);
  const double diameter = params.cell_size / mesh.box.diagonal;
  if (diameter >= least) return diameter;
  throw InputError("cell_size is " + decimal(params.cell_size) + ", but must be at least " +
                       decimal(least * mesh.box.diagonal) + ": an axis of the grid holds 2^" +
                       std::to_string(CellGrid::bits) + " cells.",
                   {"cell_size"});
}

/// 0: the size of the cells rules.
inline int target_faces(const ClusteringParams& params, const FlatMesh& mesh) {
  return params.target_fraction > 0.0 ? faces_of_fraction(params.target_fraction, mesh.face_count)
                                      : params.target_faces;
}

/// Where plan_clustering returns none.
inline ReachedTarget reached_target(const ClusteringParams& params, const FlatMesh& mesh) {
  return {params.selected_only ? "selected faces" : "faces", mesh.face_count,
          target_faces(params, mesh)};
}

/// nullopt: the mesh is small enough as it is. rounding: of a vertex that is written, in the mesh's
/// unit. Throws InputError where the cells are too small.
inline std::optional<ClusteringPlan> plan_clustering(const ClusteringParams& params,
                                                     const FlatMesh& mesh, double rounding) {
  ClusteringPlan plan;
  plan.target = target_faces(params, mesh);
  if (plan.target >= mesh.face_count) return std::nullopt;
  if (plan.target == 0 && params.cell_size > 0.0) plan.diameter = cell_diameter(params, mesh);
  plan.max_error = bound_in_box(params.max_error, rounding, mesh.box.diagonal);
  plan.rounding = rounding;
  plan.representative = params.representative;
  plan.mean_weight = params.mean_weight;
  plan.boundary_weight = params.boundary_weight;
  plan.manifold_edges = params.manifold_edges;
  return plan;
}

}  // namespace curvdecim::detail
