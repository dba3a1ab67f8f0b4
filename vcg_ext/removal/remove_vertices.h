// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/sharp_edges.h"
#include "vcg_ext/removal/removal_schedule.h"

namespace curvdecim::detail {

/// The lines of the mesh: its sharp edges, and seams, which nothing leaves.
inline FeatureEdges feature_edges(const WorkingMesh& mesh, const RemovalPlan& plan,
                                  const Parallel& parallel) {
  const SharpEdges sharp(mesh, plan.feature_angle);
  return FeatureEdges(mesh.connectivity, parallel, [&](int f, int g, int a, int b) {
    if (mesh.wedges.exist() && mesh.wedges.differ(mesh.connectivity, f, g, a, b))
      return EdgeMark::Held;
    if (!sharp.between(f, g)) return EdgeMark::None;
    return plan.preserve_features ? EdgeMark::Held : EdgeMark::Feature;
  });
}

/// The class of every vertex.
inline std::vector<VertexClass> classify(WorkingMesh& mesh, const RemovalPlan& plan,
                                         const Parallel& parallel) {
  const RemovalOperator removals(mesh, feature_edges(mesh, plan, parallel), plan, {});
  std::vector<VertexClass> classes;
  classes.reserve(mesh.position.size());
  VertexFan fan;
  for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v)
    classes.push_back(removals.class_at(v, fan));
  return classes;
}

/// Removes vertices of the mesh, those nearest to what is left first, as far as the plan says.
/// Throws CancelRequest.
inline Tally remove_vertices(WorkingMesh& mesh, const RemovalPlan& plan, RemovalObservers observers,
                             const Parallel& parallel) {
  RemovalOperator removals(mesh, feature_edges(mesh, plan, parallel), plan, std::move(observers));
  std::optional<SurfaceBound> bound;
  if (plan.max_error > 0.0 && mesh.connectivity.face_count() > 0) {
    bound.emplace(mesh, plan.max_error, plan.max_error_one_sided, parallel);
    bound->begin_with_input(), removals.measure_with(*bound);
  }
  const Tally tally = RemovalSchedule(mesh, removals, plan, parallel).run();
  assert((mesh.connectivity.validate(), true));
  return tally;
}

}  // namespace curvdecim::detail
