// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/seams.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/passes/crossing_places.h"
#include "vcg_ext/passes/pass_schedule.h"
#include "vcg_ext/passes/passes_within.h"

namespace curvdecim::detail {

/// Tells whether passes can compute as a metric does: it has allows_passes(), remember(parallel),
/// take_weights(parallel), merged(weight, weight) and resume(memory, weights, parallel).
template <class MetricType, class = void>
struct HasPasses : std::false_type {};
template <class MetricType>
struct HasPasses<MetricType, std::void_t<decltype(&MetricType::allows_passes)>> : std::true_type {};

/// Whether the faces around v form a disk and are oriented alike; false for a vertex of very many.
inline bool is_closed_fan(const WorkingMesh& mesh, int v) {
  const TriangleConnectivity& connectivity = mesh.connectivity;
  if (mesh.kind[v] != VertexKind::Interior || connectivity.is_hub(v)) return false;
  std::array<int, TriangleConnectivity::hub> next;
  auto end = next.begin();
  for (int f : connectivity.faces_of(v)) {
    *end = connectivity.next_vertex(f, v);
    if (std::find(next.begin(), end, *end) != end) return false;
    ++end;
  }
  return true;
}

/// The mesh without what passes do not need, and what its metric, which is new, remembers; join()
/// has to follow. nullopt, with the mesh as it was: too much of it is to be held.
template <class MetricType>
std::optional<PassSurface> split(WorkingMesh& mesh, MetricType& metric, double attribute_weight,
                                 const Parallel& parallel) {
  const int vertices = mesh.connectivity.vertex_slots();
  PassSurface surface;
  surface.held.resize(vertices);
  parallel.for_each(vertices, [&](int v) {
    surface.held[v] = !is_closed_fan(mesh, v) || mesh.locked[v] || is_on_seam(mesh, v);
  });
  if (!surface.is_mostly_free()) return std::nullopt;
  surface.texture_weight = attribute_weight * mesh.texture_scale2;
  surface.color_weight = attribute_weight * mesh.color_scale2;
  surface.texture = std::exchange(mesh.texture, {});
  surface.color = std::exchange(mesh.color, {});
  surface.memory = metric.remember(parallel);  // with planes and lists, which can go then
  surface.weight = metric.take_weights(parallel);
  Array<FacePlane>().swap(mesh.plane);
  surface.faces = mesh.connectivity.release_faces();
  surface.wedges = mesh.wedges.release();
  surface.position = std::exchange(mesh.position, {});
  surface.importance.assign(mesh.importance.begin(), mesh.importance.end());
  surface.vertex_before = std::exchange(mesh.vertex_origin, {});  // the same, as it is new
  surface.face_origin = std::exchange(mesh.face_origin, {});
  surface.merges = std::exchange(mesh.merges, {});
  return surface;
}

/// The wedges of the surface's corners.
inline std::vector<Face> wedges_of(const PassSurface& surface, const Parallel& parallel) {
  std::vector<Face> wedges(surface.wedges.size());
  parallel.for_each(static_cast<int>(wedges.size()), [&](int f) {
    for (int i = 0; i < 3; ++i) wedges[f][i] = surface.carrier(f, surface.faces[f][i]);
  });
  return wedges;
}

/// The mesh and its metric with what passes have left, in memory for no more.
template <class MetricType>
void join(PassSurface surface, WorkingMesh& mesh, MetricType& metric, const Parallel& parallel) {
  mesh.wedges.reset(wedges_of(surface, parallel));
  mesh.texture = std::move(surface.texture);
  mesh.color = std::move(surface.color);
  surface.position.shrink_to_fit(), surface.faces.shrink_to_fit();
  mesh.position = std::move(surface.position);
  mesh.importance.assign(surface.importance.begin(), surface.importance.end());
  keep_only(surface.vertex_before, parallel, mesh.kind);
  keep_only(surface.vertex_before, parallel, mesh.locked);
  keep_only(surface.vertex_before, parallel, mesh.on_seam);
  mesh.kind.shrink_to_fit(), mesh.locked.shrink_to_fit();
  surface.vertex_before.shrink_to_fit(), surface.face_origin.shrink_to_fit();
  mesh.vertex_origin = std::move(surface.vertex_before);
  mesh.face_origin = std::move(surface.face_origin);
  mesh.merges = std::move(surface.merges);
  mesh.connectivity = TriangleConnectivity(std::move(surface.faces),
                                           static_cast<int>(mesh.position.size()), parallel);
  mesh.update_planes(parallel);
  metric.resume(surface.memory, surface.weight, parallel);
}

/// Before the first collapse: the surface, where passes come first; otherwise the metric is
/// initialized.
template <class MetricType>
std::optional<PassSurface> prepare(WorkingMesh& mesh, MetricType& metric, const CollapsePlan& plan,
                                   const Parallel& parallel) {
  if constexpr (HasPasses<MetricType>::value)
    if (plan.schedule.passes_goal < mesh.connectivity.face_count() && metric.allows_passes())
      if (std::optional<PassSurface> surface =
              split(mesh, metric, plan.limits.attribute_weight, parallel))
        return surface;
  metric.initialize(parallel);
  return std::nullopt;
}

/// The passes, which a bound may end earlier; where there is one, it has begun with what they
/// leave. Returns what the dearest collapse of the last pass cost.
template <class MetricType>
double run_passes(PassSurface& surface, const MetricType& metric, const CollapsePlan& plan,
                  BlendRecord& record, SurfaceBound* bound, const Parallel& parallel) {
  PassSchedule passes(surface, metric, plan, parallel);
  if (bound)
    run_within(*bound, passes, surface, record, parallel);
  else
    passes.run(record);
  return passes.largest_cost();
}

/// The same where faces may not cross. Passes do not look beyond the faces around: where some cross
/// afterwards, they are done anew, and hold the surface there. After some trials there are no
/// passes.
template <class MetricType>
double run_passes_apart(PassSurface& surface, const MetricType& metric, const CollapsePlan& plan,
                        BlendRecord& record, SurfaceBound* bound, const Parallel& parallel) {
  constexpr int trials = 3;
  PassSurface start = surface;
  for (int trial = 0; trial < trials && surface.is_mostly_free(); ++trial) {
    const double largest_cost = run_passes(surface, metric, plan, record, bound, parallel);
    const std::vector<Box> places = crossing_places(start, surface, parallel);
    if (places.empty()) return largest_cost;
    record.first_steps() = {};
    hold_in(places, start, parallel);
    surface = start;
  }
  if (bound) bound->stop();
  return 0.0;
}

/// Collapses edges of the surface in passes until it has about as many faces as the plan says, and
/// gives what is left to the mesh. Where there is a bound, it has begun with that, if there were
/// passes. Returns how many steps the record has then. Throws CancelRequest.
template <class MetricType>
int collapse_in_passes(PassSurface surface, WorkingMesh& mesh, MetricType& metric,
                       const CollapsePlan& plan, BlendRecord& record, SurfaceBound* bound,
                       const Parallel& parallel, Tally& tally) {
  if constexpr (!HasPasses<MetricType>::value) {
    return 0;
  } else {
    const double largest_cost =
        plan.limits.prevents_crossings
            ? run_passes_apart(surface, metric, plan, record, bound, parallel)
            : run_passes(surface, metric, plan, record, bound, parallel);
    tally.count_step(largest_cost, bound ? bound->at_start() : 0.0);
    join(std::move(surface), mesh, metric, parallel);
    return record.first_steps().count();
  }
}

}  // namespace curvdecim::detail
