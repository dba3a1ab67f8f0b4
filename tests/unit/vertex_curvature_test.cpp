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

using namespace detail;

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

CurvatureWeight step(double alpha, double floor, double unit) {
  return {AlphaUnits::ScaleFree, alpha, floor, unit};
}

double factor(const CurvatureWeight& weight, double curvature) {
  return weight.factor(weight.saturation(curvature));
}

TEST(CurvatureWeight, RisesFromTheFloorToOne) {
  const CurvatureWeight weight = step(1.0, 0.25, 2.0);
  EXPECT_EQ(factor(weight, 0.0), 0.25);
  EXPECT_NEAR(factor(weight, 2.0), 0.25 + 0.75 * (1.0 - std::exp(-1.0)), 1e-15);
  EXPECT_NEAR(factor(weight, 4.0), 0.25 + 0.75 * (1.0 - std::exp(-4.0)), 1e-15);
  EXPECT_EQ(factor(weight, 1e6), 1.0);
}

TEST(CurvatureWeight, IsOneForInfiniteAlphaOrAFlatMesh) {
  for (AlphaUnits form : {AlphaUnits::ScaleFree, AlphaUnits::ModelUnits}) {
    for (double alpha : {0.0, -1.0})
      EXPECT_EQ(factor(CurvatureWeight(form, alpha, 0.0, 1.0), 3.0), 1.0);
    EXPECT_EQ(factor(CurvatureWeight(form, 1.0, 0.0, 0.0), 3.0), 1.0);
  }
}

TEST(CurvatureWeight, AsPrintedIsAccurateForTinyCurvature) {
  EXPECT_NEAR(CurvatureWeight(AlphaUnits::ModelUnits, 1.0, 0.0, 1.0).saturation(1e-18) / 1e-18, 1.0,
              1e-12);
}

TEST(CurvatureWeight, OfAnEdgeIsAsPrintedThatOfTheSumOfBothEnds) {
  const CurvatureWeight weight(AlphaUnits::ModelUnits, 0.5, 0.0, 1.0);
  EXPECT_NEAR(weight.of_edge(weight.saturation(1.0), weight.saturation(2.0)), 1.0 - std::exp(-1.5),
              1e-15);
}

TEST(CurvatureWeight, OfAnEdgeIsScaleFreeTheMeanOfBothEnds) {
  const CurvatureWeight weight = step(0.5, 0.25, 1.0);
  EXPECT_NEAR(weight.of_edge(weight.saturation(1.0), weight.saturation(2.0)),
              0.5 * (factor(weight, 1.0) + factor(weight, 2.0)), 1e-15);
}

TEST(CurvatureWeight, InModelUnitsIsThePapersFormula) {
  CurvatureParams params;
  params.alpha = 0.01, params.alpha_units = AlphaUnits::ModelUnits,
  params.curvature_kind = CurvatureKind::Gaussian;
  const double diagonal = 10.0, k_model = 30.0;  // in the box of diagonal 1 that is K diagonal^2
  EXPECT_NEAR(factor(curvature_weight(params, {}, diagonal), k_model * diagonal * diagonal),
              1.0 - std::exp(-0.01 * k_model), 1e-12);
  params.curvature_kind = CurvatureKind::Absolute;
  EXPECT_NEAR(factor(curvature_weight(params, {}, diagonal), k_model * diagonal),
              1.0 - std::exp(-0.01 * k_model), 1e-12);
}

/// What alpha and floor of the default make of the curvature k, where the field is over the mesh.
double scale_free_factor(const CurvatureField& field, double k) {
  CurvatureParams params;
  params.alpha = 1.0, params.curvature_floor = 0.0;
  return factor(curvature_weight(params, field, 5.0), k);
}

TEST(CurvatureWeight, ScaleFreeIsRelativeToTheMostCurvedFifth) {
  const CurvatureField field{{2.0, 1.0, 6.0}, {1.0, 7.0, 2.0}};
  EXPECT_NEAR(scale_free_factor(field, 6.0), 1.0 - std::exp(-1.0), 1e-15);
  EXPECT_NEAR(scale_free_factor(field, 3.0), 1.0 - std::exp(-0.25), 1e-15);
}

/// Else what decides on a box with round edges is rounding.
TEST(CurvatureWeight, ScaleFreeTakesRoundingAsFlatWhereMostOfTheMeshIsFlat) {
  const CurvatureField field{{0.0, 1e-12, 8.0}, {5.0, 4.0, 1.0}};
  EXPECT_LT(scale_free_factor(field, 1e-12), 1e-12);
  EXPECT_EQ(scale_free_factor(field, 8.0), 1.0);
}

}  // namespace
}  // namespace curvdecim::test
