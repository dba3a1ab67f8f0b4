// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/clustering/clusters.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/clustering.h"
#include "support/drawn_meshes.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// The origins of those that stay; face i has the origin 10 + i.
std::vector<int> origins(const std::vector<Face>& faces, int threads = 1) {
  Array<CellFace> all;
  for (std::size_t i = 0; i < faces.size(); ++i) all.push_back({faces[i], 10 + int(i)});
  std::vector<int> result;
  for (const CellFace& face : DistinctFaces(all, 12, Parallel(threads)).left()) {
    EXPECT_EQ(face.cells, faces[face.origin - 10]);
    result.push_back(face.origin);
  }
  return result;
}

TEST(DistinctFaces, KeepOneOfThreeCellsInWhateverOrder) {
  EXPECT_EQ(origins({{4, 2, 9}, {2, 9, 4}, {9, 4, 2}, {1, 2, 9}}), (std::vector<int>{10, 13}));
  EXPECT_EQ(origins({}), std::vector<int>());
}

TEST(DistinctFaces, KeepTheFirstOfTheMoreFrequentOrientation) {
  EXPECT_EQ(origins({{1, 2, 3}, {1, 3, 2}, {2, 1, 3}}), (std::vector<int>{11}));
  EXPECT_EQ(origins({{1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {1, 2, 3}}),
            (std::vector<int>{10}));  // as many: the first of all
}

TEST(DistinctFaces, StayInOrder) {
  EXPECT_EQ(origins({{7, 8, 9}, {1, 2, 3}, {7, 9, 8}, {9, 8, 7}, {1, 2, 4}, {1, 3, 2}}),
            (std::vector<int>{11, 12, 14}));
}

TEST(DistinctFaces, AreTheSameForAnyNumberOfThreads) {
  std::vector<Face> faces;
  for (int i = 0; i < 5000; ++i) {
    const int a = i * 7 % 12, b = i * 5 % 11, c = i / 3 % 12;
    if (a != b && b != c && c != a) faces.push_back({a, b, c});
  }
  const std::vector<int> one = origins(faces);
  EXPECT_GT(one.size(), 100u);
  EXPECT_LT(one.size(), 221u);  // there are 220 triples
  for (int threads : {2, 3, 5}) EXPECT_EQ(origins(faces, threads), one);
}

TEST(Clusters, OfOneCellHaveNoFace) {
  const FlatMesh mesh = flat_mesh(icosphere(2));
  const Clusters clusters = cluster(mesh, CellGrid::largest_diameter(mesh.half_size), Parallel(1));
  EXPECT_EQ(clusters.cells(), 1);
  EXPECT_TRUE(clusters.faces.empty());
  EXPECT_EQ(clusters.crossing, 0);
}

TEST(Clusters, OfTinyCellsAreTheMesh) {
  const Shape shape = icosphere(2);
  const Clusters clusters = cluster(flat_mesh(shape), 1e-3, Parallel(1));
  EXPECT_EQ(clusters.cells(), shape.vertex_count());
  ASSERT_EQ(clusters.faces.size(), shape.faces.size());
  for (int f = 0; f < shape.face_count(); ++f) {
    EXPECT_EQ(clusters.faces[f].origin, f);
    EXPECT_EQ(clusters.faces[f].cells, clusters.cells_of(shape.faces[f]));
  }
}

TEST(Clusters, AreTheSameForAnyNumberOfThreads) {
  const FlatMesh mesh = flat_mesh(noisy_sphere(5, 0.01));
  const Clusters one = cluster(mesh, 0.05, Parallel(1));
  for (int threads : {2, 3, 5}) {
    const Clusters many = cluster(mesh, 0.05, Parallel(threads));
    EXPECT_EQ(many.cell_of, one.cell_of);
    EXPECT_EQ(many.keys, one.keys);
    EXPECT_EQ(many.crossing, one.crossing);
    ASSERT_EQ(many.faces.size(), one.faces.size());
    for (std::size_t f = 0; f < one.faces.size(); ++f)
      EXPECT_EQ(many.faces[f].origin, one.faces[f].origin);
  }
}

TEST(Clusters, DoNotCountVerticesThatNoFaceUses) {
  Shape shape = icosphere(1);
  const int cells = cluster(flat_mesh(shape), 0.1, Parallel(1)).cells();
  shape.vertices.push_back({0.1, 0.2, 0.3});
  const Clusters clusters = cluster(flat_mesh(shape), 0.1, Parallel(1));
  EXPECT_EQ(clusters.cells(), cells);
  EXPECT_EQ(clusters.cell_of.back(), Clusters::none);
}

}  // namespace
}  // namespace curvdecim::test
