// SPDX-License-Identifier: GPL-3.0-or-later
// keep_map: which vertices of the input became which of the result, and which are nearest.
#include "vcg_ext/vertex_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "support/clustering.h"
#include "support/custom_mesh.h"
#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/expectations.h"
#include "support/properties.h"
#include "support/removal.h"

namespace curvdecim::test {
namespace {

using Allocator = vcg::tri::Allocator<RichMesh>;

/// To a share of the faces, with or without maps.
using Decimate = std::function<DecimationReport(RichMesh&, double share, bool keep_map)>;

template <class Params>
Params asked(double share, bool keep_map) {
  Params params;
  params.target_fraction = share;
  params.keep_map = keep_map;
  return params;
}

DecimationReport by_edge_collapse(RichMesh& mesh, double share, bool keep_map) {
  return decimate(mesh, asked<EdgeCollapseParams>(share, keep_map));
}
DecimationReport by_best_edge_collapse(RichMesh& mesh, double share, bool keep_map) {
  auto params = asked<EdgeCollapseParams>(share, keep_map);
  params.preset = Preset::Best;
  return decimate(mesh, params);
}
DecimationReport by_removal(RichMesh& mesh, double share, bool keep_map) {
  return remove(mesh, asked<VertexRemovalParams>(share, keep_map));
}
DecimationReport by_clustering(RichMesh& mesh, double share, bool keep_map) {
  return cluster(mesh, asked<ClusteringParams>(share, keep_map));
}

std::vector<int> result_vertices(RichMesh& mesh) {
  auto attribute = Allocator::FindPerMeshAttribute<std::vector<int>>(mesh, result_vertex);
  return Allocator::IsValidHandle<std::vector<int>>(mesh, attribute) ? attribute()
                                                                     : std::vector<int>();
}

std::vector<int> nearest_input_vertices(RichMesh& mesh) {
  auto attribute = Allocator::FindPerVertexAttribute<double>(mesh, nearest_input_vertex);
  std::vector<int> nearest;
  for (std::size_t v = 0; v < mesh.vert.size(); ++v)
    nearest.push_back(static_cast<int>(attribute[v]));
  return nearest;
}

class VertexMap : public testing::TestWithParam<Decimate> {};

TEST_P(VertexMap, EveryVertexOfTheInputWentIntoOneThatIsNear) {
  for (int level : {3, 6}) {  // 1,280 faces, and 81,920, of which the first go in passes
    const Shape before = unit_ball(level);
    CustomMesh mesh(before);
    GetParam()(mesh, 0.2, true);
    const std::vector<int> result = result_vertices(mesh);
    ASSERT_EQ(result.size(), before.vertices.size());
    const Shape after = shape_of(mesh);
    const double edge = std::sqrt(area(after) / after.face_count());
    for (std::size_t v = 0; v < result.size(); ++v) {
      ASSERT_GE(result[v], 0);
      ASSERT_LT(result[v], mesh.vn);
      EXPECT_LT((after.vertices[result[v]] - before.vertices[v]).norm(), 4.0 * edge);
    }
  }
}

TEST_P(VertexMap, EveryVertexOfTheResultHasSomeThatWentIntoIt) {
  CustomMesh mesh(unit_ball(4));
  GetParam()(mesh, 0.1, true);
  const std::vector<int> result = result_vertices(mesh);
  EXPECT_EQ(std::set<int>(result.begin(), result.end()).size(), mesh.vert.size());
}

TEST_P(VertexMap, TheNearestIsTheNearestOfAll) {
  const Shape before = rotated(unit_ball(3), 1.0, {1, 2, 3});
  CustomMesh mesh(before);
  GetParam()(mesh, 0.3, true);
  const std::vector<int> nearest = nearest_input_vertices(mesh);
  const Shape after = shape_of(mesh);
  for (std::size_t v = 0; v < nearest.size(); ++v) {
    const auto distance = [&](const Point& p) { return (p - after.vertices[v]).norm(); };
    double least = 1e9;
    for (const Point& p : before.vertices) least = std::min(least, distance(p));
    EXPECT_NEAR(distance(before.vertices.at(nearest[v])), least, 1e-12);
  }
}

TEST_P(VertexMap, ChangesNothingElse) {
  for (const Shape& shape : {unit_ball(4), plane_grid(20)}) {
    CustomMesh with(shape), without(shape);
    GetParam()(with, 0.2, true);
    GetParam()(without, 0.2, false);
    EXPECT_EQ(shape_of(with), shape_of(without));
    EXPECT_TRUE(result_vertices(without).empty());
    EXPECT_TRUE(without.vert_attr.empty());
  }
}

TEST_P(VertexMap, OfAMeshThatIsSmallEnoughIsEachVertexItself) {
  CustomMesh mesh(unit_ball(1));
  GetParam()(mesh, 1.0, true);
  const std::vector<int> result = result_vertices(mesh), nearest = nearest_input_vertices(mesh);
  ASSERT_EQ(result.size(), mesh.vert.size());
  for (int v = 0; v < mesh.vn; ++v) {
    EXPECT_EQ(result[v], v);
    EXPECT_EQ(nearest[v], v);
  }
}

TEST_P(VertexMap, OfTheSecondRunIsFromTheFirst) {
  CustomMesh mesh(unit_ball(4));
  GetParam()(mesh, 0.5, true);
  const int between = mesh.vn;
  GetParam()(mesh, 0.5, true);
  EXPECT_EQ(static_cast<int>(result_vertices(mesh).size()), between);
  for (int v : nearest_input_vertices(mesh)) EXPECT_LT(v, between);
}

INSTANTIATE_TEST_SUITE_P(Filters, VertexMap,
                         testing::Values(by_edge_collapse, by_best_edge_collapse, by_removal,
                                         by_clustering));

TEST(VertexMapOfRemoval, LeadsFromWhatStaysToItself) {
  const Shape before = unit_ball(3);
  CustomMesh mesh(before);
  by_removal(mesh, 0.2, true);
  const std::vector<int> result = result_vertices(mesh), nearest = nearest_input_vertices(mesh);
  const Shape after = shape_of(mesh);
  for (int v = 0; v < mesh.vn; ++v) {
    EXPECT_EQ(result[nearest[v]], v);
    EXPECT_EQ(before.vertices[nearest[v]], after.vertices[v]);
  }
}

TEST(VertexMapOfEdgeCollapse, HasNoneForAPartThatVanished) {
  Shape shape = side_by_side({unit_ball(4), unit_ball(0)});
  const int ball = unit_ball(4).vertex_count();
  for (std::size_t v = ball; v < shape.vertices.size(); ++v)
    shape.vertices[v] = 1e-4 * shape.vertices[v] + Point(2, 0, 0);
  CustomMesh mesh(shape);
  const DecimationReport report = by_edge_collapse(mesh, 0.02, true);
  ASSERT_EQ(report.parts_removed, 1);
  const std::vector<int> result = result_vertices(mesh);
  for (int v = 0; v < ball; ++v) EXPECT_GE(result[v], 0);
  for (std::size_t v = ball; v < result.size(); ++v) EXPECT_EQ(result[v], -1);
}

TEST(VertexMapOfEdgeCollapse, LeadsFromCopiesInOnePlaceToOnePlace) {
  Shape shape = plane_grid(20);
  const int vertices = shape.vertex_count();
  const std::vector<Point> points = shape.vertices;
  shape.vertices.insert(shape.vertices.end(), points.begin(), points.end());
  for (Corners& face : shape.faces)
    if ((points[face[0]] + points[face[1]] + points[face[2]]).x() > 1.5)
      for (int& v : face) v += vertices;  // the right half has vertices of its own
  CustomMesh mesh(shape);
  by_edge_collapse(mesh, 0.2, true);
  const std::vector<int> result = result_vertices(mesh);
  const Shape after = shape_of(mesh);
  int on_cut = 0;
  for (int v = 0; v < vertices; ++v) {
    if (points[v].x() != 0.5) continue;
    ++on_cut;
    EXPECT_EQ(after.vertices.at(result[v]), after.vertices.at(result[v + vertices]));
  }
  EXPECT_EQ(on_cut, 21);
}

TEST(VertexMapOfEdgeCollapse, IsTheSameOnAnyNumberOfThreads) {
  std::vector<std::vector<int>> maps;
  for (int threads : {1, 2, 3}) {
    CustomMesh mesh(unit_ball(6));
    auto params = asked<EdgeCollapseParams>(0.2, true);
    params.threads = threads;
    decimate(mesh, params);
    maps.push_back(result_vertices(mesh));
  }
  EXPECT_EQ(maps[0], maps[1]);
  EXPECT_EQ(maps[0], maps[2]);
}

TEST(VertexMapOfEdgeCollapse, LeadsFromVerticesOfNoFaceToThemselves) {
  Shape shape = unit_ball(3);
  shape.vertices.push_back({30, 40, 50});
  CustomMesh mesh(shape);
  by_edge_collapse(mesh, 0.2, true);
  const int last = mesh.vn - 1;
  EXPECT_EQ(result_vertices(mesh).back(), last);
  EXPECT_EQ(nearest_input_vertices(mesh)[last], shape.vertex_count() - 1);
}

}  // namespace
}  // namespace curvdecim::test
