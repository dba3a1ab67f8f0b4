// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/curvature/curvature_field.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {
namespace {

CurvatureField field_with(const WorkingMesh& mesh, double value) {
  const std::size_t count = mesh.position.size();
  return {std::vector<double>(count, value), std::vector<double>(count, 1.0)};
}

CurvatureField averaged(const WorkingMesh& mesh, CurvatureField field, int threads = 1) {
  average_over_rings(mesh, field, Parallel(threads));
  return field;
}

CurvatureField field_of(const WorkingMesh& mesh, CurvatureOf of) {
  CurvatureParams params;
  params.curvature_of = of;
  return curvature_field(mesh, params, Parallel(1));
}

TEST(CurvatureField, HasAMeanWeightedByArea) {
  EXPECT_EQ((CurvatureField{{2.0, 6.0, 100.0}, {3.0, 1.0, 0.0}}).mean(), 3.0);
  EXPECT_EQ((CurvatureField{{5.0, 5.0}, {0.1, 7.0}}).mean(), 5.0);
}

TEST(CurvatureField, HasMeanZeroWithoutArea) {
  EXPECT_EQ((CurvatureField{{2.0, 6.0}, {0.0, 0.0}}).mean(), 0.0);
  EXPECT_EQ(CurvatureField().mean(), 0.0);
}

TEST(CurvatureField, IsThatOfEveryVertexInItsKind) {
  const WorkingMesh mesh = working_mesh(saddle(6));
  for (CurvatureKind kind : {CurvatureKind::Gaussian, CurvatureKind::Absolute}) {
    const CurvatureField field = curvature_field(mesh, kind, Parallel(1));
    for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v) {
      EXPECT_EQ(field.value[v], vertex_curvature(mesh, v).of_kind(kind));
      EXPECT_EQ(field.area[v], vertex_curvature(mesh, v).area);
    }
  }
}

// --- averaging -----------------------------------------------------------------------------------

TEST(AverageOverRings, LeavesAConstantAsItIs) {
  const WorkingMesh mesh = working_mesh(noisy_sphere(2, 0.05));
  const CurvatureField field = averaged(mesh, field_with(mesh, 0.7));
  for (double value : field.value) EXPECT_NEAR(value, 0.7, 1e-14);
}

TEST(AverageOverRings, SpreadsASpikeOverItsRingAndNoFurther) {
  const WorkingMesh mesh = working_mesh(plane_grid(8));
  constexpr int spike = 40, neighbors = 6;  // the middle
  CurvatureField field = field_with(mesh, 0.0);
  field.value[spike] = 1.0;
  const CurvatureField after = averaged(mesh, field);
  for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v) {
    const bool near = v == spike || mesh.connectivity.has_edge(v, spike);
    EXPECT_EQ(after.value[v], near ? 1.0 / (neighbors + 1) : 0.0) << v;
  }
  EXPECT_EQ(after.area, field.area);
}

TEST(AverageOverRings, GivesABoundaryVertexWhatItsInnerNeighboursHave) {
  const WorkingMesh mesh = working_mesh(plane_grid(2));
  constexpr int inner = 4;
  CurvatureField field = field_with(mesh, 5.0);
  field.value[inner] = 1.0;
  const CurvatureField after = averaged(mesh, field);
  for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v)
    EXPECT_EQ(after.value[v], v == inner || mesh.connectivity.has_edge(v, inner) ? 1.0 : 5.0);
}

TEST(AverageOverRings, LeavesAVertexWithoutInnerNeighboursAlone) {
  Shape shape = one_triangle();
  shape.vertices.push_back({5, 5, 5});
  const WorkingMesh mesh = working_mesh(shape);
  const std::vector<double> values = {0.0, 3.0, 6.0, 9.0};
  EXPECT_EQ(averaged(mesh, {values, {1, 1, 1, 1}}).value, values);
}

TEST(AverageOverRings, DoesNotDependOnTheThreads) {
  const WorkingMesh mesh = working_mesh(noisy_sphere(5, 0.05));
  const CurvatureField field = curvature_field(mesh, CurvatureKind::Absolute, Parallel(1));
  EXPECT_EQ(curvature_field(mesh, CurvatureKind::Absolute, Parallel(3)).value, field.value);
  EXPECT_EQ(averaged(mesh, field, 3).value, averaged(mesh, field).value);
}

// --- of what -------------------------------------------------------------------------------------

TEST(CurvatureOf, CurrentIsAsMeasured) {
  const WorkingMesh mesh = working_mesh(noisy_sphere(2, 0.05));
  EXPECT_EQ(field_of(mesh, CurvatureOf::Current).value,
            curvature_field(mesh, CurvatureKind::Absolute, Parallel(1)).value);
}

TEST(CurvatureOf, InputIsAveragedOnce) {
  const WorkingMesh mesh = working_mesh(noisy_sphere(2, 0.05));
  const CurvatureField measured = field_of(mesh, CurvatureOf::Current);
  EXPECT_EQ(field_of(mesh, CurvatureOf::Input).value, averaged(mesh, measured).value);
  EXPECT_NE(field_of(mesh, CurvatureOf::Input).value, measured.value);
}

}  // namespace
}  // namespace curvdecim::test
