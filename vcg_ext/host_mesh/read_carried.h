// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

#include <algorithm>
#include <string>
#include <vector>

#include "vcg_ext/attributes/carried.h"
#include "vcg_ext/collapse/collapse_plan.h"
#include "vcg_ext/host_mesh/attributes.h"
#include "vcg_ext/host_mesh/read_colors.h"
#include "vcg_ext/host_mesh/read_wedges.h"
#include "vcg_ext/host_mesh/working_copy.h"
#include "vcg_ext/mesh/attribute_scale.h"
#include "vcg_ext/run/notes.h"
#include "vcg_ext/run/plan_reading.h"

namespace curvdecim::detail {

/// True if a vertex attribute other than the normal differs among these vertices of the vcg mesh.
template <class MeshType>
bool has_varying_attributes(const MeshType& mesh, const std::vector<int>& vertices,
                            const Parallel& parallel) {
  bool varies = false;
  VertexAttributes(mesh).for_each_but_normal([&](auto read, auto) {
    const auto first = read(vertices[0]);
    varies = varies || any_where(static_cast<int>(vertices.size()), parallel,
                                 [&](int i) { return !(read(vertices[i]) == first); });
  });
  return varies;
}

template <class MeshType>
void note_faux_edges(const MeshType& mesh, const Parallel& parallel, DecimationReport& report) {
  const auto is_marked = [&](int f) { return !mesh.face[f].IsD() && mesh.face[f].IsAnyF(); };
  if (any_where(static_cast<int>(mesh.face.size()), parallel, is_marked))
    report.notes.push_back(
        "Marks of edges inside polygons (faux edges) are dropped: the result is of triangles.");
}

/// Names what is not carried in full, apart from seams.
template <class MeshType>
void note_dropped_attributes(const MeshType& mesh, const Parallel& parallel,
                             DecimationReport& report) {
  note_faux_edges(mesh, parallel, report);
  if (const std::string names = names_of_unknown(mesh.vert_attr); !names.empty())
    report.notes.push_back("Custom vertex attributes of other types than numbers and points (" +
                           names + ") stay with the vertices that remain.");
}

/// Weighs the vertices of the copy by the quality of the host's, if that was asked for.
template <class MeshType>
void weigh_by_quality(const MeshType& mesh, bool quality_weight, WorkingCopy& copy,
                      DecimationReport& report) {
  if (!quality_weight) return;
  copy.mesh.importance = importance_from_quality(mesh, copy.vertex_of);
  if (copy.mesh.importance.empty()) note_no_quality("The weight by quality", report);
}

/// Room for the collapses: some are numbered and refused in the end.
inline std::size_t expected_collapses(const WorkingMesh& mesh, const StopCriterion& stop) {
  constexpr double ample = 1.2;
  return static_cast<std::size_t>(ample * std::max(0.0, stop.collapses_left(mesh.connectivity)));
}

/// Reads what the mesh carries, and what weighs its vertices, for a run of collapses; notes what
/// the user should know of both.
template <class MeshType>
Carried read_carried(const MeshType& mesh, WorkingCopy& copy, const ReadingPlan& reading,
                     const CollapsePlan& plan, const Parallel& parallel, DecimationReport& report) {
  weigh_by_quality(mesh, reading.quality_weight, copy, report);
  note_repairs(copy.mesh, copy.unusable.size(), plan.limits.keeps_topology, report);
  Carried carried;
  carried.copies_differ = read_wedges(mesh, copy, reading.keep_borders_of, parallel);
  find_seams(copy.mesh, parallel);
  if (plan.limits.attribute_weight > 0.0) read_colors(mesh, copy, parallel);
  copy.mesh.texture_scale2 = texture_scale2(copy.mesh, parallel);
  copy.mesh.color_scale2 = color_scale2(copy.mesh, parallel);
  const bool by_wedge = copy.mesh.wedges.exist();
  const bool vary = has_varying_attributes(mesh, copy.vertex_of, parallel);
  carried.blended = BlendRecord(vary, expected_collapses(copy.mesh, plan.stop), by_wedge);
  note_borders(copy.borders_joined, carried.copies_differ, report);
  if (plan.pair_distance == 0.0) note_open_seams(copy.mesh, copy.vertex_of, report);
  if (!copy.mesh.texture.empty() && !copy.mesh.on_seam.empty()) note_seams(copy.mesh, report);
  note_dropped_attributes(mesh, parallel, report);
  return carried;
}

/// The same for removals of vertices: those that stay keep all that they carry.
template <class MeshType>
Carried read_carried(const MeshType& mesh, WorkingCopy& copy, const ReadingPlan& reading,
                     const Parallel& parallel, DecimationReport& report) {
  weigh_by_quality(mesh, reading.quality_weight, copy, report);
  note_repairs(copy.mesh, copy.unusable.size(), true, report);
  Carried carried;
  carried.copies_differ = read_wedges(mesh, copy, reading.keep_borders_of, parallel);
  note_borders(copy.borders_joined, carried.copies_differ, report);
  note_open_seams(copy.mesh, copy.vertex_of, report);
  note_faux_edges(mesh, parallel, report);
  return carried;
}

}  // namespace curvdecim::detail
