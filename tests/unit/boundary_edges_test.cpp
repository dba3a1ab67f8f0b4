// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/clustering/boundary_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "support/clustering.h"
#include "support/drawn_meshes.h"
#include "support/mesh_group.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// Independent of the orientation: by counting all edges.
int count_boundary(const Shape& shape) {
  std::map<std::pair<int, int>, int> uses;
  for (const Corners& f : shape.faces)
    for (int i = 0; i < 3; ++i) ++uses[std::minmax(f[i], f[(i + 1) % 3])];
  int count = 0;
  for (const auto& [edge, faces] : uses) count += faces == 1;
  return count;
}

class BoundaryEdgesOf : public testing::TestWithParam<NamedShape> {};

TEST_P(BoundaryEdgesOf, AreThoseWithOneFace) {
  const Shape& shape = GetParam().shape;
  const std::vector<BoundaryEdge> edges = boundary_edges(flat_mesh(shape), Parallel(1));
  EXPECT_EQ(static_cast<int>(edges.size()), count_boundary(shape));
  for (const BoundaryEdge& edge : edges) {
    const Corners& face = shape.faces[edge.face];
    EXPECT_TRUE(std::count(face.begin(), face.end(), edge.a) &&
                std::count(face.begin(), face.end(), edge.b));
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, BoundaryEdgesOf, testing::ValuesIn(all_meshes()), name_of);

TEST_P(BoundaryEdgesOf, DoNotDependOnTheOrientation) {
  Shape shape = GetParam().shape;
  for (std::size_t f = 0; f < shape.faces.size(); f += 3)
    std::swap(shape.faces[f][0], shape.faces[f][1]);
  EXPECT_EQ(static_cast<int>(boundary_edges(flat_mesh(shape), Parallel(1)).size()),
            count_boundary(shape));
}

TEST(IsClosed, SaysWhetherEveryEdgeIsRunThroughBothWays) {
  const Parallel three_threads(3);
  EXPECT_TRUE(is_closed(flat_mesh(torus(40, 30)), three_threads));
  EXPECT_FALSE(is_closed(flat_mesh(plane_grid(30)), three_threads));
  Shape turned = torus(40, 30);
  std::swap(turned.faces[7][0], turned.faces[7][1]);
  EXPECT_FALSE(is_closed(flat_mesh(turned), three_threads));
}

TEST(OpenVertices, OfAClosedMeshAreNone) {
  const std::vector<bool> open = open_vertices(flat_mesh(torus(12, 8)));
  EXPECT_EQ(std::count(open.begin(), open.end(), true), 0);
}

}  // namespace
}  // namespace curvdecim::test
