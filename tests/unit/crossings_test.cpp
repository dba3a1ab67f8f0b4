// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/crossings.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

Shape two_spheres() {
  return scaled(side_by_side({icosphere(2), translated(icosphere(2), {0.3, 0.2, 0.1})}), 0.25);
}

std::vector<FacePair> by_all_pairs(const WorkingMesh& mesh) {
  std::vector<FacePair> pairs;
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f)
    for (int g = f + 1; g < mesh.connectivity.face_slots(); ++g)
      if (has_face(mesh, f) && has_face(mesh, g) &&
          faces_cross(f, mesh.triangle(f), g, mesh.triangle(g)))
        pairs.push_back({f, g});
  return pairs;
}

TEST(Crossings, AreThoseOfAllPairs) {
  WorkingMesh mesh = working_mesh(two_spheres());
  for (int removed : {0, 100}) {
    for (int f = 0; f < removed; ++f) mesh.connectivity.count(mesh.connectivity.remove_face(3 * f));
    const std::vector<FacePair> expected = by_all_pairs(mesh);
    EXPECT_GT(expected.size(), 10u);
    for (int threads : {1, 3})
      EXPECT_EQ(crossing_pairs(mesh, mesh.connectivity.face_slots(), Parallel(threads)), expected);
  }
}

TEST(Crossings, AreNoneInACleanMesh) {
  for (const Shape& shape : {icosphere(3), torus(24, 12), plane_grid(8), cube(), fan(9)}) {
    const WorkingMesh mesh = working_mesh(shape);
    EXPECT_TRUE(crossing_pairs(mesh, mesh.connectivity.face_slots(), Parallel(1)).empty());
  }
}

TEST(Crossings, NameEachFaceOnce) {
  EXPECT_EQ(faces_of({{1, 7}, {3, 7}, {7, 9}}), (std::vector<int>{1, 3, 7, 9}));
}

TEST(SingleBoxes, FollowAFaceThatMoved) {
  WorkingMesh mesh = working_mesh(scaled(icosphere(2), 0.25));
  SingleBoxes<WorkingMesh> boxes(mesh, mesh.connectivity.face_slots(), Parallel(1));
  const int moved = mesh.connectivity.face(0)[0];
  mesh.position[moved] *= -1.5;
  for (int place = 0; place < boxes.face_count(); ++place)
    if (mesh.connectivity.face_has(*boxes.faces_of(place).begin(), moved)) boxes.refit(place);
  EXPECT_FALSE(by_all_pairs(mesh).empty());
  EXPECT_EQ(crossing_pairs(boxes, Parallel(1)), by_all_pairs(mesh));
}

}  // namespace
}  // namespace curvdecim::test
