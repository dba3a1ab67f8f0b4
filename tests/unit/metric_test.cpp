// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/drawn_meshes.h"
#include "support/plans.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

EdgeCollapseParams custom(Quadrics quadrics = Quadrics::Accumulated,
                          Placement placement = Placement::HalfEdge) {
  EdgeCollapseParams params;
  params.preset = Preset::Custom;
  params.quadrics = quadrics;
  params.placement = placement;
  return params;
}

template <class MetricType>
Candidate evaluated(MetricType metric, Edge edge, Allowed allowed = Allowed::Anywhere,
                    const Vector3& wings = Vector3::Zero()) {
  metric.initialize(Parallel(1));
  return *metric.evaluate(edge, allowed, wings);
}

/// A ridge: two planes that meet in the y axis under 90 degrees, as a 2 x 4 lattice.
Shape ridge() {
  return mapped(plane_grid(4),
                [](const Point& p) { return Point(p.x(), p.y(), -std::abs(p.x() - 0.5)); });
}

/// Planes of the faces around v, about v.
Symmetric3 planes_around(const WorkingMesh& mesh, int v, PlaneWeight weight) {
  Symmetric3 sum;
  for (int f : mesh.connectivity.faces_of(v)) sum += plane_matrix(mesh.plane[f], weight);
  return sum;
}

// --- planes --------------------------------------------------------------------------------------

TEST(PlaneQuadrics, AreWeightedByAreaOrNot) {
  const WorkingMesh mesh = working_mesh(two_triangles());
  EXPECT_EQ(planes_around(mesh, 0, PlaneWeight::Area).zz, 1.0);
  EXPECT_EQ(planes_around(mesh, 0, PlaneWeight::Unit).zz, 2.0);
  EXPECT_EQ(planes_around(mesh, 0, PlaneWeight::Area).xx, 0.0);
}

// --- boundary and features -----------------------------------------------------------------------

std::vector<Symmetric3> constraints(const Shape& shape, const DecimationParams& params) {
  const WorkingMesh mesh = working_mesh(shape);
  std::vector<Symmetric3> sums(mesh.position.size());
  ConstraintQuadrics(mesh, quadric_plan(params, QuadricParams(), true))
      .build(Parallel(1), [&](int v, const Symmetric3& plane) { sums[v] += plane; });
  return sums;
}

bool has_constraints(const Shape& shape, const DecimationParams& params) {
  const std::vector<Symmetric3> all = constraints(shape, params);
  return std::any_of(all.begin(), all.end(), [](const Symmetric3& m) { return m.trace() > 0.0; });
}

/// What it costs by the constraints to move vertex v by `step`.
double cost_of_step(const Shape& shape, const DecimationParams& params, int v,
                    const Vector3& step) {
  return step.dot(constraints(shape, params)[v] * step);
}

TEST(ConstraintQuadrics, HoldTheBoundaryAcrossAndNotAlong) {
  const int middle_of_the_side_x0 = 2, inside = 12;
  EXPECT_GT(cost_of_step(plane_grid(4), {}, middle_of_the_side_x0, {0.1, 0, 0}), 0.0);
  EXPECT_EQ(cost_of_step(plane_grid(4), {}, middle_of_the_side_x0, {0, 0.1, 0}), 0.0);
  EXPECT_EQ(cost_of_step(plane_grid(4), {}, inside, {0.1, 0.1, 0.1}), 0.0);
}

TEST(ConstraintQuadrics, GrowInProportionToTheWeight) {
  DecimationParams params;
  const double once = cost_of_step(plane_grid(4), params, 2, {1, 0, 0});
  params.boundary_weight = 3.0;
  EXPECT_NEAR(cost_of_step(plane_grid(4), params, 2, {1, 0, 0}), 3.0 * once, 1e-15);
}

TEST(ConstraintQuadrics, AreNoneOnASmoothClosedMeshOrWithoutWeight) {
  EXPECT_FALSE(has_constraints(icosphere(2), {}));
  DecimationParams params;
  params.boundary_weight = 0.0;
  EXPECT_FALSE(has_constraints(plane_grid(4), params));
}

