// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/host_mesh/read_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/drawn_meshes.h"
#include "support/mesh_types.h"
#include "support/properties.h"
#include "support/touching.h"

namespace curvdecim::test {

using namespace detail;

namespace {

WorkingCopy copy_of(const Shape& shape) {
  BareMesh mesh;
  fill(mesh, shape);
  return read_mesh(mesh, false, Parallel(1));
}

std::vector<int> sorted(std::vector<int> indices) {
  std::sort(indices.begin(), indices.end());
  return indices;
}

TEST(WorkingCopy, LiesInACentredBoxOfDiagonalOne) {
  const WorkingCopy copy = copy_of(translated(scaled(dense_box(2, {1, 2, 3}), 40.0), {5, 6, 7}));
  Shape inside{copy.mesh.position, {}};
  EXPECT_NEAR(diagonal(inside), 1.0, 1e-15);
  Point sum = Point::Zero();
  for (const Point& p : inside.vertices) sum += p;
  EXPECT_LT(sum.norm(), 1e-12);
  EXPECT_NEAR(copy.box.diagonal, 40.0 * std::sqrt(14.0), 1e-12);
}

TEST(WorkingCopy, KnowsTheWayBack) {
  const Shape shape = icosphere(1);
  const WorkingCopy copy = copy_of(shape);
  for (int v = 0; v < shape.vertex_count(); ++v)
    EXPECT_LT((copy.box.to_user(copy.mesh.position[v]) - shape.vertices[copy.vertex_of[v]]).norm(),
              1e-15);
}

TEST(WorkingCopy, RefersToTheSameFacesInTheSameOrientation) {
  const Shape shape = torus(8, 6);
  const WorkingCopy copy = copy_of(shape);
  ASSERT_EQ(copy.mesh.connectivity.face_slots(), shape.face_count());
  for (int f = 0; f < shape.face_count(); ++f)
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(copy.vertex_of[copy.mesh.connectivity.face(f)[i]],
                shape.faces[copy.mesh.face_origin[f]][i]);
}

TEST(WorkingCopy, NumbersNeighboursInSpaceAlike) {
  const WorkingCopy copy = copy_of(renumbered(plane_grid(32), 1));
  const auto steps = [&](const std::vector<Vector3>& positions) {
    double sum = 0.0;
    for (std::size_t v = 1; v < positions.size(); ++v)
      sum += (positions[v] - positions[v - 1]).norm();
    return sum / static_cast<double>(positions.size());
  };
  constexpr double cell = 1.0 / 32;
  EXPECT_LT(steps(copy.mesh.position) * copy.box.diagonal, 2.0 * cell);
}

TEST(WorkingCopy, OfATwinKeepsTheFirstFace) {
  Shape shape = octahedron();
  shape.faces.insert(shape.faces.begin(), shape.faces[5]);
  const WorkingCopy copy = copy_of(shape);
  EXPECT_EQ(copy.unusable, (std::vector<int>{6}));
  EXPECT_EQ(std::count(copy.mesh.face_origin.begin(), copy.mesh.face_origin.end(), 0), 1);
}

TEST(WorkingCopy, KeepsOneFaceOfEachOrientation) {
  Shape shape = octahedron();
  const auto [a, b, c] = shape.faces[3];
  for (const Corners& again : {Corners{c, b, a}, Corners{b, c, a}, Corners{a, c, b}})
    shape.faces.push_back(again);  // 8: back to back with face 3, 9: as face 3, 10: as face 8
  const WorkingCopy copy = copy_of(shape);
  EXPECT_EQ(sorted(copy.unusable), (std::vector<int>{9, 10}));
  EXPECT_EQ(copy.mesh.connectivity.face_count(), 9);
}

TEST(WorkingCopy, LeavesOutDeletedAndUnusedElements) {
  BareMesh mesh;
  fill(mesh, side_by_side({one_triangle(), octahedron()}));
  vcg::tri::Allocator<BareMesh>::DeleteFace(mesh, mesh.face[0]);
  const WorkingCopy copy = read_mesh(mesh, false, Parallel(1));
  EXPECT_EQ(copy.mesh.connectivity.face_count(), 8);
  EXPECT_EQ(sorted(copy.vertex_of), (std::vector<int>{3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(sorted(copy.mesh.face_origin), (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(WorkingCopy, NamesTheFacesThatCannotBeUsed) {
  Shape shape = octahedron();
  shape.faces.insert(shape.faces.begin(), {1, 1, 2});  // 0
  shape.faces.push_back(
      {shape.faces[1][1], shape.faces[1][2], shape.faces[1][0]});  // 9: face 1 again
  EXPECT_EQ(copy_of(shape).unusable, (std::vector<int>{0, 9}));
  EXPECT_EQ(copy_of(shape).mesh.connectivity.face_count(), 8);
}

TEST(WorkingCopy, IsAManifoldWhereSheetsAreSeparated) {
  ASSERT_EQ(topology(pinched_voxels()).nonmanifold_edges, 1);
  for (const Shape& shape : {pinched_voxels(), soup_of(pinched_voxels()), boxes_at_an_edge(),
                             soup_of(boxes_at_a_face(true))}) {
    BareMesh mesh;
    fill(mesh, shape);
    const WorkingMesh apart =
        read_mesh(mesh, ReadingPlan{false, true, Sheets::AreSeparated}, Parallel(1)).mesh;
    EXPECT_TRUE(std::all_of(apart.kind.begin(), apart.kind.end(),
                            [](VertexKind kind) { return kind == VertexKind::Interior; }));
  }
}

TEST(WorkingCopy, KeepsSheetsTogetherOtherwise) {
  const WorkingCopy copy = copy_of(boxes_at_an_edge());
  EXPECT_EQ(copy.vertex_of.size(), 14u);
}

TEST(WorkingCopy, ReadsTheSelection) {
  BareMesh mesh;
  fill(mesh, octahedron());
  mesh.face[3].SetS();
  const WorkingCopy copy = read_mesh(mesh, false, Parallel(1));
  for (std::size_t f = 0; f < copy.selected.size(); ++f)
    EXPECT_EQ(copy.selected[f], copy.mesh.face_origin[f] == 3);
}

TEST(WorkingCopy, IsTheSameForAMeshScaledByAPowerOfTwo) {
  for (int exponent : {-1000, -60, 60, 900})
    EXPECT_EQ(copy_of(scaled(icosphere(1), std::ldexp(1.0, exponent))).mesh.position,
              copy_of(icosphere(1)).mesh.position);
}

}  // namespace
}  // namespace curvdecim::test
