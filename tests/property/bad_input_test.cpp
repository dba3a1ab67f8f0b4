// SPDX-License-Identifier: GPL-3.0-or-later
// What cannot be decimated is refused with one clear message, and the mesh is as it was.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/expectations.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_refused(RichMesh& mesh, const EdgeCollapseParams& params,
                    const std::vector<std::string>& words) {
  expect_refusal(
      mesh, [&] { decimate(mesh, params); }, words);
}

TEST(BadMesh, EmptyIsRefused) {
  RichMesh mesh;
  expect_refused(mesh, to_faces(10), {"empty"});
}

TEST(BadMesh, PointsWithoutFacesAreRefused) {
  RichMesh mesh;
  fill(mesh, {icosphere(0).vertices, {}});
  expect_refused(mesh, to_faces(10), {"12 points", "no faces"});
}

TEST(BadMesh, AllFacesDeletedIsRefused) {
  RichMesh mesh;
  fill_with_attributes(mesh, octahedron());
  for (RichFace& f : mesh.face) vcg::tri::Allocator<RichMesh>::DeleteFace(mesh, f);
  expect_refused(mesh, to_faces(4), {"no faces"});
}

TEST(BadMesh, AllVerticesDeletedIsRefused) {
  RichMesh mesh;
  fill_with_attributes(mesh, octahedron());
  for (RichFace& f : mesh.face) vcg::tri::Allocator<RichMesh>::DeleteFace(mesh, f);
  for (RichVertex& v : mesh.vert) vcg::tri::Allocator<RichMesh>::DeleteVertex(mesh, v);
  expect_refused(mesh, to_faces(4), {"empty"});
}

TEST(BadMesh, ACoordinateThatIsNotFiniteIsNamed) {
  for (double bad : {nan, infinity, -infinity})
    for (int axis : {0, 1, 2}) {
      RichMesh mesh;
      fill_with_attributes(mesh, icosphere(1));
      mesh.vert[17].P()[axis] = bad;
      expect_refused(mesh, to_faces(10), {"Vertex 17", "finite"});
    }
}

TEST(BadMesh, AnIsolatedVertexThatIsNotFiniteDoesNotMatter) {
  Shape shape = icosphere(1);
  const Shape expected = decimated(shape, to_faces(30)).shape;
  RichMesh mesh;
  fill(mesh, shape);
  vcg::tri::Allocator<RichMesh>::AddVertex(mesh, {nan, infinity, 0.0});
  decimate(mesh, to_faces(30));
  Shape result = shape_of(mesh);
  EXPECT_TRUE(std::isnan(result.vertices.back().x()));
  result.vertices.pop_back();
  EXPECT_EQ(result, expected);
}

TEST(BadMesh, AFaceOfADeletedVertexIsNamed) {
  RichMesh mesh;
  fill_with_attributes(mesh, octahedron());
  mesh.vert[4].SetD();
  expect_refused(mesh, to_faces(4), {"Face 0", "does not exist"});
}

TEST(BadMesh, AFaceWithoutVerticesIsNamed) {
  RichMesh mesh;
  fill_with_attributes(mesh, octahedron());
  mesh.face[2].V(1) = nullptr;
  const auto refused = [&] { decimate(mesh, to_faces(4)); };
  EXPECT_THROW(refused(), InputError);
}

TEST(BadMesh, OnlyFacesThatUseAVertexTwiceAreRefused) {
  RichMesh mesh;
  fill(mesh, {{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}, {0, 0, 1}}});
  expect_refused(mesh, to_faces(1), {"twice"});
}

TEST(BadMesh, AllInOnePointIsRefused) {
  RichMesh mesh;
  fill(mesh, scaled(octahedron(), 0.0));
  expect_refused(mesh, to_faces(4), {"one point"});
}

TEST(BadMesh, CoordinatesTooLargeToSubtractAreRefused) {
  RichMesh mesh;
  fill(mesh, scaled(octahedron(), 1.7e308));
  expect_refused(mesh, to_faces(4), {"too large"});
}