TEST(ConstraintQuadrics, HoldFeaturesFromTheirAngleOn) {
  DecimationParams params;
  params.feature_angle = 80.0;
  EXPECT_GT(cost_of_step(ridge(), params, 12, {0.1, 0, 0}), 0.0);
  params.feature_angle = 100.0;
  EXPECT_EQ(cost_of_step(ridge(), params, 12, {0.1, 0, 0}), 0.0);
  params.feature_angle = 180.0;
  EXPECT_FALSE(has_constraints(cube(), params));
}

// --- quadric -------------------------------------------------------------------------------------

class QuadricMetricWith : public testing::TestWithParam<Quadrics> {};

TEST_P(QuadricMetricWith, CostsNothingInAPlane) {
  const WorkingMesh mesh = working_mesh(plane_grid(4));
  for (Placement placement :
       {Placement::Optimal, Placement::Line, Placement::EndpointOrMidpoint, Placement::HalfEdge})
    EXPECT_NEAR(evaluated(quadric_metric(mesh, custom(GetParam(), placement)), {12, 17}).cost, 0.0,
                1e-30);
}

TEST_P(QuadricMetricWith, CostsNothingAlongARidgeAndSomethingAcross) {
  const WorkingMesh mesh = working_mesh(ridge());
  const EdgeCollapseParams params = custom(GetParam());
  EXPECT_NEAR(evaluated(quadric_metric(mesh, params), {11, 12}).cost, 0.0, 1e-30);
  EXPECT_GT(evaluated(quadric_metric(mesh, params), {7, 12}, Allowed::OntoA).cost, 1e-4);
}

TEST_P(QuadricMetricWith, KeepsAnEndToTheBit) {
  const WorkingMesh mesh = working_mesh(rotated(ridge(), 1.0, {1, 2, 3}));
  const EdgeCollapseParams params = custom(GetParam());
  const QuadricMetric metric = quadric_metric(mesh, params);
  EXPECT_EQ(evaluated(metric, {7, 12}, Allowed::OntoA).position, mesh.position[7]);
  EXPECT_EQ(evaluated(metric, {7, 12}, Allowed::OntoA).t, 0.0);
  EXPECT_EQ(evaluated(metric, {7, 12}, Allowed::OntoB).position, mesh.position[12]);
  EXPECT_EQ(evaluated(metric, {7, 12}, Allowed::OntoB).t, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Both, QuadricMetricWith,
                         testing::Values(Quadrics::Memoryless, Quadrics::Accumulated));

TEST(QuadricMetric, AccumulatedIsTheSumOfSquaredDistancesToThePlanes) {
  const WorkingMesh mesh = working_mesh(cube());
  EdgeCollapseParams params = custom();
  params.feature_angle = 180.0, params.plane_weight = PlaneWeight::Unit;
  double expected = 0.0;
  const int a = mesh.connectivity.face(0)[0], b = mesh.connectivity.face(0)[1];
  for (int v : {a, b})
    for (int f : mesh.connectivity.faces_of(v)) {
      const double d = mesh.plane[f].normal.dot(mesh.position[b] - mesh.position[v]);
      expected += d * d;
    }
  EXPECT_NEAR(evaluated(quadric_metric(mesh, params), {std::min(a, b), std::max(a, b)},
                        a < b ? Allowed::OntoB : Allowed::OntoA)
                  .cost,
              expected, 1e-12);
}

// --- curvature weighted --------------------------------------------------------------------------

double weighted_cost(const WorkingMesh& mesh, EdgeCollapseParams params, Edge edge) {
  return evaluated(weighted_metric(mesh, params), edge, Allowed::OntoA).cost;
}

TEST(CurvatureWeightedMetric, IsTheQuadricTimesTheFactorOfBothEnds) {
  const WorkingMesh mesh = working_mesh(saddle(6));
  EdgeCollapseParams params = custom();
  params.alpha_units = AlphaUnits::ModelUnits, params.curvature_kind = CurvatureKind::Gaussian,
  params.alpha = 0.1, params.curvature_of = CurvatureOf::Current;
  const double k =
      std::abs(vertex_curvature(mesh, 24).gaussian) + std::abs(vertex_curvature(mesh, 25).gaussian);
  const double plain = evaluated(quadric_metric(mesh, params), {24, 25}, Allowed::OntoA).cost;
  EXPECT_NEAR(weighted_cost(mesh, params, {24, 25}), plain * (1.0 - std::exp(-0.1 * k)),
              1e-6 * plain);  // saturations are floats
}

TEST(CurvatureWeightedMetric, WithInfiniteAlphaIsTheQuadric) {
  const WorkingMesh mesh = working_mesh(saddle(6));
  EdgeCollapseParams params = custom();
  for (double alpha : {0.0, -1.0}) {
    params.alpha = alpha;
    EXPECT_EQ(weighted_cost(mesh, params, {24, 25}),
              evaluated(quadric_metric(mesh, params), {24, 25}, Allowed::OntoA).cost);
  }
}

// --- after a collapse ----------------------------------------------------------------------------

/// Collapses b of an edge into a, which goes to x, and lets the metrics follow.
template <class... Metrics>
void collapse(WorkingMesh& mesh, Edge edge, const Vector3& x, Metrics&... metrics) {
  collapse_edge(
      mesh, edge, x,
      [&](const EdgeNeighborhood& around, const std::vector<FacePlane>& after) {
        (metrics.release(around, after), ...);
      },
      [&](const VertexMerge& done, const EdgeNeighborhood& around) {
        (metrics.merge(done, around), ...);
      });
}

/// All edges of the mesh as it is.
std::vector<Edge> edges_of(const WorkingMesh& mesh) {
  std::vector<Edge> edges;
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f)
    for (int i = 0; i < 3 && mesh.connectivity.alive(f); ++i) {
      const Face& face = mesh.connectivity.face(f);
      if (const int a = face[i], b = face[(i + 1) % 3]; a < b) edges.push_back({a, b});
    }
  return edges;
}

