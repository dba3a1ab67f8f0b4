// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/passes/pass_schedule.h"

namespace curvdecim::detail {

/// Tells whether passes can compute as a metric does: it has allows_passes(), is_smooth(v),
/// pass_weight(v), merged(weight, weight), take_memory(parallel) and resume(memory, weights,
/// parallel).
template <class MetricType, class = void>
struct HasPasses : std::false_type {};
template <class MetricType>
struct HasPasses<MetricType, std::void_t<decltype(&MetricType::allows_passes)>> : std::true_type {};

/// The mesh and its metric without what passes do not need; join() has to follow.
template <class MetricType>
PassSurface split(WorkingMesh& mesh, MetricType& metric, const Parallel& parallel) {
  const int vertices = mesh.connectivity.vertex_slots(), faces = mesh.connectivity.face_slots();
  PassSurface surface;
  surface.memory = metric.take_memory(parallel);  // with planes and lists, which can go then
  std::vector<FacePlane>().swap(mesh.plane);
  surface.faces = mesh.connectivity.release_faces();
  surface.held.resize(vertices), surface.weight.resize(vertices);
  parallel.for_each(vertices, [&](int v) {
    surface.held[v] =
        mesh.kind[v] != VertexKind::Interior || mesh.locked[v] || !metric.is_smooth(v);
    surface.weight[v] = metric.pass_weight(v);
  });
  surface.position = std::exchange(mesh.position, {});
  surface.importance.assign(mesh.importance.begin(), mesh.importance.end());
  surface.vertex_before.resize(vertices), surface.face_before.resize(faces);
  std::iota(surface.vertex_before.begin(), surface.vertex_before.end(), 0);
  std::iota(surface.face_before.begin(), surface.face_before.end(), 0);
  return surface;
}

/// The mesh and its metric with what passes have left.
template <class MetricType>
void join(PassSurface surface, WorkingMesh& mesh, MetricType& metric, const Parallel& parallel) {
  mesh.position = std::move(surface.position);
  mesh.importance.assign(surface.importance.begin(), surface.importance.end());
  keep_only(surface.vertex_before, parallel, mesh.kind);
  keep_only(surface.vertex_before, parallel, mesh.locked);
  keep_only(surface.vertex_before, parallel, mesh.vertex_origin);
  keep_only(surface.face_before, parallel, mesh.face_origin);
  mesh.connectivity =
      TriangleConnectivity(std::move(surface.faces), static_cast<int>(mesh.position.size()));
  mesh.update_planes(parallel);
  metric.resume(surface.memory, surface.weight, parallel);
}

/// Collapses edges of the mesh in passes until it has about as many faces as the plan says. Returns
/// how many steps the record has then. Throws CancelRequest.
template <class MetricType>
int collapse_in_passes(WorkingMesh& mesh, MetricType& metric, const CollapsePlan& plan,
                       BlendRecord& record, const Parallel& parallel) {
  if constexpr (!HasPasses<MetricType>::value) {
    return 0;
  } else {
    if (plan.schedule.passes_goal >= mesh.connectivity.face_count() || !metric.allows_passes())
      return 0;
    PassSurface surface = split(mesh, metric, parallel);
    BlendSteps steps = PassSchedule(surface, metric, plan, parallel).run(record.is_over_surface());
    join(std::move(surface), mesh, metric, parallel);
    const std::size_t count = steps.over_surface.size() + steps.on_edge.size();
    record.begin_with(std::move(steps));
    return static_cast<int>(count);
  }
}

}  // namespace curvdecim::detail
