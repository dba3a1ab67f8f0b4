// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/metric/candidate.h"

namespace curvdecim {

/// Sees every collapse just before it is done: attributes, records.
class CollapseObserver {
 public:
  virtual ~CollapseObserver() = default;
  virtual void before(const WorkingMesh& mesh, const EdgeNeighborhood& around,
                      const Collapse& collapse) = 0;
};

}  // namespace curvdecim