TEST(CurvatureWeightedMetric, SeesTheCurvatureOfTheCurrentMesh) {
  WorkingMesh mesh = working_mesh(torus(12, 8));
  EdgeCollapseParams params = custom(Quadrics::Memoryless);
  params.alpha_units = AlphaUnits::ModelUnits, params.alpha = 0.1, params.feature_angle = 180.0;
  params.curvature_of = CurvatureOf::Current;
  CurvatureWeightedMetric weighted = weighted_metric(mesh, params);
  QuadricMetric plain = quadric_metric(mesh, params);
  weighted.initialize(Parallel(1)), plain.initialize(Parallel(1));
  const auto absolute = [&](int v) { return vertex_curvature(mesh, v).absolute(); };
  for (Edge edge : {Edge{16, 24}, Edge{16, 17}, Edge{40, 41}})
    collapse(mesh, edge, mesh.position[edge.b] + Vector3(0.01, 0.02, 0.05), weighted, plain);
  for (Edge edge : edges_of(mesh)) {
    const double expected = plain.evaluate(edge, Allowed::OntoA, wings_of(mesh, edge))->cost *
                            -std::expm1(-0.1 * (absolute(edge.a) + absolute(edge.b)));
    EXPECT_NEAR(weighted.evaluate(edge, Allowed::OntoA, wings_of(mesh, edge))->cost, expected,
                1e-6 * expected);
  }
}

TEST(QuadricMetric, MemorylessIsOfTheCurrentMeshAndATenthOfTheInput) {
  const WorkingMesh input = working_mesh(torus(12, 8));
  WorkingMesh mesh = input;
  EdgeCollapseParams params = custom(Quadrics::Memoryless);
  params.feature_angle = 180.0;
  QuadricMetric metric = quadric_metric(mesh, params);
  metric.initialize(Parallel(1));
  for (Edge edge : {Edge{16, 24}, Edge{16, 17}})
    collapse(mesh, edge, mesh.position[edge.b] + Vector3(0.01, 0.02, 0.05), metric);
  for (Edge edge : edges_of(mesh)) {
    if (edge.b == 16 || edge.a == 16) continue;  // it also carries what was merged into it
    const Vector3 step = mesh.position[edge.a] - mesh.position[edge.b];
    const Symmetric3 planes = planes_around(mesh, edge.b, PlaneWeight::Area) +
                              planes_around(input, edge.b, PlaneWeight::Area) * 0.1;
    EXPECT_NEAR(metric.evaluate(edge, Allowed::OntoA, wings_of(mesh, edge))->cost,
                step.dot(planes * step), 1e-7);
  }
}

