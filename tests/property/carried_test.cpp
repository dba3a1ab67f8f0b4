// SPDX-License-Identifier: GPL-3.0-or-later
// What a vertex or a face carries beside its colour, quality and texture: custom attributes,
// curvature directions, selections, marks of edges inside polygons.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "support/clustering.h"
#include "support/custom_mesh.h"
#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/removal.h"

namespace curvdecim::test {
namespace {

using Decimate = std::function<DecimationReport(RichMesh&)>;
using Allocator = vcg::tri::Allocator<RichMesh>;

DecimationReport by_edge_collapse(RichMesh& mesh) { return decimate(mesh, to_faces(100)); }
DecimationReport by_half_edges(RichMesh& mesh) {
  EdgeCollapseParams params = to_faces(100);
  params.preset = Preset::Custom;
  params.placement = Placement::HalfEdge;
  return decimate(mesh, params);
}
DecimationReport by_clustering(RichMesh& mesh) {
  ClusteringParams params;
  params.target_faces = 100;
  return cluster(mesh, params);
}

class Carried : public testing::TestWithParam<Decimate> {
 protected:
  Carried() : mesh_(plane_grid(20)) {}

  CustomMesh mesh_;
};

TEST_P(Carried, CustomNumbersAndPointsAreInterpolated) {
  auto number = Allocator::AddPerVertexAttribute<double>(mesh_, "number");
  auto single = Allocator::AddPerVertexAttribute<float>(mesh_, "single");
  auto where = Allocator::AddPerVertexAttribute<vcg::Point3d>(mesh_, "where");
  auto place = Allocator::AddPerVertexAttribute<vcg::Point2f>(mesh_, "place");
  for (RichVertex& v : mesh_.vert) {
    const vcg::Point3d p = v.cP();
    number[v] = affine(p), single[v] = static_cast<float>(affine(p));
    where[v] = p, place[v] = vcg::Point2f(static_cast<float>(p[0]), static_cast<float>(p[1]));
  }
  const DecimationReport report = GetParam()(mesh_);
  ASSERT_LT(mesh_.vn, 100);
  for (RichVertex& v : mesh_.vert) {
    EXPECT_NEAR(number[v], affine(v.cP()), 1e-6);
    EXPECT_NEAR(single[v], affine(v.cP()), 1e-6);
    EXPECT_LT((where[v] - v.cP()).Norm(), 1e-6);
    EXPECT_NEAR(place[v][1], v.cP()[1], 1e-6);
  }
  EXPECT_TRUE(report.notes.empty()) << report.notes[0];
}

TEST_P(Carried, CustomWholeNumbersAreThoseOfANearVertex) {
  auto column = Allocator::AddPerVertexAttribute<int>(mesh_, "column");
  auto is_left = Allocator::AddPerVertexAttribute<bool>(mesh_, "is left");
  for (RichVertex& v : mesh_.vert)
    column[v] = static_cast<int>(std::lround(20 * v.cP()[0])), is_left[v] = v.cP()[0] < 0.5;
  GetParam()(mesh_);
  for (RichVertex& v : mesh_.vert) {
    EXPECT_NEAR(column[v], 20 * v.cP()[0], 2.5);
    if (std::abs(v.cP()[0] - 0.5) < 0.15) continue;
    EXPECT_EQ(is_left[v], v.cP()[0] < 0.5);
  }
}

TEST_P(Carried, CustomAttributesOfOtherTypesStayAndAreNamed) {
  auto name = Allocator::AddPerVertexAttribute<std::string>(mesh_, "name");
  for (RichVertex& v : mesh_.vert) name[v] = std::to_string(v.cP()[0]);
  const DecimationReport report = GetParam()(mesh_);
  for (RichVertex& v : mesh_.vert) EXPECT_FALSE(name[v].empty());
  EXPECT_TRUE(std::any_of(report.notes.begin(), report.notes.end(), [](const std::string& note) {
    return note.find("('name') stay with the vertices") != std::string::npos;
  }));
}

TEST_P(Carried, CustomAttributesOfFacesStayWithThem) {
  auto number = Allocator::AddPerFaceAttribute<double>(mesh_, "number");
  auto name = Allocator::AddPerFaceAttribute<std::string>(mesh_, "name");
  for (RichFace& f : mesh_.face) number[f] = f.cQ(), name[f] = std::to_string(f.cQ());
  GetParam()(mesh_);
  for (RichFace& f : mesh_.face) {
    EXPECT_EQ(number[f], f.cQ());
    EXPECT_EQ(name[f], std::to_string(f.cQ()));
  }
}

TEST_P(Carried, CurvaturesAreInterpolatedAndTheirDirectionsAreThoseOfANearVertex) {
  for (RichVertex& v : mesh_.vert) {
    v.K1() = affine(v.cP()), v.K2() = 1.0 - affine(v.cP());
    v.PD1() = v.cP()[0] < 0.5 ? vcg::Point3d(1, 0, 0) : vcg::Point3d(0, 1, 0);
    v.PD2() = v.cP()[0] < 0.5 ? vcg::Point3d(0, 1, 0) : vcg::Point3d(-1, 0, 0);
  }
  GetParam()(mesh_);
  for (RichVertex& v : mesh_.vert) {
    EXPECT_NEAR(v.cK1(), affine(v.cP()), 1e-6);
    EXPECT_NEAR(v.cK2(), 1.0 - affine(v.cP()), 1e-6);
    EXPECT_EQ(std::abs(v.cPD1()[0]) + std::abs(v.cPD1()[1]), 1.0);  // of one, and no mean
    if (std::abs(v.cP()[0] - 0.5) < 0.15) continue;
    EXPECT_EQ(v.cPD1()[0], v.cP()[0] < 0.5 ? 1.0 : 0.0);
    EXPECT_EQ(v.cPD2()[0], v.cP()[0] < 0.5 ? 0.0 : -1.0);
  }
}

TEST_P(Carried, SelectionsAndUserBitsOfVerticesStayWhereTheyAre) {
  const int bit = RichVertex::NewBitFlag();
  for (RichVertex& v : mesh_.vert)
    if (v.cP()[0] < 0.5) v.SetS(), v.SetUserBit(bit);
  GetParam()(mesh_);
  for (RichVertex& v : mesh_.vert) {
    if (std::abs(v.cP()[0] - 0.5) < 0.15) continue;
    EXPECT_EQ(v.IsS(), v.cP()[0] < 0.5);
    EXPECT_EQ(v.IsUserBit(bit), v.cP()[0] < 0.5);
  }
  RichVertex::DeleteBitFlag(bit);
}

TEST_P(Carried, PolygonsAreTrianglesAfterwards) {
  for (std::size_t f = 0; f < mesh_.face.size(); ++f) mesh_.face[f].SetF(f % 3);
  const DecimationReport report = GetParam()(mesh_);
  for (const RichFace& f : mesh_.face) EXPECT_FALSE(f.IsAnyF());
  ASSERT_EQ(report.notes.size(), 1u);
  EXPECT_NE(report.notes[0].find("the result is of triangles"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Filters, Carried,
                         testing::Values(by_edge_collapse, by_half_edges, by_clustering));

DecimationReport by_removal(RichMesh& mesh) { return remove(mesh, removal_to(100)); }
DecimationReport by_clusters_that_keep_a_vertex(RichMesh& mesh) {
  ClusteringParams params;
  params.target_faces = 100;
  params.representative = Representative::Median;
  return cluster(mesh, params);
}

class CarriedWhereNothingMoves : public testing::TestWithParam<Decimate> {};

TEST_P(CarriedWhereNothingMoves, CustomAttributesKeepTheirBits) {
  CustomMesh mesh(plane_grid(20));
  auto where = Allocator::AddPerVertexAttribute<vcg::Point3d>(mesh, "where");
  for (RichVertex& v : mesh.vert) where[v] = v.cP();
  GetParam()(mesh);
  ASSERT_LT(mesh.vn, 100);
  for (RichVertex& v : mesh.vert) EXPECT_EQ(where[v], v.cP());
}

INSTANTIATE_TEST_SUITE_P(Filters, CarriedWhereNothingMoves,
                         testing::Values(by_half_edges, by_removal,
                                         by_clusters_that_keep_a_vertex));

}  // namespace
}  // namespace curvdecim::test
