// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/decimation.h"

#include "vcg_ext/decimate.h"

namespace curvdecim::test {

namespace {

template <class MeshType>
Decimated decimated_as(const Shape& shape, const EdgeCollapseParams& params) {
  MeshType mesh;
  fill(mesh, shape);
  DecimationReport report = decimate(mesh, params);
  return {shape_of(mesh), std::move(report)};
}

}  // namespace

DecimationReport decimate(BareMesh& mesh, const EdgeCollapseParams& params,
                          const Progress& progress) {
  return decimate_edge_collapse(mesh, params, progress);
}

DecimationReport decimate(FloatMesh& mesh, const EdgeCollapseParams& params,
                          const Progress& progress) {
  return decimate_edge_collapse(mesh, params, progress);
}

DecimationReport decimate(RichMesh& mesh, const EdgeCollapseParams& params,
                          const Progress& progress) {
  return decimate_edge_collapse(mesh, params, progress);
}

void importance(RichMesh& mesh, const ImportanceParams& params) {
  curvature_importance(mesh, params);
}

Decimated decimated(const Shape& shape, const EdgeCollapseParams& params) {
  return decimated_as<BareMesh>(shape, params);
}

Decimated decimated_float(const Shape& shape, const EdgeCollapseParams& params) {
  return decimated_as<FloatMesh>(shape, params);
}

EdgeCollapseParams to_faces(int faces) {
  EdgeCollapseParams params;
  params.target_faces = faces;
  return params;
}

EdgeCollapseParams Variant::with_target(int faces) const {
  EdgeCollapseParams result = params;
  result.target_faces = faces;
  return result;
}

std::vector<Variant> all_variants() {
  std::vector<Variant> variants;
  EdgeCollapseParams p;
  p.preset = Preset::Custom;
  const auto named = [](auto value, const char* name) { return std::pair(value, name); };
  for (const auto& [metric, metric_name] :
       {named(Metric::Quadric, "Quadric"), named(Metric::CurvatureWeighted, "Weighted"),
        named(Metric::CurvatureAdditive, "Additive")})
    for (const auto& [quadrics, quadrics_name] :
         {named(Quadrics::Memoryless, "Memoryless"), named(Quadrics::Accumulated, "Accumulated")})
      for (const auto& [weight, weight_name] :
           {named(PlaneWeight::Area, "Area"), named(PlaneWeight::Unit, "Unit")})
        for (const auto& [placement, placement_name] :
             {named(Placement::Optimal, "Optimal"), named(Placement::Line, "Line"),
              named(Placement::EndpointOrMidpoint, "EndpointOrMidpoint"),
              named(Placement::HalfEdge, "HalfEdge")}) {
          p.metric = metric, p.quadrics = quadrics, p.plane_weight = weight,
          p.placement = placement;
          variants.push_back(
              {std::string(metric_name) + quadrics_name + weight_name + placement_name, p});
        }
  return variants;
}

}  // namespace curvdecim::test
