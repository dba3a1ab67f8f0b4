// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/decimation.h"

#include "vcg_ext/algebraic_sphere.h"
#include "vcg_ext/curvature_importance.h"
#include "vcg_ext/edge_collapse.h"

namespace curvdecim::test {

namespace {

template <class MeshType>
DecimationReport run(MeshType& mesh, const EdgeCollapseParams& params, const Progress& progress) {
  return decimate_edge_collapse(mesh, params, progress);
}

template <class MeshType>
DecimationReport run(MeshType& mesh, const SphereParams& params, const Progress& progress) {
  return decimate_algebraic_sphere(mesh, params, progress);
}

template <class MeshType, class Params>
Decimated decimated_as(const Shape& shape, const Params& params) {
  MeshType mesh;
  fill(mesh, shape);
  DecimationReport report = run(mesh, params, {});
  return {shape_of(mesh), std::move(report)};
}

template <class Value>
std::pair<Value, const char*> named(Value value, const char* name) {
  return {value, name};
}

}  // namespace

DecimationReport decimate(BareMesh& mesh, const EdgeCollapseParams& params,
                          const Progress& progress) {
  return run(mesh, params, progress);
}

DecimationReport decimate(FloatMesh& mesh, const EdgeCollapseParams& params,
                          const Progress& progress) {
  return run(mesh, params, progress);
}

DecimationReport decimate(SkinnedMesh& mesh, const EdgeCollapseParams& params,
                          const Progress& progress) {
  return run(mesh, params, progress);
}

DecimationReport decimate(RichMesh& mesh, const EdgeCollapseParams& params,
                          const Progress& progress) {
  return run(mesh, params, progress);
}

DecimationReport decimate(RichMesh& mesh, const SphereParams& params, const Progress& progress) {
  return run(mesh, params, progress);
}

void importance(RichMesh& mesh, const ImportanceParams& params) {
  curvature_importance(mesh, params);
}

Decimated decimated(const Shape& shape, const EdgeCollapseParams& params) {
  return decimated_as<BareMesh>(shape, params);
}

Decimated decimated(const Shape& shape, const AnyParams& params) {
  return std::visit([&](const auto& p) { return decimated_as<BareMesh>(shape, p); }, params);
}

Decimated decimated_float(const Shape& shape, const EdgeCollapseParams& params) {
  return decimated_as<FloatMesh>(shape, params);
}

Decimated decimated_float(const Shape& shape, const AnyParams& params) {
  return std::visit([&](const auto& p) { return decimated_as<FloatMesh>(shape, p); }, params);
}

DecimationParams& shared(AnyParams& params) {
  return std::visit([](auto& p) -> DecimationParams& { return p; }, params);
}

EdgeCollapseParams to_faces(int faces) {
  EdgeCollapseParams params;
  params.target_faces = faces;
  return params;
}

SphereParams spheres_to_faces(int faces) {
  SphereParams params;
  params.target_faces = faces;
  return params;
}

AnyParams Variant::with_target(int faces) const {
  AnyParams result = params;
  shared(result).target_faces = faces;
  return result;
}

AnyParams Variant::with_max_error(double length) const {
  AnyParams result = params;
  shared(result).max_error = length;
  return result;
}

std::vector<Variant> quadric_variants() {
  std::vector<Variant> variants;
  EdgeCollapseParams p;
  p.preset = Preset::Custom;
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

std::vector<Variant> sphere_variants() {
  std::vector<Variant> variants;
  SphereParams p;
  for (const auto& [energy, energy_name] :
       {named(SphereEnergy::Squared, "Squared"), named(SphereEnergy::Poster, "Poster")})
    for (const auto& [placement, placement_name] :
         {named(SpherePlacement::Free3D, "Free3D"),
          named(SpherePlacement::OnSphereAlongEdge, "OnSphereAlongEdge")}) {
      p.energy = energy, p.placement = placement;
      variants.push_back({std::string("Sphere") + energy_name + placement_name, p});
    }
  return variants;
}

std::vector<Variant> all_variants() {
  std::vector<Variant> variants = quadric_variants();
  for (Variant& variant : sphere_variants()) variants.push_back(std::move(variant));
  return variants;
}

}  // namespace curvdecim::test
