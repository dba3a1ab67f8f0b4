// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/removal/loop_part.h"

namespace curvdecim::detail {

/// Sees every removal just before it is done: attributes, records.
class RemovalObserver {
 public:
  virtual ~RemovalObserver() = default;

  virtual void before(const WorkingMesh& mesh, const VertexFan& fan,
                      const std::vector<NewFace>& faces) = 0;
};

using RemovalObservers = std::vector<RemovalObserver*>;

}  // namespace curvdecim::detail