TEST(QuadricMetric, MemorylessFollowsTheBorder) {
  WorkingMesh mesh = working_mesh(saddle(6));
  const EdgeCollapseParams params = custom(Quadrics::Memoryless);
  QuadricMetric metric = quadric_metric(mesh, params), of_input = metric;
  metric.initialize(Parallel(1)), of_input.initialize(Parallel(1));
  for (Edge edge : {Edge{2, 3}, Edge{8, 9}, Edge{7, 14}})
    collapse(mesh, edge, mesh.position[edge.b] + Vector3(0.01, 0.02, 0.05), metric);
  const WorkingMesh now = working_mesh(shape_of(mesh));
  QuadricMetric of_now = quadric_metric(now, params);
  of_now.initialize(Parallel(1));
  for (int v : {0, 1, 4, 10, 15, 16, 21})  // none was merged
    EXPECT_NEAR(1.1 * metric.weight(v), of_now.weight(v) + 0.1 * of_input.weight(v), 1e-12) << v;
}

/// Squared distances to the planes of the faces around v, by area.
double area_times_distance2(const WorkingMesh& mesh, int v, const Vector3& x) {
  double sum = 0.0;
  for (int f : mesh.connectivity.faces_of(v)) {
    const double distance = mesh.plane[f].normal.dot(x - mesh.position[v]);
    sum += mesh.plane[f].area * distance * distance;
  }
  return sum;
}

TEST(QuadricMetric, MemorylessCountsTheFacesAroundAMergedPairAnew) {
  const WorkingMesh input = working_mesh(torus(12, 8));
  WorkingMesh mesh = input;
  EdgeCollapseParams params = custom(Quadrics::Memoryless);
  params.feature_angle = 180.0;
  QuadricMetric metric = quadric_metric(mesh, params, false);
  metric.initialize(Parallel(1));
  const Edge pair{16, 50};
  ASSERT_FALSE(mesh.connectivity.has_edge(pair.a, pair.b));
  collapse(mesh, pair, 0.5 * (mesh.position[16] + mesh.position[50]), metric);
  ASSERT_EQ(mesh.connectivity.faces_of(16).size(), 12);
  for (Edge edge : edges_of(mesh)) {
    if (edge.a != 16 && edge.b != 16) continue;
    const int other = edge.a == 16 ? edge.b : edge.a;
    const Vector3& x = mesh.position[other];
    const double expected =
        area_times_distance2(mesh, 16, x) +
        0.1 * (area_times_distance2(input, 16, x) + area_times_distance2(input, 50, x));
    EXPECT_NEAR(metric.evaluate({other, 16}, Allowed::OntoA, wings_of(mesh, edge))->cost, expected,
                1e-6 * expected);
  }
}

/// Roots of the factors on both planes and cost: by vertex, after the collapses into `keep`.
std::vector<double> roots_of_factors(const WorkingMesh& input, const EdgeCollapseParams& params,
                                     int keep, const std::vector<int>& gone) {
  CurvatureField field = curvature_field(input, params, Parallel(1));
  const CurvatureWeight weight = curvature_weight(params, field, 1.0);
  for (double& value : field.value) value = weight.saturation(value);
  for (int v : gone) {
    const double area = field.area[keep] + field.area[v];
    field.value[keep] =
        (field.area[keep] * field.value[keep] + field.area[v] * field.value[v]) / area;
    field.area[keep] = area;
  }
  for (double& value : field.value) value = std::sqrt(weight.factor(value));
  return field.value;
}

