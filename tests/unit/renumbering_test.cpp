// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/renumbering.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// An octahedron of which 2 was collapsed into 0.
WorkingMesh collapsed() {
  WorkingMesh mesh = working_mesh(octahedron());
  mesh.connectivity.count(mesh.connectivity.collapse(0, 2));
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f)
    if (mesh.connectivity.alive(f)) mesh.update_plane(f);
  return mesh;
}

TEST(Renumbering, ClosesTheGapsInTheOldOrder) {
  const Renumbering numbers(collapsed().connectivity);
  EXPECT_EQ(numbers.vertex(1), 1);
  EXPECT_EQ(numbers.vertex(2), Renumbering::gone);
  EXPECT_EQ(numbers.vertex(3), 2);
  std::vector<int> by_vertex = {0, 10, 20, 30, 40, 50}, none;
  numbers.vertices(by_vertex), numbers.vertices(none);
  EXPECT_EQ(by_vertex, (std::vector<int>{0, 10, 30, 40, 50}));
  EXPECT_TRUE(none.empty());
}

TEST(Renumbering, LeavesTheMeshTheSame) {
  const WorkingMesh before = collapsed();
  WorkingMesh after = before;
  after.renumber(Renumbering(before.connectivity));
  EXPECT_EQ(after.connectivity.face_slots(), before.connectivity.face_count());
  EXPECT_EQ(after.connectivity.vertex_slots(), before.connectivity.vertex_count());
  for (int f = 0; f < after.connectivity.face_slots(); ++f) {
    const int was = after.face_origin[f];
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(after.vertex_origin[after.connectivity.face(f)[i]],
                before.connectivity.face(was)[i]);
    EXPECT_EQ(after.plane[f].normal, before.plane[was].normal);
  }
  for (int v = 0; v < after.connectivity.vertex_slots(); ++v)
    EXPECT_EQ(after.position[v], before.position[after.vertex_origin[v]]);
}

TEST(Renumbering, RemembersTheFirstNumbersWhenRepeated) {
  WorkingMesh mesh = collapsed();
  mesh.renumber(Renumbering(mesh.connectivity));
  mesh.connectivity.count(mesh.connectivity.collapse(0, 1));
  mesh.renumber(Renumbering(mesh.connectivity));
  EXPECT_EQ(mesh.vertex_origin, (std::vector<int>{0, 3, 4, 5}));
}

TEST(Renumbering, MakesRoomBehindWhatIsThere) {
  WorkingMesh mesh = collapsed();
  mesh.vertex_origins = 6, mesh.face_origins = 10;
  const TriangleConnectivity before = mesh.connectivity;
  mesh.renumber(Renumbering(before, 2, 1));
  EXPECT_EQ(mesh.vertex_origin, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(mesh.face_origin, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 10}));
  EXPECT_EQ(mesh.vertex_origins, 8);
  EXPECT_EQ(mesh.face_origins, 11);
  EXPECT_EQ(mesh.connectivity.vertex_slots(), 8);
  EXPECT_FALSE(mesh.connectivity.alive(8));
  for (int f = 0; f < before.face_slots(); ++f)
    EXPECT_EQ(mesh.connectivity.face(f), before.face(f));
  mesh.connectivity.validate();
}

}  // namespace
}  // namespace curvdecim::test