TEST(BadMesh, FacesWithoutAreaAreDecimatedWithoutDamage) {
  Shape shape = plane_grid(6);
  for (Point& p : shape.vertices) p.x() += 0.01 * p.y(), p.y() = 0.0;  // no two in one place
  const Shape after = decimated(shape, to_faces(10)).shape;
  EXPECT_TRUE(all_finite(after));
  EXPECT_PRED2(keeps_topology, topology(shape), topology(after));
}

TEST(BadMesh, RepairsAreSaid) {
  Shape shape = icosphere(1);
  shape.faces.push_back(shape.faces[3]);
  shape.faces.push_back({5, 5, 6});
  const auto [after, report] = decimated(shape, to_faces(20));
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes[0].find("Removed 2 faces"), std::string::npos) << report.notes[0];
  EXPECT_EQ(topology(after).duplicate_faces, 0);
}

TEST(BadMesh, NonManifoldPlacesAreSaid) {
  const DecimationReport report = decimated(book(3, 4), to_faces(20)).report;
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes[0].find("5 vertices are non-manifold"), std::string::npos)
      << report.notes[0];
}

TEST(BadMesh, PartsOfVeryDifferentSizeGiveFiniteCoordinates) {
  for (double tiny : {1e-100, 1e-155, 1e-160, 1e-200, 1e-300}) {
    const Shape shape = side_by_side({icosphere(1), scaled(icosphere(1), tiny)});
    for (bool keeps : {true, false}) {
      EdgeCollapseParams params = to_faces(60);
      params.preserve_topology = keeps;
      const Shape after = decimated(shape, params).shape;
      EXPECT_TRUE(all_finite(after)) << tiny;
      EXPECT_EQ(topology(after).components, keeps ? 2 : 1) << tiny;
    }
  }
}

// --- parameters ----------------------------------------------------------------------------------

struct BadParameter {
  const char* name;
  const char* word;  // in the message
  void (*set)(EdgeCollapseParams&);
};

void PrintTo(const BadParameter& parameter, std::ostream* out) { *out << parameter.name; }

class BadParameters : public testing::TestWithParam<BadParameter> {};

TEST_P(BadParameters, AreRefusedByName) {
  RichMesh mesh;
  fill_with_attributes(mesh, icosphere(1));
  EdgeCollapseParams params = to_faces(20);
  GetParam().set(params);
  expect_refused(mesh, params, {GetParam().word});
}

using P = EdgeCollapseParams;

