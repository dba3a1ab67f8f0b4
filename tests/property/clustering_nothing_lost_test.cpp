// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex clustering: cancel, selection, attributes, bad input. What must be as it was, is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/clustering.h"
#include "support/drawn_meshes.h"
#include "support/fingerprint.h"
#include "support/properties.h"
#include "support/rich_mesh.h"

namespace curvdecim::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Shape unit_ball(int subdivisions) {
  return translated(scaled(icosphere(subdivisions), 0.5), {0.5, 0.5, 0.5});
}

bool is_left(const vcg::Point3d& p) { return p[0] < 0.5; }

std::multiset<std::string> unselected_faces(const RichMesh& mesh) {
  std::multiset<std::string> faces;
  for (const RichFace& f : mesh.face)
    if (!f.IsD() && !f.IsS()) faces.insert(bytes_of(f));
  return faces;
}

// --- cancel --------------------------------------------------------------------------------------

TEST(ClusteringCancel, AtAnyCallLeavesTheMeshAsItWas) {
  for (const ClusteringParams& params : {to_clusters(300), with_cells(0.1)}) {
    int calls = 0;
    RichMesh counted;
    fill_with_attributes(counted, unit_ball(4));
    cluster(counted, params, [&](int, const char*) { return ++calls > 0; });
    ASSERT_GT(calls, 2);
    for (int last = 1; last <= calls; ++last) {
      RichMesh mesh;
      fill_with_attributes(mesh, unit_ball(4));
      const std::string before = bytes_of(mesh);
      int call = 0;
      const ClusteringReport report =
          cluster(mesh, params, [&](int, const char*) { return ++call < last; });
      EXPECT_EQ(report.stopped_by, StopReason::Cancelled);
      EXPECT_EQ(report.faces, report.faces_before);
      EXPECT_EQ(report.max_error, 0.0);
      EXPECT_TRUE(bytes_of(mesh) == before) << "cancelled at call " << last;
      EXPECT_EQ(call, last) << "went on after it was cancelled";
    }
  }
}

// --- selection -----------------------------------------------------------------------------------

class ClusteringSelection : public testing::TestWithParam<NamedRepresentative> {
 protected:
  ClusteringParams params(ClusteringParams params) const {
    params.selected_only = true;
    return GetParam().of(params);
  }
};

TEST_P(ClusteringSelection, FacesOutsideAreTheSameToTheBit) {
  for (const Shape& shape : {plane_grid(24), unit_ball(4)})
    for (bool manifold : {false, true}) {
      RichMesh mesh;
      fill_with_attributes(mesh, shape);
      const int selected = select_faces(mesh, is_left), others = mesh.fn - selected;
      const std::multiset<std::string> before = unselected_faces(mesh);
      ClusteringParams p = params(with_cells(0.2));
      p.manifold_edges = manifold;
      cluster(mesh, p);
      EXPECT_EQ(unselected_faces(mesh), before);
      EXPECT_LT(mesh.fn - others, selected / 2);
      EXPECT_EQ(topology(shape_of(mesh)).unreferenced_vertices, 0);
    }
}

TEST_P(ClusteringSelection, MeetsTheRestWithoutAGap) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(4));
  select_faces(mesh, is_left);
  cluster(mesh, params(with_cells(0.2)));
  EXPECT_EQ(topology(shape_of(mesh)).boundary_loops, 0);
}

TEST_P(ClusteringSelection, TargetCountsTheSelectedFaces) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(4));
  const int selected = select_faces(mesh, is_left), others = mesh.fn - selected;
  const ClusteringReport report = cluster(mesh, params(to_clusters(selected / 3)));
  EXPECT_EQ(report.stopped_by, StopReason::Target);
  EXPECT_NEAR(mesh.fn - others, selected / 3, 0.02 * selected / 3);
}

INSTANTIATE_TEST_SUITE_P(All, ClusteringSelection, testing::ValuesIn(all_representatives()),
                         representative_name);

/// Faces outside stay even if they are good for nothing, and so do vertices that no face uses.
TEST(ClusteringSelection, BadElementsOutsideAreLeftAlone) {
  Shape shape = plane_grid(12);
  shape.vertices.push_back({nan, 2, 2});
  const int lonely = shape.vertex_count() - 1, corner = lonely - 1;
  shape.faces.push_back(shape.faces.back());
  shape.faces.push_back({lonely, lonely, corner});
  RichMesh mesh;
  fill_with_attributes(mesh, shape);
  select_faces(mesh, is_left);
  const std::multiset<std::string> before = unselected_faces(mesh);
  ClusteringParams params = with_cells(0.3);
  params.selected_only = true;
  cluster(mesh, params);
  EXPECT_EQ(unselected_faces(mesh), before);
}

// --- attributes ----------------------------------------------------------------------------------

