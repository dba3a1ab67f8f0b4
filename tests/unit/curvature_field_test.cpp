// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/curvature/curvature_field.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

CurvatureField field_with(const WorkingMesh& mesh, double value) {
  const std::size_t count = mesh.position.size();
  return {std::vector<double>(count, value), std::vector<double>(count, 1.0)};
}

CurvatureField averaged(const WorkingMesh& mesh, CurvatureField field, int threads = 1) {
  average_over_rings(mesh, field, Parallel(threads),
                     [&](int v) { return mesh.kind[v] == VertexKind::Interior; });
  return field;
}

CurvatureParams model_units(CurvatureKind kind, CurvatureOf of) {
  CurvatureParams params;
  params.alpha_units = AlphaUnits::ModelUnits, params.curvature_kind = kind,
  params.curvature_of = of;
  return params;
}

CurvatureField field_of(const WorkingMesh& mesh, CurvatureOf of, int threads = 1) {
  return curvature_field(mesh, model_units(CurvatureKind::Absolute, of), Parallel(threads));
}

TEST(CurvatureField, HasAMeanWeightedByArea) {
  EXPECT_EQ((CurvatureField{{2.0, 6.0, 100.0}, {3.0, 1.0, 0.0}}).mean(), 3.0);
  EXPECT_EQ((CurvatureField{{5.0, 5.0}, {0.1, 7.0}}).mean(), 5.0);
}

TEST(CurvatureField, HasMeanZeroWithoutArea) {
  EXPECT_EQ((CurvatureField{{2.0, 6.0}, {0.0, 0.0}}).mean(), 0.0);
  EXPECT_EQ(CurvatureField().mean(), 0.0);
}

// --- the most curved part ------------------------------------------------------------------------

TEST(LeastOfMostCurved, GoesByAreaAndNotByVertices) {
  const CurvatureField even{{5.0, 1.0, 4.0, 2.0, 3.0}, {1.0, 1.0, 1.0, 1.0, 1.0}};
  EXPECT_EQ(even.least_of_most_curved(0.2), 5.0);
  EXPECT_EQ(even.least_of_most_curved(0.3), 4.0);
  EXPECT_EQ(even.least_of_most_curved(1.0), 1.0);
  const CurvatureField large{{5.0, 1.0, 4.0, 2.0, 3.0}, {0.0, 1.0, 0.1, 6.0, 2.9}};
  EXPECT_EQ(large.least_of_most_curved(0.2), 3.0);
  EXPECT_EQ(large.least_of_most_curved(0.5), 2.0);
}

TEST(LeastOfMostCurved, TakesAnyNumberOfEqualValues) {
  EXPECT_EQ((CurvatureField{std::vector<double>(99, 7.0), std::vector<double>(99, 0.1)})
                .least_of_most_curved(0.2),
            7.0);
}

TEST(LeastOfMostCurved, IsDefinedWithoutVerticesOrArea) {
  EXPECT_EQ(CurvatureField().least_of_most_curved(0.2), 0.0);
  EXPECT_EQ((CurvatureField{{2.0, 6.0}, {0.0, 0.0}}).least_of_most_curved(0.2), 6.0);
}

/// Four small faces in place of one: as much area has as much curvature.
TEST(LeastOfMostCurved, DoesNotDependOnTheOrderOrTheDensity) {
  const auto least = [](std::vector<double> value, std::vector<double> area) {
    return CurvatureField{std::move(value), std::move(area)}.least_of_most_curved(0.2);
  };
  const double expected = least({1, 2, 3, 4}, {4, 4, 4, 4});
  EXPECT_EQ(least({4, 2, 1, 3}, {4, 4, 4, 4}), expected);
  EXPECT_EQ(least({1, 1, 1, 1, 2, 3, 4}, {1, 1, 1, 1, 4, 4, 4}), expected);
  EXPECT_EQ(least({1, 2, 3, 4, 4, 4, 4}, {4, 4, 4, 1, 1, 1, 1}), expected);
}

// --- of a mesh -----------------------------------------------------------------------------------

TEST(CurvatureField, IsThatOfEveryVertexInItsKind) {
  const WorkingMesh mesh = working_mesh(saddle(6));
  for (CurvatureKind kind : {CurvatureKind::Gaussian, CurvatureKind::Absolute}) {
    const CurvatureField field =
        curvature_field(mesh, model_units(kind, CurvatureOf::Current), Parallel(1));
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
  const CurvatureField field = field_of(mesh, CurvatureOf::Current);
  EXPECT_EQ(field_of(mesh, CurvatureOf::Current, 3).value, field.value);
  EXPECT_EQ(averaged(mesh, field, 3).value, averaged(mesh, field).value);
}

// --- of what -------------------------------------------------------------------------------------

TEST(CurvatureOf, CurrentIsAsMeasured) {
  const WorkingMesh mesh = working_mesh(noisy_sphere(2, 0.05));
  const CurvatureField field = field_of(mesh, CurvatureOf::Current);
  for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v)
    EXPECT_EQ(field.value[v], vertex_curvature(mesh, v).absolute());
}

TEST(CurvatureOf, InputIsAveragedOnce) {
  const WorkingMesh mesh = working_mesh(noisy_sphere(2, 0.05));
  const CurvatureField measured = field_of(mesh, CurvatureOf::Current);
  EXPECT_EQ(field_of(mesh, CurvatureOf::Input).value, averaged(mesh, measured).value);
  EXPECT_NE(field_of(mesh, CurvatureOf::Input).value, measured.value);
}

// --- scale-free ----------------------------------------------------------------------------------

CurvatureField scale_free(const WorkingMesh& mesh,
                          CurvatureKind kind = CurvatureParams().curvature_kind) {
  CurvatureParams params;
  params.curvature_kind = kind;
  return curvature_field(mesh, params, Parallel(1));
}

TEST(ScaleFreeCurvature, TakesABorderAsCurved) {
  const WorkingMesh mesh = working_mesh(plane_grid(8));
  for (CurvatureKind kind : {CurvatureKind::Gaussian, CurvatureKind::Absolute}) {
    const CurvatureField field = scale_free(mesh, kind);
    for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v) {
      bool near = false;
      for (int f : mesh.connectivity.faces_of(v))
        for (int u : mesh.connectivity.face(f)) near |= mesh.kind[u] == VertexKind::Boundary;
      if (near)
        EXPECT_GT(field.value[v], 1.0) << v;
      else
        EXPECT_NEAR(field.value[v], 0.0, 1e-9) << v;
    }
  }
}

TEST(ScaleFreeCurvature, PutsACylinderBetweenAPlaneAndASphere) {
  constexpr int along = 30;
  const WorkingMesh cylinder = working_mesh(open_cylinder(96, along));
  const WorkingMesh sphere = working_mesh(icosphere(4));
  const auto at = [](const WorkingMesh& mesh, int v, CurvatureKind kind) {
    return scale_free(mesh, kind).value[v];
  };
  constexpr int halfway = along / 2, last = 2561;
  EXPECT_NEAR(at(cylinder, halfway, CurvatureKind::Gaussian), 0.0, 1e-6);
  EXPECT_NEAR(at(cylinder, halfway, CurvatureKind::Absolute), 0.03, 1e-3);
  EXPECT_NEAR(at(sphere, last, CurvatureKind::Gaussian), 1.0, 0.1);
  EXPECT_NEAR(at(sphere, last, CurvatureKind::Absolute), 1.12, 0.1);  // 1 + 0.03 * 2^2
}

}  // namespace
}  // namespace curvdecim::test
