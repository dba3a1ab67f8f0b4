// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres and cylinders: known curvature, known order of the error.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/mesh_group.h"
#include "support/properties.h"
#include "support/rich_mesh.h"
#include "support/working_mesh.h"
#include "vcg_ext/curvature/vertex_curvature.h"

namespace curvdecim::test {

using namespace detail;

namespace {

// --- Gauss-Bonnet --------------------------------------------------------------------------------

class GaussBonnet : public testing::TestWithParam<NamedShape> {};

/// Closed: the sum of K times area. Open: the boundary vertices' turns, measured against pi, too.
TEST_P(GaussBonnet, CurvatureSumsToTwoPiTimesTheEulerNumber) {
  const WorkingMesh mesh = working_mesh(GetParam().shape);
  double sum = 0.0;
  for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v) {
    const VertexCurvature c = vertex_curvature(mesh, v);
    sum += c.gaussian * c.area;
  }
  EXPECT_NEAR(sum, 2.0 * M_PI * topology(GetParam().shape).euler, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Drawn, GaussBonnet, testing::ValuesIn(manifold_meshes()), name_of);

TEST(GaussBonnetAfter, DecimationTheSumIsTheSame) {
  for (const NamedShape& mesh : closed_meshes()) {
    const Shape after = decimated(mesh.shape, to_faces(mesh.shape.face_count() / 3)).shape;
    const WorkingMesh working = working_mesh(after);
    double sum = 0.0;
    for (int v = 0; v < after.vertex_count(); ++v) {
      const VertexCurvature c = vertex_curvature(working, v);
      sum += c.gaussian * c.area;
    }
    EXPECT_NEAR(sum, 2.0 * M_PI * topology(mesh.shape).euler, 1e-9) << mesh.name;
  }
}

// --- curvature of known surfaces -----------------------------------------------------------------

class Radius : public testing::TestWithParam<double> {};

/// A third of the faces is not quite the area of an irregular vertex: the mean over the sphere is
/// near the true value, and no vertex is far from it.
TEST_P(Radius, OfASphereGivesAbsoluteCurvatureTwoOverIt) {
  const Shape sphere = scaled(icosphere(4), GetParam());
  const WorkingMesh mesh = working_mesh(sphere);
  double sum = 0.0, total = 0.0;
  for (int v = 0; v < sphere.vertex_count(); ++v) {
    const VertexCurvature c = vertex_curvature(mesh, v);
    sum += c.absolute() * c.area, total += c.area;
    ASSERT_NEAR(c.absolute() * GetParam(), 2.0, 0.3);
    ASSERT_NEAR(c.gaussian * GetParam() * GetParam(), 1.0, 0.15);
  }
  EXPECT_NEAR(sum / total * GetParam(), 2.0, 0.01);
}

TEST_P(Radius, OfACylinderGivesAbsoluteCurvatureOneOverIt) {
  const Shape cylinder = scaled(open_cylinder(96, 30), GetParam());
  const WorkingMesh mesh = working_mesh(cylinder);
  for (int v = 0; v < cylinder.vertex_count(); ++v) {
    if (mesh.kind[v] == VertexKind::Boundary) continue;
    ASSERT_NEAR(vertex_curvature(mesh, v).absolute() * GetParam(), 1.0, 0.02);
    ASSERT_NEAR(vertex_curvature(mesh, v).gaussian * GetParam() * GetParam(), 0.0, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Lengths, Radius, testing::Values(0.01, 1.0, 250.0));

/// What the Curvature Importance filter writes is in the mesh's unit.
TEST_P(Radius, ShowsInTheImportance) {
  RichMesh mesh;
  fill(mesh, scaled(icosphere(3), GetParam()));
  ImportanceParams params;
  params.curvature_kind = CurvatureKind::Absolute;
  importance(mesh, params);
  for (const RichVertex& v : mesh.vert) ASSERT_NEAR(v.cQ() * GetParam(), 2.0, 0.3);
  params.curvature_kind = CurvatureKind::Gaussian;
  importance(mesh, params);
  for (const RichVertex& v : mesh.vert) ASSERT_NEAR(v.cQ() * GetParam() * GetParam(), 1.0, 0.2);
  params.output = ImportanceOf::Factor;
  importance(mesh, params);
  for (const RichVertex& v : mesh.vert) {
    ASSERT_GE(v.cQ(), params.curvature_floor);
    ASSERT_LE(v.cQ(), 1.0);
  }
}

// --- error ---------------------------------------------------------------------------------------

TEST(Sphere, KeepsItsVerticesNearItself) {
  for (const Variant& variant : all_variants()) {
    SCOPED_TRACE(variant.name);
    const Shape after = decimated(icosphere(3), variant.with_target(320)).shape;
    for (const Point& p : after.vertices) EXPECT_NEAR(p.norm(), 1.0, 0.05);
  }
}

/// As printed, vertices lie on the interpolated spheres.
TEST(Sphere, OfAHundredFacesHasItsVerticesOnItselfByInterpolatedSpheres) {
  for (SphereEnergy energy : {SphereEnergy::Squared, SphereEnergy::Poster}) {
    SphereParams params = spheres_to_faces(100);
    params.energy = energy, params.placement = SpherePlacement::OnSphereAlongEdge;
    const Shape after = decimated(icosphere(5), params).shape;
    EXPECT_EQ(after.face_count(), 100);
    for (const Point& p : after.vertices) EXPECT_NEAR(p.norm(), 1.0, 1e-3);
  }
}

/// Free in space they lie outside, so that faces are as far in as out: half the error.
TEST(Sphere, OfAHundredFacesLiesOnBothSidesOfItselfByAnchoredSpheres) {
  const Shape sphere = icosphere(5);
  SphereParams params = spheres_to_faces(100);
  const Shape free = decimated(sphere, params).shape;
  params.placement = SpherePlacement::OnSphereAlongEdge;
  const Shape on = decimated(sphere, params).shape;
  EXPECT_LT(two_sided_rms(sphere, free), 0.6 * two_sided_rms(sphere, on));
  EXPECT_NEAR(volume(free) / volume(sphere), 1.0, 0.03);
  EXPECT_LT(volume(on) / volume(sphere), 0.95);
}

TEST(Sphere, KeepsItsVolume) {
  const Shape after = decimated(icosphere(4), to_faces(320)).shape;
  EXPECT_NEAR(volume(after) / volume(icosphere(4)), 1.0, 0.005);
}

/// A surface of n faces can be no nearer than O(1/n): a quarter of the faces, four times the error.
TEST(Sphere, ErrorGrowsInInverseProportionToTheFaces) {
  const Shape sphere = icosphere(4);
  const double fine = two_sided_rms(sphere, decimated(sphere, to_faces(800)).shape);
  const double coarse = two_sided_rms(sphere, decimated(sphere, to_faces(200)).shape);
  EXPECT_GT(coarse / fine, 2.0);
  EXPECT_LT(coarse / fine, 8.0);
}

TEST(Cylinder, KeepsItsRadiusAndItsEnds) {
  const Shape after = decimated(open_cylinder(64, 16), to_faces(200)).shape;
  double low = 1.0, high = 1.0;
  for (const Point& p : after.vertices) {
    EXPECT_NEAR(p.head<2>().norm(), 1.0, 0.02);
    low = std::min(low, p.z()), high = std::max(high, p.z());
  }
  EXPECT_NEAR(low, 0.0, 1e-9);
  EXPECT_NEAR(high, 2.0, 1e-9);
  EXPECT_EQ(topology(after).boundary_loops, 2);
}

TEST(CappedCylinder, KeepsItsSharpRims) {
  const Shape before = capped_cylinder(48, 12);
  const Shape after = decimated(before, to_faces(160)).shape;
  EXPECT_LT(two_sided_distance(before, after), 0.01 * diagonal(before));
}

/// Where the curvature is: bumps get more of the faces with the curvature metric than without.
TEST(BumpySphere, GetsMoreFacesOnItsBumpsByTheCurvatureMetric) {
  const Shape sphere = bumpy_sphere(5);
  EdgeCollapseParams params = to_faces(1000);
  const auto bumpy_faces = [&](Metric metric) {
    params.metric = metric, params.alpha = 0.1, params.curvature_floor = 0.0;
    const Shape after = decimated(sphere, params).shape;
    return std::count_if(after.faces.begin(), after.faces.end(),
                         [&](const Corners& f) { return corners_of(after, f)[0].z() > 0.2; });
  };
  EXPECT_GT(bumpy_faces(Metric::CurvatureWeighted), bumpy_faces(Metric::Quadric));
}

}  // namespace
}  // namespace curvdecim::test
