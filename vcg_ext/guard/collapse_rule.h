// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "vcg_ext/guard/limits.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/seams.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// Which kind may go into which; nullopt: the edge stays. A locked vertex and a junction stay where
/// they are; a vertex of a boundary or a curve goes along it only.
///
/// | a \ b    | interior | boundary | curve    | junction |
/// |----------|----------|----------|----------|----------|
/// | interior | anywhere | onto b   | onto b   | onto b   |
/// | boundary |          | anywhere | stays    | onto b   |
/// | curve    |          |          | anywhere | onto b   |
/// | junction |          |          |          | stays    |
///
/// Between two vertices on seams only an edge of a seam may collapse: any other would pinch a
/// chart.
class CollapseRule {
 public:
  CollapseRule(const WorkingMesh& mesh, const CollapseLimits& limits)
      : mesh_(mesh),
        topology_(limits.keeps_topology),
        boundary_(limits.keeps_boundary),
        gives_way_(limits.topology_gives_way) {}

  /// An edge between two such vertices may collapse to anywhere, unless it pinches a chart.
  bool is_free(int v) const {
    return mesh_.kind[v] == VertexKind::Interior && mesh_.locked[v] == 0;
  }

  /// Between two vertices on seams only a seam may collapse.
  bool pinches(Edge edge) const {
    return is_on_seam(mesh_, edge.a) && is_on_seam(mesh_, edge.b) && !is_seam_edge(mesh_, edge);
  }

  /// Where the topology gives way, sheets that meet in an end may come apart first.
  std::optional<Allowed> operator()(Edge edge) const {
    if (pinches(edge)) return std::nullopt;
    const std::optional<Allowed> allowed = of_kinds(edge);
    if (allowed || !gives_way_ || mesh_.locked[edge.a] || mesh_.locked[edge.b]) return allowed;
    return Allowed::Anywhere;
  }

  /// As the table says.
  std::optional<Allowed> of_kinds(Edge edge) const {
    const VertexKind a = mesh_.kind[edge.a], b = mesh_.kind[edge.b];
    if (is_free(edge.a) && is_free(edge.b)) return Allowed::Anywhere;  // nearly all
    const bool a_stays = stays(edge.a), b_stays = stays(edge.b);
    if (a_stays && b_stays) return std::nullopt;
    if (a_stays) return may_go_onto(b, a) ? std::optional(Allowed::OntoA) : std::nullopt;
    if (b_stays) return may_go_onto(a, b) ? std::optional(Allowed::OntoB) : std::nullopt;
    if (a == b || is_unheld(a, b)) return Allowed::Anywhere;
    if (!may_go_onto(a, b) && !may_go_onto(b, a)) return std::nullopt;
    return a > b ? Allowed::OntoA : Allowed::OntoB;
  }

 private:
  bool stays(int v) const {
    return mesh_.locked[v] || (topology_ && mesh_.kind[v] == VertexKind::Junction);
  }

  static bool may_go_onto(VertexKind from, VertexKind to) {
    return from == VertexKind::Interior || from == to || to == VertexKind::Junction;
  }

  /// Where the user did not ask to keep it, the boundary is held by its quadrics alone.
  bool is_unheld(VertexKind a, VertexKind b) const {
    return !topology_ || (!boundary_ && a <= VertexKind::Boundary && b <= VertexKind::Boundary);
  }

  const WorkingMesh& mesh_;
  const bool topology_, boundary_, gives_way_;
};

}  // namespace curvdecim::detail