Symmetric3 weighted_planes(const WorkingMesh& mesh, int v, const std::vector<double>& root) {
  Symmetric3 sum;
  for (int f : mesh.connectivity.faces_of(v)) {
    double corners = 0.0;
    for (int u : mesh.connectivity.face(f)) corners += root[u];
    sum += plane_matrix(mesh.plane[f], PlaneWeight::Area) * (corners / 3.0);
  }
  return sum;
}

TEST(CurvatureWeightedMetric, ScaleFreeGivesARootOfTheFactorToThePlanesAndOneToTheCost) {
  const WorkingMesh input = working_mesh(torus(12, 8));
  WorkingMesh mesh = input;
  EdgeCollapseParams params = custom(Quadrics::Memoryless);
  params.feature_angle = 180.0, params.curvature_floor = 0.1;
  CurvatureWeightedMetric metric = weighted_metric(mesh, params);
  metric.initialize(Parallel(1));
  for (Edge edge : {Edge{16, 24}, Edge{16, 17}})
    collapse(mesh, edge, mesh.position[edge.b] + Vector3(0.01, 0.02, 0.05), metric);
  const std::vector<double> before = roots_of_factors(input, params, 16, {});
  const std::vector<double> now = roots_of_factors(input, params, 16, {24, 17});
  ASSERT_GT(std::abs(now[16] - before[16]), 1e-3);  // else nothing is seen of the merge
  for (Edge edge : edges_of(mesh)) {
    if (edge.b == 16 || edge.a == 16) continue;  // it also carries what was merged into it
    const Vector3 step = mesh.position[edge.a] - mesh.position[edge.b];
    const Symmetric3 planes =
        weighted_planes(mesh, edge.b, now) + weighted_planes(input, edge.b, before) * 0.1;
    EXPECT_NEAR(metric.evaluate(edge, Allowed::OntoA, wings_of(mesh, edge))->cost,
                0.5 * (now[edge.a] + now[edge.b]) * step.dot(planes * step), 1e-7);
  }
}

// --- curvature additive --------------------------------------------------------------------------

double additive_term(const Shape& shape, CurvatureTerm term, Edge edge,
                     PlaneWeight weight = PlaneWeight::Unit) {
  const WorkingMesh mesh = working_mesh(shape);
  EdgeCollapseParams params = custom();
  params.curvature_term = term, params.lambda = 2.0, params.plane_weight = weight;
  const double with = evaluated(additive_metric(mesh, params), edge).cost;
  return (with - evaluated(quadric_metric(mesh, params), edge).cost) / params.lambda;
}

TEST(CurvatureAdditiveMetric, AddsNothingInAPlaneAsMelax) {
  EXPECT_NEAR(additive_term(plane_grid(4), CurvatureTerm::Melax, {12, 17}), 0.0, 1e-15);
}

TEST(CurvatureAdditiveMetric, AddsTheLengthInAPlaneAsPrinted) {
  EXPECT_NEAR(additive_term(plane_grid(4), CurvatureTerm::Literal, {12, 17}), 0.25, 1e-15);
}

TEST(CurvatureAdditiveMetric, GoesWithTheAreaOfTheFacesWhereThePlanesDo) {
  constexpr double area_of_a_face = 0.5 / 16;
  EXPECT_NEAR(additive_term(plane_grid(4), CurvatureTerm::Literal, {12, 17}, PlaneWeight::Area),
              0.25 * area_of_a_face, 1e-15);
}

TEST(CurvatureAdditiveMetric, AddsTheTurnAcrossARidgeTimesTheLength) {
  // Across: all edge faces lie on one side, the other side's are at 90 degrees: (1 - 0) / 2.
  EXPECT_NEAR(additive_term(ridge(), CurvatureTerm::Melax, {7, 12}), 0.5 * std::sqrt(2.0) * 0.25,
              1e-12);
  // Along: each side has an edge face of its own.
  EXPECT_NEAR(additive_term(ridge(), CurvatureTerm::Melax, {11, 12}), 0.0, 1e-12);
}

