// SPDX-License-Identifier: GPL-3.0-or-later
#include "sanitized/every_function.h"

#include <utility>

#include "support/clustering.h"
#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/errors.h"
#include "support/plans.h"
#include "support/removal.h"
#include "vcg_ext/own_metric.h"
#include "vcg_ext/vertex_removal.h"

namespace curvdecim::test {

namespace {

constexpr double narrow = 30.0;  // degrees: many steps are refused

template <class Params>
Params with(Params params, const CommonParams& common) {
  static_cast<CommonParams&>(params) = common;
  return params;
}

Call collapse(std::string name, EdgeCollapseParams params) {
  params.normal_angle = narrow;
  return {std::move(name),
          [params](RichMesh& mesh, const CommonParams& common, const Progress& progress) {
            return decimate(mesh, with(params, common), progress);
          }};
}

std::vector<Call> collapses() {
  const auto custom = [](Scheduler scheduler) {
    EdgeCollapseParams params;
    params.preset = Preset::Custom, params.scheduler = scheduler;
    return params;
  };
  std::vector<Call> calls;
  EdgeCollapseParams params;
  for (Preset preset : {Preset::Fast, Preset::Balanced, Preset::Best}) {
    params.preset = preset;
    calls.push_back(collapse(labels(preset)[static_cast<int>(preset)], params));
  }
  for (Scheduler scheduler : {Scheduler::Lazy, Scheduler::Eager})
    calls.push_back(collapse(labels(scheduler)[static_cast<int>(scheduler)], custom(scheduler)));
  params = custom(Scheduler::Rounds), params.metric = Metric::Quadric;
  params.quadrics = Quadrics::Accumulated, params.placement = Placement::Line;
  calls.push_back(collapse("Accumulated", params));
  params = {}, params.metric = Metric::CurvatureAdditive;
  calls.push_back(collapse("Additive", params));
  params = {}, params.curvature_of = CurvatureOf::Current;
  calls.push_back(collapse("CurrentCurvature", params));
  params = {}, params.prevent_intersections = true, params.preset = Preset::Best;
  calls.push_back(collapse("PreventIntersections", params));
  params = {}, params.pair_distance = 0.02;
  calls.push_back(collapse("PairDistance", params));
  params = {}, params.max_error = 0.01;
  calls.push_back(collapse("MaxError", params));
  params = {}, params.preserve_topology = params.preserve_boundary = false;
  calls.push_back(collapse("TopologyOff", params));
  params = {}, params.join_borders = false;
  calls.push_back(collapse("BordersApart", params));
  params = {}, params.keep_borders_of = KeepBordersOf::FaceColor;
  calls.push_back(collapse("BordersOfColors", params));
  return calls;
}

Call own_metric() {
  return {
      "OwnMetric", [](RichMesh& mesh, const CommonParams& common, const Progress& progress) {
        const auto params = with(EdgeCollapseParams(), common);
        return decimate_by_metric(
            mesh, params,
            [&](const metric_api::WorkingMesh& working) { return quadric_metric(working, params); },
            progress);
      }};
}

Call sphere(std::string name, SphereEnergy energy, SpherePlacement placement) {
  SphereParams params;
  params.energy = energy, params.placement = placement;
  return {std::move(name),
          [params](RichMesh& mesh, const CommonParams& common, const Progress& progress) {
            return decimate(mesh, with(params, common), progress);
          }};
}

std::vector<Call> spheres() {
  return {sphere("SphereInSpace", SphereEnergy::Poster, SpherePlacement::Free3D),
          sphere("SphereOnEdge", SphereEnergy::Squared, SpherePlacement::OnSphereAlongEdge)};
}

std::vector<Call> removals() {
  std::vector<Call> calls;
  for (const RemovalVariant& variant : removal_variants())
    calls.push_back(
        {variant.name,
         [variant](RichMesh& mesh, const CommonParams& common, const Progress& progress) {
           return remove(mesh, variant.of(with(VertexRemovalParams(), common)), progress);
         }});
  return calls;
}

Call classes() {
  return {"Classes", [](RichMesh& mesh, const CommonParams& common, const Progress&) {
            const auto found = vertex_classes(mesh, with(VertexRemovalParams(), common));
            for (std::size_t v = 0; v < found.size(); ++v)
              mesh.vert[v].Q() = found[v] ? static_cast<double>(*found[v]) : -1.0;
            return DecimationReport();
          }};
}

std::vector<Call> clusterings() {
  std::vector<Call> calls;
  for (const NamedRepresentative& representative : all_representatives())
    calls.push_back({"Cluster" + representative.name,
                     [representative](RichMesh& mesh, const CommonParams& common,
                                      const Progress& progress) -> DecimationReport {
                       ClusteringParams params = with(ClusteringParams(), common);
                       params.manifold_edges = true;
                       return cluster(mesh, representative.of(params), progress);
                     }});
  return calls;
}

std::vector<Call> importances() {
  std::vector<Call> calls;
  for (ImportanceOf output : {ImportanceOf::Curvature, ImportanceOf::Factor})
    for (CurvatureKind kind : {CurvatureKind::Gaussian, CurvatureKind::Absolute}) {
      ImportanceParams params;
      params.output = output, params.curvature_kind = kind;
      const std::string name = std::string(labels(kind)[static_cast<int>(kind)]) +
                               labels(output)[static_cast<int>(output)];
      calls.push_back({name, [params](RichMesh& mesh, const CommonParams&, const Progress&) {
                         importance(mesh, params);
                         return DecimationReport();
                       }});
    }
  return calls;
}

Call error() {
  return {"Error", [](RichMesh& mesh, const CommonParams& common, const Progress& progress) {
            RichMesh other;
            fill(other, scaled(icosphere(3), 0.5));
            ErrorParams params;
            params.save_quality = true, params.sample_num = 20'000;
            params.threads = common.threads;
            DecimationReport report;
            report.stopped_by = error_between(mesh, other, params, progress).stopped_by;
            return report;
          }};
}

}  // namespace

std::vector<Call> every_call() {
  std::vector<Call> all{own_metric(), classes(), error()};
  for (const auto& calls : {collapses(), spheres(), removals(), clusterings(), importances()})
    all.insert(all.end(), calls.begin(), calls.end());
  return all;
}

}  // namespace curvdecim::test
