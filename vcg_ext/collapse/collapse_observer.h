// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/mesh/edge_charts.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// Sees every collapse just before it is done: attributes, records.
class CollapseObserver {
 public:
  virtual ~CollapseObserver() = default;

  /// Called before collapses with numbers below `count`.
  virtual void make_room(int count) = 0;

  /// charts: empty where corners are not told apart. number: counts the collapses in the order in
  /// which they can be replayed. Collapses whose neighbourhoods share no vertex may be told at the
  /// same time.
  virtual void before(const WorkingMesh& mesh, const EdgeNeighborhood& around,
                      const EdgeCharts& charts, const VertexMerge& merge, int number) = 0;

  /// v, which had no face, has taken over some of the faces of `source`, at the same place, and
  /// these wedges. number: in the order of the collapses.
  virtual void copied(const WorkingMesh&, int /*v*/, int /*source*/,
                      const std::vector<Wedges::Parted>& /*wedges*/, int /*number*/) {}

  /// Face f, which was dead, lies between vertices that have other faces, too.
  virtual void added(const WorkingMesh&, int /*f*/) {}

  virtual void renumber(const Renumbering& numbers) = 0;
};

using CollapseObservers = std::vector<CollapseObserver*>;

}  // namespace curvdecim::detail