TEST(CurvatureAdditiveMetric, AddsTheLengthForAPair) {
  for (CurvatureTerm term : {CurvatureTerm::Melax, CurvatureTerm::Literal})
    EXPECT_NEAR(additive_term(plane_grid(4), term, {11, 13}), 0.5, 1e-15);
}

// --- estimates -----------------------------------------------------------------------------------

/// The estimate of an edge over the cost that evaluate gives, over all edges between inner
/// vertices.
template <class MetricType>
std::vector<double> estimates_over_costs(const WorkingMesh& mesh, MetricType metric) {
  metric.initialize(Parallel(1));
  std::vector<double> ratios, costs;
  for (Edge edge : edges_of(mesh)) {
    if (mesh.kind[edge.a] != VertexKind::Interior || mesh.kind[edge.b] != VertexKind::Interior)
      continue;
    metric.estimate(edge.a, {edge.b, edge.b, edge.b}, costs);
    EXPECT_EQ(costs, std::vector<double>(3, costs[0])) << "in each place of a pair";
    const double cost = metric.evaluate(edge, Allowed::Anywhere, wings_of(mesh, edge))->cost;
    EXPECT_EQ(costs[0] == 0.0, cost == 0.0);
    if (cost > 0.0) ratios.push_back(costs[0] / cost);
  }
  return ratios;
}

TEST(Estimate, IsTheCostWhereTheVolumePlaysNoPart) {
  for (Placement placement : {Placement::Optimal, Placement::Line, Placement::HalfEdge})
    for (const Shape& shape : {torus(12, 8), saddle(6), cube()}) {
      const WorkingMesh mesh = working_mesh(shape);
      const EdgeCollapseParams params = custom(Quadrics::Accumulated, placement);
      for (double r : estimates_over_costs(mesh, quadric_metric(mesh, params)))
        EXPECT_NEAR(r, 1.0, 1e-9);
      for (double r : estimates_over_costs(mesh, weighted_metric(mesh, params)))
        EXPECT_NEAR(r, 1.0, 1e-9);
      for (double r : estimates_over_costs(mesh, additive_metric(mesh, params)))
        EXPECT_NEAR(r, 1.0, 1e-9);
    }
}

TEST(Estimate, IsNotAboveTheCostWhereTheVolumeIsKept) {
  const WorkingMesh mesh = working_mesh(noisy_sphere(2, 0.02));
  double least = 1.0;
  for (double r : estimates_over_costs(
           mesh, quadric_metric(mesh, custom(Quadrics::Memoryless, Placement::Optimal)))) {
    EXPECT_LE(r, 1.0 + 1e-9);
    least = std::min(least, r);
  }
  EXPECT_LT(least, 1.0) << "the volume moves some";
}

// --- dispatch ------------------------------------------------------------------------------------

TEST(Preset, SetsWhatItNamesAndLeavesTheMetric) {
  EdgeCollapseParams params = custom(Quadrics::Accumulated, Placement::HalfEdge);
  params.plane_weight = PlaneWeight::Unit;
  params.metric = Metric::CurvatureAdditive;
  EXPECT_EQ(with_preset(params).placement, Placement::HalfEdge);
  params.preset = Preset::Balanced;
  EXPECT_EQ(with_preset(params).quadrics, Quadrics::Memoryless);
  EXPECT_EQ(with_preset(params).placement, Placement::Optimal);
  EXPECT_EQ(with_preset(params).plane_weight, PlaneWeight::Area);
  EXPECT_EQ(with_preset(params).scheduler, Scheduler::Rounds);
  EXPECT_EQ(with_preset(params).metric, Metric::CurvatureAdditive);
  params.preset = Preset::Fast;
  EXPECT_EQ(with_preset(params).quadrics, Quadrics::Memoryless);
  EXPECT_EQ(with_preset(params).scheduler, Scheduler::FewRounds);
  params.preset = Preset::Best;
  EXPECT_EQ(with_preset(params).quadrics, Quadrics::Memoryless);
  EXPECT_EQ(with_preset(params).scheduler, Scheduler::Rounds);
  EXPECT_GT(with_preset(params).refine_sweeps, 0);
}

}  // namespace
}  // namespace curvdecim::test
