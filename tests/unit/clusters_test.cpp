// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/clustering/clusters.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/clustering.h"
#include "support/drawn_meshes.h"

namespace curvdecim::test {

using namespace detail;

namespace {

std::vector<int> origins(const CellFaceSet& set) {
  std::vector<int> result;
  for (int i = 0; i < set.size(); ++i) result.push_back(set.origin(i));
  return result;
}

TEST(CellFaceSet, KeepsOneOfThreeCellsInWhateverOrder) {
  CellFaceSet set;
  set.add({4, 2, 9}, 10), set.add({2, 9, 4}, 11), set.add({9, 4, 2}, 12), set.add({1, 2, 9}, 13);
  EXPECT_EQ(origins(set), (std::vector<int>{10, 13}));
  EXPECT_EQ(set.added(), 4);
}

TEST(CellFaceSet, KeepsTheFirstOfTheMoreFrequentOrientation) {
  CellFaceSet set;
  set.add({1, 2, 3}, 10), set.add({1, 3, 2}, 11), set.add({2, 1, 3}, 12);
  EXPECT_EQ(origins(set), (std::vector<int>{11}));
  set.add({1, 2, 3}, 13);
  EXPECT_EQ(origins(set), (std::vector<int>{10}));  // as many: the first of all
}

TEST(CellFaceSet, MergedIsAsIfAllCameToOne) {
  const std::vector<Face> faces = {{1, 2, 3}, {1, 3, 2}, {5, 6, 7},
                                   {3, 2, 1}, {7, 6, 5}, {2, 1, 3}};
  CellFaceSet all;
  for (int f = 0; f < 6; ++f) all.add(faces[f], f);
  for (int cut = 0; cut <= 6; ++cut) {
    CellFaceSet first, second;
    for (int f = 0; f < 6; ++f) (f < cut ? first : second).add(faces[f], f);
    first.merge(second);
    EXPECT_EQ(origins(first), origins(all)) << cut;
    EXPECT_EQ(first.added(), all.added());
  }
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
