// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/host/input_layer.h"

#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/allocate.h>

#include "vcg_ext/vertex_map.h"

namespace curvdecim::glue {
namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

bool is_map_wanted(const std::vector<Parameter>& parameters, const std::vector<Value>& values) {
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].field == "keep_map") return std::get<bool>(values[i]);
  return false;
}

/// Gives a new layer these vertices, and where each of them went.
void fill(MeshModel& layer, const std::vector<CMeshO::CoordType>& points,
          const std::vector<int>& goes_to) {
  CMeshO& cm = layer.cm;
  Allocator::AddVertices(cm, points.size());
  auto result = Allocator::AddPerVertexAttribute<CMeshO::ScalarType>(cm, result_vertex);
  for (std::size_t v = 0; v < points.size(); ++v) {
    cm.vert[v].P() = points[v];
    result[v] = static_cast<CMeshO::ScalarType>(goes_to[v]);
  }
  vcg::tri::UpdateBounding<CMeshO>::Box(cm);
}

}  // namespace

InputLayer::InputLayer(const std::vector<Parameter>& parameters, const std::vector<Value>& values,
                       const MeshModel& mesh) {
  if (!is_map_wanted(parameters, values)) return;
  points_.emplace();
  for (const auto& vertex : mesh.cm.vert) points_->push_back(vertex.cP());
}

void InputLayer::add_to(MeshDocument& document, MeshModel& mesh) const {
  if (!points_) return;
  auto goes_to = Allocator::FindPerMeshAttribute<std::vector<int>>(mesh.cm, result_vertex);
  if (!Allocator::IsValidHandle<std::vector<int>>(mesh.cm, goes_to)) return;
  MeshModel& layer = *document.addNewMesh("", mesh.label() + " (original vertices)", false);
  fill(layer, *points_, goes_to());
  layer.cm.Tr = mesh.cm.Tr;
  Allocator::DeletePerMeshAttribute(mesh.cm, result_vertex);
}

}  // namespace curvdecim::glue
