// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/curvature/vertex_curvature.h"

#include <gtest/gtest.h>

#include <numeric>

#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/working_mesh.h"
#include "vcg_ext/curvature/curvature_field.h"
#include "vcg_ext/curvature/curvature_weight.h"

namespace curvdecim::test {
namespace {

std::vector<VertexCurvature> curvatures(const Shape& shape) {
  const WorkingMesh mesh = working_mesh(shape);
  std::vector<VertexCurvature> all;
  for (int v = 0; v < shape.vertex_count(); ++v) all.push_back(vertex_curvature(mesh, v));
  return all;
}

VertexCurvature at_vertex(const Shape& shape, int v) {
  return vertex_curvature(working_mesh(shape), v);
}

TEST(VertexCurvature, OfAPlaneIsZero) {
  for (const VertexCurvature& c : curvatures(plane_grid(4))) EXPECT_NEAR(c.absolute(), 0.0, 1e-12);
}

TEST(VertexCurvature, OfACubeCornerIsTheAngleDefectOverItsArea) {
  const VertexCurvature corner = at_vertex(tetrahedron(), 0);
  const double third = std::sqrt(3.0) * 2.0;  // three faces with edges of 2 sqrt 2, a third of each
  EXPECT_NEAR(corner.area, third, 1e-12);
  EXPECT_NEAR(corner.gaussian, M_PI / third, 1e-12);
}

TEST(VertexCurvature, TellsASaddleByItsSign) {
  EXPECT_LT(at_vertex(saddle(10), 60).gaussian, 0.0);
  EXPECT_GT(at_vertex(icosphere(2), 20).gaussian, 0.0);
}

TEST(VertexCurvature, OfAVertexWithoutFacesIsZero) {
  Shape shape = one_triangle();
  shape.vertices.push_back({1, 2, 3});
  EXPECT_EQ(at_vertex(shape, 3).absolute(), 0.0);
}

TEST(VertexCurvature, IsFiniteWhereFacesHaveNoArea) {
  const Shape flat = scaled(plane_grid(2), 0.0);
  EXPECT_EQ(at_vertex(flat, 4).absolute(), 0.0);
}

TEST(VertexCurvature, ScalesWithTheInverseLength) {
  const VertexCurvature one = at_vertex(saddle(10), 60),
                        half = at_vertex(scaled(saddle(10), 2.0), 60);
  EXPECT_DOUBLE_EQ(half.gaussian, one.gaussian / 4.0);
  EXPECT_DOUBLE_EQ(half.absolute(), one.absolute() / 2.0);
}

TEST(VertexCurvature, KindsAreAsNamed) {
  VertexCurvature c;
  c.gaussian = -4.0, c.mean = 0.0;
  EXPECT_EQ(c.of_kind(CurvatureKind::Gaussian), 4.0);
  EXPECT_EQ(c.of_kind(CurvatureKind::Absolute), 4.0);  // 2 and -2
  c.gaussian = 4.0, c.mean = -2.0;
  EXPECT_EQ(c.of_kind(CurvatureKind::Absolute), 4.0);  // -2 and -2
}

// --- the factor ----------------------------------------------------------------------------------

TEST(CurvatureWeight, RisesFromTheFloorToOne) {
  const CurvatureWeight weight(1.0, 0.25, 2.0);
  EXPECT_EQ(weight(0.0), 0.25);
  EXPECT_NEAR(weight(2.0), 0.25 + 0.75 * (1.0 - std::exp(-1.0)), 1e-15);
  EXPECT_EQ(weight(1e6), 1.0);
}

TEST(CurvatureWeight, IsOneForInfiniteAlphaOrAFlatMesh) {
  for (double alpha : {0.0, -1.0}) EXPECT_EQ(CurvatureWeight(alpha, 0.0, 1.0)(3.0), 1.0);
  EXPECT_EQ(CurvatureWeight(1.0, 0.0, 0.0)(3.0), 1.0);
}

TEST(CurvatureWeight, IsAccurateForTinyCurvature) {
  EXPECT_NEAR(CurvatureWeight(1.0, 0.0, 1.0)(1e-18) / 1e-18, 1.0, 1e-12);
}

TEST(CurvatureWeight, InModelUnitsIsThePapersFormula) {
  CurvatureParams params;
  params.alpha = 0.01, params.alpha_units = AlphaUnits::ModelUnits,
  params.curvature_kind = CurvatureKind::Gaussian;
  const double diagonal = 10.0, k_model = 30.0;  // in the box of diagonal 1 that is K diagonal^2
  EXPECT_NEAR(curvature_weight(params, 0.0, diagonal)(k_model * diagonal * diagonal),
              1.0 - std::exp(-0.01 * k_model), 1e-12);
  params.curvature_kind = CurvatureKind::Absolute;
  EXPECT_NEAR(curvature_weight(params, 0.0, diagonal)(k_model * diagonal),
              1.0 - std::exp(-0.01 * k_model), 1e-12);
}

TEST(CurvatureWeight, ScaleFreeIsRelativeToTheAreaWeightedMean) {
  const CurvatureField field{{2.0, 6.0}, {3.0, 1.0}};
  EXPECT_EQ(field.mean(), 3.0);
  CurvatureParams params;
  params.alpha = 1.0, params.curvature_floor = 0.0;
  EXPECT_NEAR(curvature_weight(params, field.mean(), 5.0)(3.0), 1.0 - std::exp(-1.0), 1e-15);
}

}  // namespace
}  // namespace curvdecim::test