INSTANTIATE_TEST_SUITE_P(
    Each, BadParameters,
    testing::Values(
        BadParameter{"NegativeFaces", "target_faces", [](P& p) { p.target_faces = -1; }},
        BadParameter{"SmallestFaces", "target_faces",
                     [](P& p) { p.target_faces = std::numeric_limits<int>::min(); }},
        BadParameter{"NegativeVertices", "target_vertices", [](P& p) { p.target_vertices = -3; }},
        BadParameter{"NegativeFraction", "target_fraction", [](P& p) { p.target_fraction = -0.1; }},
        BadParameter{"FractionAboveOne", "target_fraction", [](P& p) { p.target_fraction = 1.01; }},
        BadParameter{"FractionNan", "target_fraction", [](P& p) { p.target_fraction = nan; }},
        BadParameter{"NegativeError", "max_error", [](P& p) { p.max_error = -1.0; }},
        BadParameter{"ErrorNan", "max_error", [](P& p) { p.max_error = nan; }},
        BadParameter{"ErrorInfinite", "max_error", [](P& p) { p.max_error = infinity; }},
        BadParameter{"BoundaryWeightNan", "boundary_weight", [](P& p) { p.boundary_weight = nan; }},
        BadParameter{"BoundaryWeightNegative", "boundary_weight",
                     [](P& p) { p.boundary_weight = -1.0; }},
        BadParameter{"NormalAngleNan", "normal_angle", [](P& p) { p.normal_angle = nan; }},
        BadParameter{"NormalAngleAbove", "normal_angle", [](P& p) { p.normal_angle = 181.0; }},
        BadParameter{"FeatureAngleNegative", "feature_angle", [](P& p) { p.feature_angle = -1.0; }},
        BadParameter{"FeatureAngleNan", "feature_angle", [](P& p) { p.feature_angle = nan; }},
        BadParameter{"AlphaNan", "alpha", [](P& p) { p.alpha = nan; }},
        BadParameter{"FloorAboveOne", "curvature_floor", [](P& p) { p.curvature_floor = 1.5; }},
        BadParameter{"FloorNan", "curvature_floor", [](P& p) { p.curvature_floor = nan; }},
        BadParameter{"LambdaNan", "lambda", [](P& p) { p.lambda = nan; }},
        BadParameter{"LambdaNegative", "lambda", [](P& p) { p.lambda = -1e-3; }},
        BadParameter{"PairDistanceNan", "pair_distance", [](P& p) { p.pair_distance = nan; }},
        BadParameter{"PairDistanceNegative", "pair_distance", [](P& p) { p.pair_distance = -1.0; }},
        BadParameter{"PairDistanceInfinite", "pair_distance",
                     [](P& p) { p.pair_distance = infinity; }},
        BadParameter{"NegativeThreads", "threads", [](P& p) { p.threads = -1; }},
        BadParameter{"NoTarget", "No target", [](P& p) { p.target_faces = P::no_target; }},
        BadParameter{"NothingSelected", "no face is selected",
                     [](P& p) { p.selected_only = true; }}),
    [](const testing::TestParamInfo<BadParameter>& parameter) {
      return std::string(parameter.param.name);
    });

TEST(GoodParameters, AtTheEndsOfTheirRangesAreTaken) {
  EdgeCollapseParams params = to_faces(40);
  for (double alpha : {-1e300, -1.0, 0.0, 1e300})
    for (double weight : {0.0, 1e100})
      for (double angle : {0.0, 180.0}) {
        params.alpha = alpha, params.boundary_weight = weight, params.feature_angle = angle;
        EXPECT_LE(decimated(plane_grid(8), params).shape.face_count(), 40)
            << alpha << ' ' << weight << ' ' << angle;
      }
}

// --- quality weights -----------------------------------------------------------------------------

EdgeCollapseParams weighted_by_quality() {
  EdgeCollapseParams params = to_faces(60);
  params.quality_weight = true;
  return params;
}

TEST(QualityWeight, AQualityThatIsNotFiniteIsNamed) {
  for (double bad : {nan, infinity}) {
    RichMesh mesh;
    fill_with_attributes(mesh, icosphere(1));
    mesh.vert[5].Q() = bad;
    expect_refused(mesh, weighted_by_quality(), {"vertex 5", "quality"});
  }
}

TEST(QualityWeight, AllZeroIsIgnoredAndSaid) {
  RichMesh plain, weighted;
  fill(plain, saddle(8));
  fill(weighted, saddle(8));
  for (RichMesh* mesh : {&plain, &weighted})
    for (RichVertex& v : mesh->vert) v.Q() = 0.0;
  decimate(plain, to_faces(60));
  const DecimationReport report = decimate(weighted, weighted_by_quality());
  EXPECT_EQ(shape_of(weighted), shape_of(plain));
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes[0].find("weight by quality has no effect"), std::string::npos);
}

TEST(QualityWeight, KeepsMoreFacesWhereItIsHigh) {
  RichMesh mesh;
  fill(mesh, icosphere(3));
  for (RichVertex& v : mesh.vert) v.Q() = v.cP()[2] > 0.0 ? 100.0 : 1.0;
  EdgeCollapseParams params = weighted_by_quality();
  params.target_faces = 300;
  decimate(mesh, params);
  const int upper = select_faces(mesh, [](const vcg::Point3d& centre) { return centre[2] > 0.0; });
  EXPECT_GT(upper, 2 * (mesh.fn - upper));
}

}  // namespace
}  // namespace curvdecim::test
