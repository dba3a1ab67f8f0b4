// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/drawn_meshes.h"
#include "support/plans.h"
#include "support/working_mesh.h"
#include "vcg_ext/mesh/vertex_ring.h"
#include "vcg_ext/metric/anchored_sphere_metric.h"
#include "vcg_ext/metric/interpolated_sphere_metric.h"

namespace curvdecim::test {

using namespace detail;

namespace {

SphereParams with(SphereEnergy energy, SpherePlacement placement) {
  SphereParams params;
  params.energy = energy, params.placement = placement;
  return params;
}

SpherePlan plan_of(const SphereParams& params) {
  return {quadric_plan(params, QuadricParams(), true), params, params.energy};
}

/// Evaluates one edge of a mesh by a new metric.
template <class MetricType>
Candidate evaluated(const WorkingMesh& mesh, const SphereParams& params, Edge edge,
                    Allowed allowed = Allowed::Anywhere) {
  MetricType metric(mesh, plan_of(params));
  metric.initialize(Parallel(1));
  return metric.evaluate(edge, allowed, wings_of(mesh, edge)).value();
}

Edge first_edge_of(const WorkingMesh& mesh, int v) {
  const int u = mesh.connectivity.next_vertex(*mesh.connectivity.faces_of(v).begin(), v);
  return {std::min(u, v), std::max(u, v)};
}

class Energies : public testing::TestWithParam<SphereEnergy> {};

TEST_P(Energies, AnchoredCostsNothingInAPlane) {
  const WorkingMesh mesh = working_mesh(rotated(plane_grid(6), 0.8, {1, 2, 3}));
  const SphereParams params = with(GetParam(), SpherePlacement::Free3D);
  EXPECT_EQ(evaluated<AnchoredSphereMetric>(mesh, params, first_edge_of(mesh, 24)).cost, 0.0);
}

TEST_P(Energies, InterpolatedCostsNothingInAPlaneAndGoesToTheMiddle) {
  const WorkingMesh mesh = working_mesh(rotated(plane_grid(6), 0.8, {1, 2, 3}));
  const SphereParams params = with(GetParam(), SpherePlacement::OnSphereAlongEdge);
  const Candidate c = evaluated<InterpolatedSphereMetric>(mesh, params, first_edge_of(mesh, 24));
  EXPECT_EQ(c.cost, 0.0);
  EXPECT_EQ(c.t, 0.5);
}

TEST_P(Energies, InterpolatedStaysOnASphere) {
  const WorkingMesh mesh = working_mesh(icosphere(4));
  const SphereParams params = with(GetParam(), SpherePlacement::OnSphereAlongEdge);
  for (int v : {3, 100, 1000}) {
    const Candidate c = evaluated<InterpolatedSphereMetric>(mesh, params, first_edge_of(mesh, v));
    EXPECT_NEAR(c.position.norm(), 1.0, 1e-4);
    EXPECT_GT(c.cost, 0.0);
  }
}

/// On a bumpy surface no sample of the parameter is better than what the search found.
TEST_P(Energies, InterpolatedFindsTheLeastAlongTheEdge) {
  const WorkingMesh mesh = working_mesh(bumpy_sphere(3));
  const SphereParams params = with(GetParam(), SpherePlacement::OnSphereAlongEdge);
  const std::vector<AlgebraicSphere> spheres =
      VertexSpheres(mesh, params, params.feature_angle, Parallel(1)).fit();
  for (int v : {5, 77, 300, 500}) {
    const Edge edge = first_edge_of(mesh, v);
    const Candidate found = evaluated<InterpolatedSphereMetric>(mesh, params, edge);
    const Vector3 &a = mesh.position[edge.a], &b = mesh.position[edge.b];
    for (int i = 0; i <= 40; ++i) {
      const double t = i / 40.0;
      const Vector3 x = a + t * (b - a);
      const AlgebraicSphere s = interpolated(spheres[edge.a].with_origin_moved(x - a),
                                             spheres[edge.b].with_origin_moved(x - b), t)
                                    .normalised();
      const Vector3 offset = s.project(Vector3::Zero());
      RingEnergy energy;
      for_faces_after(mesh, edge, x + offset, [&](const Triangle& face, int, int) {
        energy.add(s.with_origin_moved(offset), face);
      });
      ASSERT_LE(found.cost, 1.01 * energy.of(GetParam())) << "edge of " << v << " at " << t;
    }
  }
}

TEST_P(Energies, AnEndThatMustStayStaysToTheBit) {
  const WorkingMesh mesh = working_mesh(noisy_sphere(3, 0.02));
  const Edge edge = first_edge_of(mesh, 100);
  for (const auto& [allowed, end, t] :
       {std::tuple(Allowed::OntoA, edge.a, 0.0), std::tuple(Allowed::OntoB, edge.b, 1.0)}) {
    const Candidate free = evaluated<AnchoredSphereMetric>(
        mesh, with(GetParam(), SpherePlacement::Free3D), edge, allowed);
    const Candidate along = evaluated<InterpolatedSphereMetric>(
        mesh, with(GetParam(), SpherePlacement::OnSphereAlongEdge), edge, allowed);
    for (const Candidate& c : {free, along}) {
      EXPECT_EQ(c.position, mesh.position[end]);
      EXPECT_EQ(c.t, t);
      EXPECT_GT(c.cost, 0.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Both, Energies,
                         testing::Values(SphereEnergy::Squared, SphereEnergy::Poster));

/// The faces of a sphere lie inside it: the sphere draws the vertex out, the planes alone do not
/// know where it is.
TEST(AnchoredSphereMetric, MovesTheVertexToWhereFacesAndSphereAreNear) {
  const WorkingMesh mesh = working_mesh(icosphere(4));
  const SphereParams params = with(SphereEnergy::Squared, SpherePlacement::Free3D);
  const Edge edge = first_edge_of(mesh, 1000);
  const Candidate c = evaluated<AnchoredSphereMetric>(mesh, params, edge);
  const auto energy_at = [&](double radius) {
    const Vector3 x = radius * c.position.normalized();
    const AlgebraicSphere sphere{0.5 * (x.squaredNorm() - 1.0), x, 0.5};
    RingEnergy energy;
    for_faces_after(mesh, edge, x, [&](const Triangle& t, int, int) { energy.add(sphere, t); });
    return energy.squared;
  };
  EXPECT_LT(energy_at(c.position.norm()), energy_at(1.0));
  EXPECT_LT(c.position.norm(), 1.01);
}

/// Where no sphere is near the surface, the planes decide alone: the cost is theirs to the bit.
TEST(AnchoredSphereMetric, LeavesSharpEdgesToThePlanes) {
  Shape box = dense_box(4, {1, 1, 1});
  for (Point& p : box.vertices) p += 0.01 * Point(std::sin(40 * p.y()), std::sin(50 * p.z()), 0);
  const WorkingMesh mesh = working_mesh(box);
  const SphereParams params = with(SphereEnergy::Squared, SpherePlacement::Free3D);
  const Parallel parallel(1);
  const VertexSpheres fits(mesh, params, params.feature_angle, parallel);
  QuadricMetric planes(mesh, plan_of(params).quadrics);
  planes.initialize(parallel);
  int sharp = 0;
  for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v) {
    if (!fits.sample_of(v).sharp) continue;
    ++sharp;
    const Edge edge = first_edge_of(mesh, v);
    const Candidate expected =
        planes.evaluate(edge, Allowed::Anywhere, wings_of(mesh, edge)).value();
    const Candidate c = evaluated<AnchoredSphereMetric>(mesh, params, edge);
    ASSERT_EQ(c.cost, expected.cost);
    ASSERT_EQ(c.position, expected.position);
  }
  EXPECT_GT(sharp, 40);
}

/// What is merged keeps the sphere: its next edge lies on it, too.
TEST(InterpolatedSphereMetric, KeepsTheSphereOfWhatIsMerged) {
  WorkingMesh mesh = working_mesh(icosphere(4));
  const SphereParams params = with(SphereEnergy::Squared, SpherePlacement::OnSphereAlongEdge);
  InterpolatedSphereMetric metric(mesh, plan_of(params));
  metric.initialize(Parallel(1));
  int v = 1000;
  for (int i = 0; i < 5; ++i) {
    const Edge edge = first_edge_of(mesh, v);
    const Candidate c = metric.evaluate(edge, Allowed::Anywhere, wings_of(mesh, edge)).value();
    EXPECT_NEAR(c.position.norm(), 1.0, 2e-4);
    collapse_edge(
        mesh, edge, c.position,
        [&](const EdgeNeighborhood& around, const std::vector<FacePlane>& after) {
          metric.release(around, after);
        },
        [&](const VertexMerge& done, const EdgeNeighborhood& around) {
          metric.merge(done, around);
        });
    v = edge.a;
  }
}

}  // namespace
}  // namespace curvdecim::test
