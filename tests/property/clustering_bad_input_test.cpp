// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex clustering: what it cannot take is refused with one clear message, and the mesh is as it
// was.
#include <gtest/gtest.h>

#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "support/clustering.h"
#include "support/drawn_meshes.h"
#include "support/expectations.h"

namespace curvdecim::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_refused(RichMesh& mesh, const ClusteringParams& params,
                    const std::vector<std::string>& words) {
  expect_refusal(
      mesh, [&] { cluster(mesh, params); }, words);
}

TEST(ClusteringBadMesh, EmptyIsRefused) {
  RichMesh mesh;
  expect_refused(mesh, with_cells(0.1), {"empty"});
}

TEST(ClusteringBadMesh, PointsWithoutFacesAreRefused) {
  RichMesh mesh;
  fill(mesh, {icosphere(0).vertices, {}});
  expect_refused(mesh, with_cells(0.1), {"12 points", "no faces"});
}

TEST(ClusteringBadMesh, AllFacesDeletedIsRefused) {
  RichMesh mesh;
  fill_with_attributes(mesh, octahedron());
  for (RichFace& f : mesh.face) vcg::tri::Allocator<RichMesh>::DeleteFace(mesh, f);
  expect_refused(mesh, with_cells(0.1), {"no faces"});
}

TEST(ClusteringBadMesh, NothingSelectedIsRefused) {
  RichMesh mesh;
  fill_with_attributes(mesh, octahedron());
  ClusteringParams params = with_cells(0.1);
  params.selected_only = true;
  expect_refused(mesh, params, {"no face is selected"});
}

TEST(ClusteringBadMesh, TheFirstCoordinateThatIsNotFiniteIsNamed) {
  for (double bad : {nan, infinity, -infinity}) {
    RichMesh mesh;
    fill_with_attributes(mesh, icosphere(1));
    mesh.vert[17].P()[1] = bad;
    expect_refused(mesh, with_cells(0.1), {"Vertex 17", "finite"});
  }
}

TEST(ClusteringBadMesh, AnIsolatedVertexThatIsNotFiniteDoesNotMatter) {
  RichMesh mesh;
  fill(mesh, icosphere(2));
  vcg::tri::Allocator<RichMesh>::AddVertex(mesh, {nan, infinity, 0.0});
  cluster(mesh, with_cells(0.5));
  EXPECT_EQ(shape_of(mesh), clustered(icosphere(2), with_cells(0.5)).shape);
}

TEST(ClusteringBadMesh, AFaceOfADeletedVertexIsNamed) {
  RichMesh mesh;
  fill_with_attributes(mesh, octahedron());
  mesh.vert[4].SetD();
  expect_refused(mesh, with_cells(0.1), {"Face 0", "does not exist"});
}

TEST(ClusteringBadMesh, OnlyFacesThatUseAVertexTwiceAreRefused) {
  RichMesh mesh;
  fill(mesh, {{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}, {0, 0, 1}}});
  expect_refused(mesh, with_cells(0.1), {"No face would be left"});
}

TEST(ClusteringBadMesh, AllInOnePointIsRefused) {
  RichMesh mesh;
  fill(mesh, scaled(octahedron(), 0.0));
  expect_refused(mesh, with_cells(0.1), {"one point"});
}

TEST(ClusteringBadMesh, CoordinatesTooLargeToSubtractAreRefused) {
  RichMesh mesh;
  fill(mesh, scaled(octahedron(), 1.7e308));
  expect_refused(mesh, with_cells(0.1), {"too large"});
}

TEST(ClusteringBadMesh, ThatWouldVanishIsRefused) {
  RichMesh mesh;
  fill_with_attributes(mesh, icosphere(1));
  expect_refused(mesh, with_cells(100.0), {"No face would be left", "cell_size"});
}

TEST(ClusteringBadMesh, AQualityThatIsNotFiniteIsNamed) {
  RichMesh mesh;
  fill_with_attributes(mesh, icosphere(1));
  mesh.vert[5].Q() = nan;
  ClusteringParams params = with_cells(0.1);
  params.quality_weight = true;
  expect_refused(mesh, params, {"vertex 5", "quality"});
  params = with_cells(0.1);
  params.representative = Representative::WeightedMean;
  params.mean_weight = MeanWeight::Quality;
  expect_refused(mesh, params, {"vertex 5", "quality"});
}

TEST(ClusteringBadMesh, FacesThatUseAVertexTwiceAndDuplicatesAreRemoved) {
  Shape shape = icosphere(1);
  shape.faces.push_back(shape.faces[3]);
  shape.faces.push_back({5, 5, 6});
  const auto [after, report] = clustered(shape, with_cells(1e-3));
  EXPECT_EQ(after, icosphere(1));
  EXPECT_EQ(report.duplicate, 1);
  EXPECT_EQ(report.degenerate, 1);
}

struct BadClusteringParameter {
  const char* name;
  const char* word;  // in the message
  void (*set)(ClusteringParams&);
};

void PrintTo(const BadClusteringParameter& parameter, std::ostream* out) { *out << parameter.name; }

class BadClusteringParameters : public testing::TestWithParam<BadClusteringParameter> {};

TEST_P(BadClusteringParameters, AreRefusedByName) {
  RichMesh mesh;
  fill_with_attributes(mesh, icosphere(1));
  ClusteringParams params = with_cells(0.1);
  GetParam().set(params);
  expect_refused(mesh, params, {GetParam().word});
}

using P = ClusteringParams;
using B = BadClusteringParameter;

INSTANTIATE_TEST_SUITE_P(
    Each, BadClusteringParameters,
    testing::Values(B{"NegativeSize", "cell_size", [](P& p) { p.cell_size = -0.1; }},
                    B{"SizeNan", "cell_size", [](P& p) { p.cell_size = nan; }},
                    B{"SizeInfinite", "cell_size", [](P& p) { p.cell_size = infinity; }},
                    B{"SizeTooSmall", "cell_size", [](P& p) { p.cell_size = 1e-9; }},
                    B{"NoTarget", "No target", [](P& p) { p.cell_size = 0.0; }},
                    B{"NegativeFaces", "target_faces", [](P& p) { p.target_faces = -1; }},
                    B{"FractionAboveOne", "target_fraction",
                      [](P& p) { p.target_fraction = 1.01; }},
                    B{"FractionNan", "target_fraction", [](P& p) { p.target_fraction = nan; }},
                    B{"WeightNan", "boundary_weight", [](P& p) { p.boundary_weight = nan; }},
                    B{"WeightNegative", "boundary_weight", [](P& p) { p.boundary_weight = -1.0; }},
                    B{"NegativeThreads", "threads", [](P& p) { p.threads = -1; }}),
    [](const testing::TestParamInfo<B>& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace curvdecim::test
