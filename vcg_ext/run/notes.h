// SPDX-License-Identifier: GPL-3.0-or-later
// What a run tells its user in words, beside the figures.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/mesh/charts.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/report.h"
#include "vcg_ext/run/grouped.h"

namespace curvdecim::detail {

inline void note_cancelled(DecimationReport& report) {
  report.stopped_by = StopReason::Cancelled;
  report.notes.push_back("Cancelled: the mesh is unchanged.");
}

/// A target that the mesh has reached as it is.
struct ReachedTarget {
  const char* what;  ///< is counted
  int current, target;
};

inline void note_nothing_to_do(const ReachedTarget& reached, DecimationReport& report) {
  report.notes.push_back("Nothing to do: the mesh has " + grouped(reached.current) + ' ' +
                         reached.what + " already, the target is " + grouped(reached.target) + '.');
}

/// use: what asks for the quality.
inline void note_no_quality(const std::string& use, DecimationReport& report) {
  report.notes.push_back(use + " has no effect: no vertex has a quality above zero.");
}

/// removed: faces that were left out at reading.
inline void note_repairs(const WorkingMesh& mesh, std::size_t removed, bool keeps_topology,
                         DecimationReport& report) {
  if (removed > 0)
    report.notes.push_back("Removed " + std::to_string(removed) +
                           " faces that used a vertex twice or repeated another face.");
  const auto non_manifold = std::count_if(mesh.kind.begin(), mesh.kind.end(),
                                          [](VertexKind k) { return k >= VertexKind::Curve; });
  if (non_manifold > 0)
    report.notes.push_back(std::to_string(non_manifold) + " vertices are non-manifold" +
                           (keeps_topology ? "; there will not be more." : "."));
}

/// joined: pairs of border edges that lay on each other; differ: some of their vertices do, in what
/// they carry.
inline void note_borders(int joined, bool differ, DecimationReport& report) {
  if (joined == 0) return;
  report.notes.push_back(
      "Joined " + std::to_string(joined) + " pairs of border edges that lay on each other." +
      (differ ? " Vertices that differ in colour, quality, texture or custom values come out as "
                "copies in one place."
              : ""));
}

/// Border vertices that lie where another one lies: faces that were never joined. Vertices are in
/// the order of a space-filling curve, so that coincident ones are neighbours. vertex_of: what they
/// were read from; copies of one are not meant.
inline int count_coincident_borders(const WorkingMesh& mesh, const std::vector<int>& vertex_of) {
  int count = 0;
  for (std::size_t v = 1; v < mesh.position.size(); ++v)
    count += mesh.kind[v] == VertexKind::Boundary && mesh.position[v] == mesh.position[v - 1] &&
             vertex_of[v] != vertex_of[v - 1];
  return count;
}

/// For runs that join no vertices.
inline void note_open_seams(const WorkingMesh& mesh, const std::vector<int>& vertex_of,
                            DecimationReport& report) {
  if (const int coincident = count_coincident_borders(mesh, vertex_of); coincident > 0)
    report.notes.push_back(
        std::to_string(coincident) +
        " border vertices lie where another one lies. Such seams do not close and "
        "hinder decimation; merge close vertices first.");
}

inline void note_seams(DecimationReport& report) {
  report.notes.push_back(
      "The texture has seams. They are carried, and may shift as far as the surface does.");
}

/// Says so where the seams of a mesh leave little room. mesh: of a texture; before the collapses.
inline void note_seams(const WorkingMesh& mesh, DecimationReport& report) {
  constexpr double most = 0.5;  // of the vertices
  const auto on_seams = std::count(mesh.on_seam.begin(), mesh.on_seam.end(), std::uint8_t{1});
  const double share = static_cast<double>(on_seams) / static_cast<double>(mesh.position.size());
  if (share < most) return note_seams(report);
  const int charts = find_charts(mesh).count;
  report.notes.push_back(
      "The texture is in " + grouped(charts) + " charts of " +
      grouped((mesh.connectivity.face_count() + charts / 2) / charts) + " faces in the mean, and " +
      std::to_string(std::lround(100.0 * share)) +
      " % of the vertices are on seams, which hold them in place. For far fewer faces, simplify a "
      "copy that has no texture (saved as STL, for example), give it a new parametrization, and "
      "bring the image over by 'Transfer: Vertex Attributes to Texture (1 or 2 meshes)' in the "
      "menu Filters > Texture.");
}

/// mesh: after the collapses.
inline void note_pairs(const WorkingMesh& mesh, DecimationReport& report) {
  int non_manifold = 0;
  for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v)
    non_manifold += mesh.kind[v] >= VertexKind::Curve && mesh.connectivity.faces_of(v).size() > 0;
  report.notes.push_back("Parts could join, so that the topology was not preserved: " +
                         std::to_string(report.pairs_contracted) +
                         " unconnected pairs were contracted, and " + std::to_string(non_manifold) +
                         " vertices are non-manifold now.");
}

/// "Gave way, being smaller than the error: 1 part, 2 holes; the largest was 0.5 across."
inline void note_what_gave_way(DecimationReport& report) {
  const std::array<std::pair<std::int64_t, const char*>, 4> kinds = {
      {{report.parts_removed, "part"},
       {report.holes_closed, "hole"},
       {report.handles_cut, "handle"},
       {report.junctions_parted, "junction"}}};
  std::string what;
  for (const auto& [count, name] : kinds) {
    if (count == 0) continue;
    what +=
        (what.empty() ? "" : ", ") + std::to_string(count) + ' ' + name + (count > 1 ? "s" : "");
  }
  if (what.empty()) return;
  std::ostringstream size;
  size << std::setprecision(4) << report.largest_removed;
  report.notes.push_back("Gave way, being smaller than the error: " + what + "; the largest was " +
                         size.str() + " across. Preserve topology keeps them.");
}

/// What the detector found, where faces may not cross that did not in the input.
inline void note_crossings(DecimationReport& report) {
  report.notes.push_back(
      report.crossing == 0
          ? "No face crosses or touches another, beside its neighbours."
          : grouped(report.crossing) +
                " faces cross or touch others, beside their neighbours, as they did before.");
}

}  // namespace curvdecim::detail
