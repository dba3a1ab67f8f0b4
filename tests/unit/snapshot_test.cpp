// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/snapshot.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/drawn_meshes.h"
#include "support/mesh_types.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

Snapshot snapshot_of(const Shape& shape) {
  BareMesh mesh;
  fill(mesh, shape);
  return take_snapshot(mesh, Parallel(1));
}

std::vector<int> sorted(std::vector<int> indices) {
  std::sort(indices.begin(), indices.end());
  return indices;
}

TEST(Snapshot, LiesInACentredBoxOfDiagonalOne) {
  const Snapshot snapshot =
      snapshot_of(translated(scaled(dense_box(2, {1, 2, 3}), 40.0), {5, 6, 7}));
  Shape inside{snapshot.mesh.position, {}};
  EXPECT_NEAR(diagonal(inside), 1.0, 1e-15);
  Point sum = Point::Zero();
  for (const Point& p : inside.vertices) sum += p;
  EXPECT_LT(sum.norm(), 1e-12);
  EXPECT_NEAR(snapshot.box.diagonal, 40.0 * std::sqrt(14.0), 1e-12);
}

TEST(Snapshot, KnowsTheWayBack) {
  const Shape shape = icosphere(1);
  const Snapshot snapshot = snapshot_of(shape);
  for (int v = 0; v < shape.vertex_count(); ++v)
    EXPECT_LT(
        (snapshot.box.to_user(snapshot.mesh.position[v]) - shape.vertices[snapshot.vertex_of[v]])
            .norm(),
        1e-15);
}

TEST(Snapshot, RefersToTheSameFacesInTheSameOrientation) {
  const Shape shape = torus(8, 6);
  const Snapshot snapshot = snapshot_of(shape);
  ASSERT_EQ(snapshot.mesh.connectivity.face_slots(), shape.face_count());
  for (int f = 0; f < shape.face_count(); ++f)
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(snapshot.vertex_of[snapshot.mesh.connectivity.face(f)[i]],
                shape.faces[snapshot.mesh.face_origin[f]][i]);
}

TEST(Snapshot, NumbersNeighboursInSpaceAlike) {
  const Snapshot snapshot = snapshot_of(renumbered(plane_grid(32), 1));
  const auto steps = [&](const std::vector<Vector3>& positions) {
    double sum = 0.0;
    for (std::size_t v = 1; v < positions.size(); ++v)
      sum += (positions[v] - positions[v - 1]).norm();
    return sum / static_cast<double>(positions.size());
  };
  constexpr double cell = 1.0 / 32;
  EXPECT_LT(steps(snapshot.mesh.position) * snapshot.box.diagonal, 2.0 * cell);
}

TEST(Snapshot, OfATwinKeepsTheFirstFace) {
  Shape shape = octahedron();
  shape.faces.insert(shape.faces.begin(), shape.faces[5]);
  const Snapshot snapshot = snapshot_of(shape);
  EXPECT_EQ(snapshot.unusable, (std::vector<int>{6}));
  EXPECT_EQ(std::count(snapshot.mesh.face_origin.begin(), snapshot.mesh.face_origin.end(), 0), 1);
}

TEST(Snapshot, LeavesOutDeletedAndUnusedElements) {
  BareMesh mesh;
  fill(mesh, side_by_side({one_triangle(), octahedron()}));
  vcg::tri::Allocator<BareMesh>::DeleteFace(mesh, mesh.face[0]);
  const Snapshot snapshot = take_snapshot(mesh, Parallel(1));
  EXPECT_EQ(snapshot.mesh.connectivity.face_count(), 8);
  EXPECT_EQ(sorted(snapshot.vertex_of), (std::vector<int>{3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(sorted(snapshot.mesh.face_origin), (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(Snapshot, NamesTheFacesThatCannotBeUsed) {
  Shape shape = octahedron();
  shape.faces.insert(shape.faces.begin(), {1, 1, 2});  // 0
  shape.faces.push_back(
      {shape.faces[1][1], shape.faces[1][0], shape.faces[1][2]});  // 9: face 1 turned over
  EXPECT_EQ(snapshot_of(shape).unusable, (std::vector<int>{0, 9}));
  EXPECT_EQ(snapshot_of(shape).mesh.connectivity.face_count(), 8);
}

TEST(Snapshot, ReadsTheSelection) {
  BareMesh mesh;
  fill(mesh, octahedron());
  mesh.face[3].SetS();
  const Snapshot snapshot = take_snapshot(mesh, Parallel(1));
  for (std::size_t f = 0; f < snapshot.selected.size(); ++f)
    EXPECT_EQ(snapshot.selected[f], snapshot.mesh.face_origin[f] == 3);
}

TEST(Snapshot, IsTheSameForAMeshScaledByAPowerOfTwo) {
  for (int exponent : {-1000, -60, 60, 900})
    EXPECT_EQ(snapshot_of(scaled(icosphere(1), std::ldexp(1.0, exponent))).mesh.position,
              snapshot_of(icosphere(1)).mesh.position);
}

}  // namespace
}  // namespace curvdecim::test