class ClusteringAttributes : public testing::TestWithParam<NamedRepresentative> {
 protected:
  ClusteringAttributes() { fill_with_attributes(mesh_, plane_grid(20)); }

  RichMesh mesh_;
  const ClusteringParams params_ = GetParam().of(with_cells(0.25));
};

TEST_P(ClusteringAttributes, AffineInPositionAreExact) {
  constexpr double percent = 0.01;
  cluster(mesh_, params_);
  for (const RichVertex& v : mesh_.vert) {
    EXPECT_NEAR(v.cQ(), affine(v.cP()), percent);
    EXPECT_NEAR(v.cR(), affine(v.cP()), percent);
    EXPECT_NEAR(v.cT().u(), v.cP()[0], 1.0 / 1024);
    EXPECT_NEAR(v.cT().v(), v.cP()[1], 1.0 / 1024);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(v.cC()[k], affine_color(v.cP())[k], 255 * percent);
  }
}

TEST_P(ClusteringAttributes, WedgeCoordinatesFollowThePlane) {
  cluster(mesh_, params_);
  for (const RichFace& f : mesh_.face)
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(f.cWT(i).u(), f.cP(i)[0], 1.0 / 1024);
      EXPECT_NEAR(f.cWT(i).v(), f.cP(i)[1], 1.0 / 1024);
    }
}

/// The right half lies in a chart of its own, on a page of its own.
TEST_P(ClusteringAttributes, WedgeCoordinatesOfTwoChartsDoNotMix) {
  for (RichFace& f : mesh_.face) {
    const bool right = (f.cP(0)[0] + f.cP(1)[0] + f.cP(2)[0]) / 3.0 > 0.5;
    for (int i = 0; i < 3 && right; ++i) f.WT(i).u() += 10.0, f.WT(i).n() = 1;
  }
  const ClusteringReport report = cluster(mesh_, params_);
  int right = 0;
  for (const RichFace& f : mesh_.face) {
    right += f.cWT(0).n() == 1;
    for (int i = 0; i < 3; ++i) {
      const double u = f.cWT(i).u() - (f.cWT(0).n() == 1 ? 10.0 : 0.0);
      EXPECT_EQ(f.cWT(i).n(), f.cWT(0).n());
      EXPECT_GE(u, f.cWT(0).n() == 1 ? 0.5 : 0.0);
      EXPECT_LE(u, f.cWT(0).n() == 1 ? 1.0 : 0.5);
    }
  }
  EXPECT_GT(right, 10);
  EXPECT_LT(right, mesh_.fn - 10);
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes[0].find("seams"), std::string::npos) << report.notes[0];
}

TEST_P(ClusteringAttributes, WedgeCoordinatesOfOneChartDoNotTear) {
  cluster(mesh_, params_);
  std::map<const RichVertex*, std::pair<double, double>> seen;
  for (const RichFace& f : mesh_.face)
    for (int i = 0; i < 3; ++i) {
      const std::pair<double, double> uv(f.cWT(i).u(), f.cWT(i).v());
      EXPECT_EQ(seen.try_emplace(f.cV(i), uv).first->second, uv);
    }
}

TEST_P(ClusteringAttributes, OfAFaceAreThoseOfAFaceOfTheInput) {
  cluster(mesh_, params_);
  std::set<double> seen;
  for (const RichFace& f : mesh_.face) {
    const int was = static_cast<int>(f.cQ());
    EXPECT_EQ(f.cC(), vcg::Color4b(static_cast<unsigned char>(was % 256),
                                   static_cast<unsigned char>(was / 256), 1, 255));
    EXPECT_TRUE(seen.insert(f.cQ()).second);
  }
}

TEST_P(ClusteringAttributes, NormalsFitTheFacesAfterwards) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(4));
  cluster(mesh, GetParam().of(with_cells(0.2)));
  for (const RichFace& f : mesh.face) {
    const vcg::Point3d normal = ((f.cP(1) - f.cP(0)) ^ (f.cP(2) - f.cP(0))).Normalize();
    ASSERT_LT((f.cN() - normal).Norm(), 1e-9);
  }
  for (const RichVertex& v : mesh.vert) ASSERT_NEAR(v.cN().Norm(), 1.0, 1e-12);
}

TEST_P(ClusteringAttributes, ThatAreNotFiniteDoNotSpread) {
  if (GetParam().name == "MeanByQuality") return;  // refused by name, see below
  for (int v : {3, 130, 300}) mesh_.vert[v].Q() = nan;
  cluster(mesh_, params_);
  EXPECT_LE(std::count_if(mesh_.vert.begin(), mesh_.vert.end(),
                          [](const RichVertex& v) { return std::isnan(v.cQ()); }),
            3);
}

INSTANTIATE_TEST_SUITE_P(All, ClusteringAttributes, testing::ValuesIn(all_representatives()),
                         representative_name);

