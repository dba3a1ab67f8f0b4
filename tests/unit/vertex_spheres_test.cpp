// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/curvature/vertex_spheres.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/mesh_types.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

std::vector<AlgebraicSphere> spheres_of(const WorkingMesh& mesh, const SphereParams& params = {}) {
  return VertexSpheres(mesh, params, params.feature_angle, Parallel(1)).fit();
}

SphereParams with_kernel(double scale, bool adaptive) {
  SphereParams params;
  params.kernel_scale = scale, params.adaptive_kernel = adaptive;
  return params;
}

TEST(Kernel, FallsFromOneToNothingAtItsRadius) {
  EXPECT_EQ(kernel_weight(0.0, 4.0), 1.0);
  EXPECT_DOUBLE_EQ(kernel_weight(1.0, 4.0), 0.75 * 0.75 * 0.75 * 0.75);
  EXPECT_EQ(kernel_weight(4.0, 4.0), 0.0);
  EXPECT_EQ(kernel_weight(9.0, 4.0), 0.0);
  EXPECT_EQ(kernel_weight(0.0, 0.0), 0.0);  // of no size: nothing, not a number
}

class SampledSphere : public testing::TestWithParam<double> {};

TEST_P(SampledSphere, IsReproducedAtEveryVertex) {
  const double radius = GetParam();
  const Vector3 centre = radius * Vector3(50, -20, 10);
  const WorkingMesh mesh = working_mesh(translated(scaled(icosphere(4), radius), centre));
  const std::vector<AlgebraicSphere> spheres = spheres_of(mesh);
  for (std::size_t v = 0; v < spheres.size(); ++v) {
    const AlgebraicSphere& s = spheres[v];
    ASSERT_NEAR(0.5 / s.q / radius, 1.0, 0.01);
    ASSERT_NEAR((mesh.position[v] - 0.5 / s.q * s.l - centre).norm() / radius, 0.0, 0.01);
    ASSERT_NEAR(s.value(Vector3::Zero()) / radius, 0.0, 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(Radii, SampledSphere, testing::Values(1e-3, 1.0, 1e3));

TEST(SampledSphere, IsReproducedFromSinglePrecision) {
  FloatMesh coarse;
  fill(coarse, translated(icosphere(4), {50, -20, 10}));
  const WorkingMesh mesh = working_mesh(shape_of(coarse));
  for (const AlgebraicSphere& s : spheres_of(mesh)) ASSERT_NEAR(0.5 / s.q, 1.0, 0.01);
}

TEST(SampledSphere, IsReproducedFromNoiseTheBetterTheLargerTheKernel) {
  const WorkingMesh mesh = working_mesh(noisy_sphere(4, 0.003));
  const auto deviation = [&](double scale) {
    double sum = 0.0;
    const std::vector<AlgebraicSphere> spheres = spheres_of(mesh, with_kernel(scale, false));
    for (const AlgebraicSphere& s : spheres) sum += std::pow(2.0 * s.q - 1.0, 2);
    return std::sqrt(sum / spheres.size());
  };
  EXPECT_LT(deviation(4.0), 0.5 * deviation(2.0));
  EXPECT_LT(deviation(6.0), 0.15);
}

TEST(SampledPlane, IsReproduced) {
  const WorkingMesh mesh = working_mesh(rotated(plane_grid(10), 0.8, {1, 2, 3}));
  const Vector3 normal = mesh.plane[0].normal;
  for (const AlgebraicSphere& s : spheres_of(mesh)) {
    ASSERT_NEAR(s.q, 0.0, 1e-11);
    ASSERT_NEAR(s.l.dot(normal), 1.0, 1e-12);
    ASSERT_NEAR(s.c, 0.0, 1e-14);
  }
}

TEST(SampledCylinder, HasItsMeanCurvature) {
  const WorkingMesh mesh = working_mesh(open_cylinder(96, 30));
  const std::vector<AlgebraicSphere> spheres = spheres_of(mesh);
  for (std::size_t v = 0; v < spheres.size(); ++v) {
    if (std::abs(mesh.position[v].z() - 1.0) > 0.7) continue;  // the ends see one side
    ASSERT_NEAR(2.0 * spheres[v].q, 0.5, 0.08);
    ASSERT_NEAR(spheres[v].c, 0.0, 2e-3);
  }
}

/// Around the sharp edges of a box lie planes, and their spheres are these planes.
TEST(SharpEdges, AreNotFittedAcross) {
  const WorkingMesh mesh = working_mesh(dense_box(8, {1, 1, 1}));
  const SphereParams params;
  const Parallel parallel(1);
  const VertexSpheres fits(mesh, params, params.feature_angle, parallel);
  const std::vector<AlgebraicSphere> spheres = fits.fit();
  int sharp = 0, near = 0;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const int v = static_cast<int>(i);
    sharp += fits.sample_of(v).sharp;
    if (fits.sample_of(v).sharp) continue;
    for (int f : mesh.connectivity.faces_of(v))
      for (int u : mesh.connectivity.face(f)) near += fits.sample_of(u).sharp;
    EXPECT_NEAR(spheres[i].q, 0.0, 1e-12);
    EXPECT_NEAR(spheres[i].c, 0.0, 1e-12);
  }
  EXPECT_EQ(sharp, 12 * 7 + 8);
  EXPECT_GT(near, 0);
}

TEST(SharpEdges, AreThereForTheFeatureAngleOnly) {
  const WorkingMesh mesh = working_mesh(dense_box(4, {1, 1, 1}));
  SphereParams params;
  params.feature_angle = 180.0;
  const Parallel parallel(1);
  const VertexSpheres fits(mesh, params, params.feature_angle, parallel);
  bool sharp = false;
  for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v) sharp |= fits.sample_of(v).sharp;
  EXPECT_TRUE(sharp);  // a turn of half of it is sharp, and that of a box is just that
}

/// A spike bends all fits near it; a smaller kernel leaves more vertices alone.
TEST(AdaptiveKernel, ShrinksWhereTheFitIsBad) {
  Shape shape = plane_grid(20);
  for (Point& p : shape.vertices)
    p.z() = 0.2 * std::exp(-std::pow((p - Point(0.5, 0.5, 0)).head<2>().norm() / 0.08, 2));
  const WorkingMesh mesh = working_mesh(shape);
  SphereParams fixed = with_kernel(6.0, false), adaptive = with_kernel(6.0, true);
  fixed.feature_angle = adaptive.feature_angle = 180.0;
  const auto residual = [&](const SphereParams& params) {
    double sum = 0.0;
    for (const AlgebraicSphere& s : spheres_of(mesh, params)) sum += s.c * s.c;
    return sum;
  };
  EXPECT_LT(residual(adaptive), 0.5 * residual(fixed));
}

TEST(AdaptiveKernel, GrowsWhereTheFitIsGood) {
  const WorkingMesh mesh = working_mesh(icosphere(5));
  const auto deviation = [&](bool adaptive) {
    double sum = 0.0;
    for (const AlgebraicSphere& s : spheres_of(mesh, with_kernel(1.5, adaptive)))
      sum += std::pow(2.0 * s.q - 1.0, 2);
    return sum;
  };
  EXPECT_LT(deviation(true), deviation(false));
}

TEST(VertexSpheres, AreTheSameOnAnyNumberOfThreads) {
  const WorkingMesh mesh = working_mesh(noisy_sphere(4, 0.02));
  const std::vector<AlgebraicSphere> expected = spheres_of(mesh);
  const std::vector<AlgebraicSphere> spheres =
      VertexSpheres(mesh, {}, SphereParams().feature_angle, Parallel(3)).fit();
  for (std::size_t v = 0; v < spheres.size(); ++v) {
    ASSERT_EQ(spheres[v].c, expected[v].c);
    ASSERT_EQ(spheres[v].l, expected[v].l);
    ASSERT_EQ(spheres[v].q, expected[v].q);
  }
}

TEST(VertexSpheres, AreNumbersWhereFacesHaveNoArea) {
  Shape shape = plane_grid(4);
  for (Point& p : shape.vertices) p.y() = 0.0;
  for (const AlgebraicSphere& s : spheres_of(working_mesh(shape))) {
    ASSERT_TRUE(std::isfinite(s.c) && std::isfinite(s.q) && s.l.allFinite());
  }
}

}  // namespace
}  // namespace curvdecim::test
