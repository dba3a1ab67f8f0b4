// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "filter_curvdecim/host/host_api.h"
#include "filter_curvdecim/table/parameter.h"

namespace curvdecim::glue {

/// The vertices of the current layer before a filter changes it, for KeepMap: there is one number
/// for each of them, so that the changed layer cannot hold these.
class InputLayer {
 public:
  /// values: of the parameters; without KeepMap nothing is kept.
  InputLayer(const std::vector<Parameter>& parameters, const std::vector<Value>& values,
             const MeshModel& mesh);

  /// Takes from the mesh the map that a filter left (vcg_ext/vertex_map.h), and adds a layer of the
  /// vertices with it. Nothing where there is none: after a cancel.
  void add_to(MeshDocument& document, MeshModel& mesh) const;

 private:
  std::optional<std::vector<CMeshO::CoordType>> points_;  // nullopt: not asked for
};

}  // namespace curvdecim::glue