TEST(ClusteringCustomAttributes, StayWithTheirVerticesAndFacesAndItIsSaid) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(3));
  auto at = vcg::tri::Allocator<RichMesh>::AddPerVertexAttribute<vcg::Point3d>(mesh, "where");
  auto number = vcg::tri::Allocator<RichMesh>::AddPerFaceAttribute<double>(mesh, "number");
  for (RichVertex& v : mesh.vert) at[v] = v.cP();
  for (RichFace& f : mesh.face) number[f] = f.cQ();
  ClusteringParams params = with_cells(0.2);
  params.representative = Representative::Median;
  const ClusteringReport report = cluster(mesh, params);
  for (const RichVertex& v : mesh.vert) EXPECT_EQ(at[v], v.cP());
  for (const RichFace& f : mesh.face) EXPECT_EQ(number[f], f.cQ());
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes[0].find("Custom"), std::string::npos);
  vcg::tri::Allocator<RichMesh>::DeletePerVertexAttribute(mesh, "where");
  vcg::tri::Allocator<RichMesh>::DeletePerFaceAttribute(mesh, "number");
}

TEST(ClusteringElements, DeletedOnesDoNotCount) {
  RichMesh mesh, clean;
  fill(clean, unit_ball(3));
  Shape shape = unit_ball(3);
  shape.vertices.push_back({7, 8, 9});
  shape.faces.insert(shape.faces.begin() + 5, Corners{0, 1, shape.vertex_count() - 1});
  fill(mesh, shape);
  vcg::tri::Allocator<RichMesh>::DeleteFace(mesh, mesh.face[5]);
  vcg::tri::Allocator<RichMesh>::DeleteVertex(mesh, mesh.vert.back());
  cluster(mesh, with_cells(0.2)), cluster(clean, with_cells(0.2));
  EXPECT_EQ(shape_of(mesh), shape_of(clean));
  EXPECT_EQ(mesh.vn, static_cast<int>(mesh.vert.size()));
  EXPECT_EQ(mesh.fn, static_cast<int>(mesh.face.size()));
}

TEST(ClusteringElements, AdjacencyOfTheHostDoesNotDangle) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(2));
  vcg::tri::UpdateTopology<RichMesh>::VertexFace(mesh);
  vcg::tri::UpdateTopology<RichMesh>::FaceFace(mesh);
  cluster(mesh, with_cells(0.3));
  for (const RichVertex& v : mesh.vert) EXPECT_TRUE(v.cVFp() == nullptr);
  for (const RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(f.cFFp(i) == nullptr);
}

TEST(ClusteringElements, TheBoundingBoxFitsAfterwards) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(3));
  cluster(mesh, with_cells(0.3));
  vcg::Box3d box;
  for (const RichVertex& v : mesh.vert) box.Add(v.cP());
  EXPECT_EQ(mesh.bbox.min, box.min);
  EXPECT_EQ(mesh.bbox.max, box.max);
}

// --- bad input -----------------------------------------------------------------------------------

void expect_refused(RichMesh& mesh, const ClusteringParams& params,
                    const std::vector<std::string>& words) {
  const std::string before = bytes_of(mesh);
  try {
    cluster(mesh, params);
    ADD_FAILURE() << "was accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    for (const std::string& word : words)
      EXPECT_NE(message.find(word), std::string::npos) << message;
    EXPECT_EQ(message.back(), '.') << message;
  }
  EXPECT_TRUE(bytes_of(mesh) == before);
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
  expect_refused(mesh, with_cells(100.0), {"No face would be left", "CellSize"});
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
    testing::Values(B{"NegativeSize", "CellSize", [](P& p) { p.cell_size = -0.1; }},
                    B{"SizeNan", "CellSize", [](P& p) { p.cell_size = nan; }},
                    B{"SizeInfinite", "CellSize", [](P& p) { p.cell_size = infinity; }},
                    B{"SizeTooSmall", "CellSize", [](P& p) { p.cell_size = 1e-9; }},
                    B{"NoTarget", "No target", [](P& p) { p.cell_size = 0.0; }},
                    B{"NegativeFaces", "TargetFaceNum", [](P& p) { p.target_faces = -1; }},
                    B{"FractionAboveOne", "TargetPerc", [](P& p) { p.target_fraction = 1.01; }},
                    B{"FractionNan", "TargetPerc", [](P& p) { p.target_fraction = nan; }},
                    B{"WeightNan", "BoundaryWeight", [](P& p) { p.boundary_weight = nan; }},
                    B{"WeightNegative", "BoundaryWeight", [](P& p) { p.boundary_weight = -1.0; }},
                    B{"NegativeThreads", "Threads", [](P& p) { p.threads = -1; }}),
    [](const testing::TestParamInfo<B>& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace curvdecim::test
