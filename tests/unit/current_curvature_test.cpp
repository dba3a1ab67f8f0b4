// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "support/mesh_group.h"
#include "support/plans.h"
#include "support/working_mesh.h"
#include "vcg_ext/curvature/current_curvature.h"
#include "vcg_ext/guard/link_condition.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/metric/curvature_weighted_metric.h"

namespace curvdecim::test {

using namespace detail;

namespace {

bool may_collapse(const WorkingMesh& mesh, Edge edge) {
  if (mesh.kind[edge.a] < mesh.kind[edge.b] || !mesh.connectivity.has_edge(edge.a, edge.b))
    return false;
  EdgeNeighborhood around;
  around.gather(mesh.connectivity, edge);
  return satisfies_link_condition(mesh, around);
}

// --- of a vertex ---------------------------------------------------------------------------------

/// Every third edge between a vertex and the next one goes.
void collapse_some(WorkingMesh& mesh, CurrentCurvature& current) {
  for (int v = 0; v + 1 < mesh.connectivity.vertex_slots(); v += 3) {
    const Edge edge{v, v + 1};
    if (!may_collapse(mesh, edge)) continue;
    const Vector3 x = 0.3 * mesh.position[edge.a] + 0.7 * mesh.position[edge.b];
    collapse_edge(
        mesh, edge, x,
        [&](const EdgeNeighborhood& around, const auto&) { current.release(around); },
        [&](const VertexMerge& done, const EdgeNeighborhood& around) {
          current.merge(done.keep, around);
        });
  }
}

void expect_as_computed_anew(const WorkingMesh& mesh, const CurrentCurvature& current) {
  for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v) {
    if (mesh.connectivity.faces_of(v).size() == 0) continue;
    const VertexCurvature expected = vertex_curvature(mesh, v);
    const double largest = std::abs(expected.gaussian) + expected.absolute() + 1.0;
    EXPECT_NEAR(current.at(v).gaussian, expected.gaussian, 1e-10 * largest) << v;
    EXPECT_NEAR(current.at(v).mean, expected.mean, 1e-10 * largest) << v;
    EXPECT_NEAR(current.at(v).area, expected.area, 1e-14) << v;
  }
}

class CurrentCurvatureOn : public testing::TestWithParam<NamedShape> {};

TEST_P(CurrentCurvatureOn, IsThatOfTheVertexAtFirst) {
  const WorkingMesh mesh = working_mesh(GetParam().shape);
  CurrentCurvature current(mesh);
  current.initialize(Parallel(2));
  expect_as_computed_anew(mesh, current);
}

TEST_P(CurrentCurvatureOn, IsAsComputedAnewAfterSomeCollapses) {
  WorkingMesh mesh = working_mesh(GetParam().shape);
  const int before = mesh.connectivity.vertex_count();
  CurrentCurvature current(mesh);
  current.initialize(Parallel(1));
  collapse_some(mesh, current);
  ASSERT_LT(mesh.connectivity.vertex_count(), before);
  expect_as_computed_anew(mesh, current);
}

INSTANTIATE_TEST_SUITE_P(Drawn, CurrentCurvatureOn,
                         testing::Values(NamedShape{"noisy_sphere", noisy_sphere(2, 0.02)},
                                         NamedShape{"torus", torus(24, 12)},
                                         NamedShape{"saddle", saddle(12)},
                                         NamedShape{"open_cylinder", open_cylinder(24, 8)},
                                         NamedShape{"three_pages", book(3, 8)}),
                         name_of);

// --- in the metric -------------------------------------------------------------------------------

constexpr double alpha = 0.5;

EdgeCollapseParams params_with(CurvatureOf of) {
  EdgeCollapseParams params;
  params.alpha_units = AlphaUnits::ModelUnits, params.alpha = alpha;
  params.quadrics = Quadrics::Accumulated, params.curvature_of = of;
  return params;
}

/// The factors on the cost of all edges of a saddle around the vertex next to which one of them
/// collapsed; expected: by the saturation of each vertex.
template <class Saturation>
void expect_factors_after_a_collapse(CurvatureOf of, Saturation saturation) {
  const EdgeCollapseParams params = params_with(of);
  WorkingMesh mesh = working_mesh(saddle(6));
  CurvatureWeightedMetric weighted = weighted_metric(mesh, params);
  QuadricMetric plain = quadric_metric(mesh, params);
  weighted.initialize(Parallel(1)), plain.initialize(Parallel(1));
  const Vector3 x = mesh.position[25] + Vector3(0, 0, 0.05);
  collapse_edge(
      mesh, {24, 25}, x,
      [&](const EdgeNeighborhood& around, const std::vector<FacePlane>& after) {
        weighted.release(around, after), plain.release(around, after);
      },
      [&](const VertexMerge& done, const EdgeNeighborhood& around) {
        weighted.merge(done, around), plain.merge(done, around);
      });
  for (int v : {17, 23, 24, 31, 33})
    for (int u = v + 1; u < mesh.connectivity.vertex_slots(); ++u) {
      if (!mesh.connectivity.has_edge(v, u)) continue;
      const double cost = plain.evaluate({v, u}, Allowed::OntoA, Vector3::Zero())->cost;
      const double sv = saturation(mesh, v), su = saturation(mesh, u);
      EXPECT_NEAR(weighted.evaluate({v, u}, Allowed::OntoA, Vector3::Zero())->cost,
                  cost * (1.0 - (1.0 - sv) * (1.0 - su)), 1e-6 * cost)  // saturations are floats
          << v << '-' << u;
    }
}

TEST(CurvatureOfCurrent, IsThatOfTheMeshAfterTheCollapse) {
  expect_factors_after_a_collapse(CurvatureOf::Current, [](const WorkingMesh& mesh, int v) {
    return -std::expm1(-alpha * vertex_curvature(mesh, v).absolute());
  });
}

TEST(CurvatureOfInput, StaysAndIsAveragedByAreaWhereVerticesMerge) {
  const WorkingMesh input = working_mesh(saddle(6));
  const CurvatureField field = curvature_field(input, params_with(CurvatureOf::Input), Parallel(1));
  const auto of_input = [&](int v) { return -std::expm1(-alpha * field.value[v]); };
  const double area = field.area[24] + field.area[25];
  const double merged = (field.area[24] * of_input(24) + field.area[25] * of_input(25)) / area;
  expect_factors_after_a_collapse(CurvatureOf::Input, [&](const WorkingMesh&, int v) {
    return v == 24 ? merged : of_input(v);
  });
}

}  // namespace
}  // namespace curvdecim::test
