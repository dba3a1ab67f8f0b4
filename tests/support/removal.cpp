// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/removal.h"

#include <utility>

#include "support/working_mesh.h"

namespace curvdecim::test {

namespace {

template <class MeshType>
Thinned thinned_as(const Shape& shape, const VertexRemovalParams& params) {
  MeshType mesh;
  fill(mesh, shape);
  DecimationReport report = remove(mesh, params);
  return {shape_of(mesh), std::move(report)};
}

}  // namespace

DecimationReport remove(BareMesh& mesh, const VertexRemovalParams& params,
                        const Progress& progress) {
  return decimate_vertex_removal(mesh, params, progress);
}

DecimationReport remove(FloatMesh& mesh, const VertexRemovalParams& params,
                        const Progress& progress) {
  return decimate_vertex_removal(mesh, params, progress);
}

DecimationReport remove(RichMesh& mesh, const VertexRemovalParams& params,
                        const Progress& progress) {
  return decimate_vertex_removal(mesh, params, progress);
}

Thinned thinned(const Shape& shape, const VertexRemovalParams& params) {
  return thinned_as<BareMesh>(shape, params);
}

Thinned thinned_float(const Shape& shape, const VertexRemovalParams& params) {
  return thinned_as<FloatMesh>(shape, params);
}

VertexRemovalParams removal_to(int faces) {
  VertexRemovalParams params;
  params.target_faces = faces;
  return params;
}

VertexRemovalParams removal_within(double distance) {
  VertexRemovalParams params;
  params.distance_bound = distance;
  return params;
}

std::vector<RemovalVariant> removal_variants() {
  return {{"Heap", RemovalCriterion::Heap, false},
          {"Passes", RemovalCriterion::Passes, false},
          {"HeapWithFeatures", RemovalCriterion::Heap, true},
          {"PassesWithFeatures", RemovalCriterion::Passes, true}};
}

RemovalOn::RemovalOn(const Shape& shape, const VertexRemovalParams& params,
                     RemovalObservers observers)
    : plan(plan_without_target(params, 1.0)),
      mesh(working_mesh(shape)),
      removals(mesh, feature_edges(mesh, plan, Parallel(1)), plan, std::move(observers)),
      scratch(mesh, plan) {}

VertexClass RemovalOn::class_of(int v) { return removals.class_at(v, scratch.fan); }

RemovalAnswer RemovalOn::ask(int v) { return removals.evaluate(v, scratch); }

void RemovalOn::remove(const RemovalAnswer& answer) {
  mesh.connectivity.count(removals.remove(answer, scratch));
  mesh.connectivity.validate();
}

}  // namespace curvdecim::test
