// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/passes/fan_collapse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "support/pass_surfaces.h"
#include "support/properties.h"
#include "vcg_ext/metric/constraint_quadrics.h"

namespace curvdecim::test {

using namespace detail;

namespace {

constexpr double no_limit = 1e300;

// --- the faces of a fan --------------------------------------------------------------------------

/// About the centre, with the wings at its first neighbour.
FanFaces faces_around(const PassSurface& surface, int v) {
  const FanLists fans = fans_of(surface);
  FanCorners corners;
  const int other = first_neighbour(surface, fans, v);
  EXPECT_TRUE(corners.gather(surface, fans, nothing_merged(surface), v, other));
  return {surface, corners, surface.position[v], Vector3::Zero()};
}

TEST(FanFaces, AddUpToTheMatrixAndTheAreaOfTheFaces) {
  const WorkingMesh mesh = working_mesh(bumpy_sphere(2));
  const PassSurface surface = surface_of(bumpy_sphere(2));
  for (int v = 0; v < surface.vertex_count(); ++v) {
    const FanFaces faces = faces_around(surface, v);
    Symmetric3 matrix;
    for (int f : mesh.connectivity.faces_of(v))
      matrix += plane_matrix(mesh.plane[f], PlaneWeight::Area);
    const Symmetric3 error = matrix - faces.matrix();
    for (double e : {error.xx, error.xy, error.xz, error.yy, error.yz, error.zz})
      EXPECT_NEAR(e, 0.0, 1e-6 * matrix.trace());
    const Vector3 area = area_vector_around(mesh, v);
    EXPECT_NEAR((faces.area() - area).norm(), 0.0, 1e-6 * area.norm());
  }
}

TEST(FanFaces, TellTheAreaOfTheWings) {
  const Shape disk = fan(5);
  const PassSurface surface = surface_of(disk);
  const int other = first_neighbour(surface, fans_of(surface), 0);
  Vector3 wings = Vector3::Zero();
  for (const Corners& face : disk.faces)
    if (std::count(face.begin(), face.end(), other) > 0) {
      const auto [a, b, c] = corners_of(disk, face);
      wings += area_vector(a, b, c);
    }
  EXPECT_NEAR((faces_around(surface, 0).area_of_wings() - wings).norm(), 0.0, 1e-6 * wings.norm());
}

TEST(FanFaces, CountByTheMeanOfTheirFactors) {
  const auto trace = [](float center, float around) {
    PassSurface surface = surface_of(fan(5));
    for (PassWeight& weight : surface.weight) weight.factor = around;
    surface.weight[0].factor = center;
    return faces_around(surface, 0).matrix().trace();
  };
  const double once = trace(1.0f, 1.0f);
  EXPECT_NEAR(trace(1.0f, 4.0f), 3.0 * once, 1e-6 * once);
  EXPECT_NEAR(trace(7.0f, 1.0f), 3.0 * once, 1e-6 * once);
}

// --- single edges --------------------------------------------------------------------------------

class Look : public testing::Test {
 protected:
  std::optional<Candidate> at(const Shape& shape, int a, int b, double limit = no_limit,
                              FaceLimits limits = {}) {
    const PassSurface surface = surface_of(shape);
    const FanLists fans = fans_of(surface);
    return FanCollapse(surface, fans, limits).look(a, b, nothing_merged(surface), limit);
  }
};

/// A grid of 6 x 6 cells has its inner vertices 24 and 25 in a row.
TEST_F(Look, CostsNothingInAPlane) {
  const Shape grid = plane_grid(6);
  const auto found = at(grid, 24, 25);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->cost, 0.0);
  EXPECT_NEAR(found->position.z(), 0.0, 1e-7);
}

TEST_F(Look, RefusesWhatCostsMoreThanTheLimit) {
  const Shape ball = icosphere(2);
  const int b = ball.faces[0][1], a = ball.faces[0][0];
  const auto found = at(ball, a, b);
  ASSERT_TRUE(found.has_value());
  EXPECT_GT(found->cost, 0.0);
  EXPECT_TRUE(at(ball, a, b, found->cost).has_value());
  EXPECT_FALSE(at(ball, a, b, 0.99 * found->cost).has_value());
}

TEST_F(Look, KeepsTheVolume) {
  const Shape ball = icosphere(2);
  const int a = ball.faces[0][0], b = ball.faces[0][1];
  const auto found = at(ball, a, b);
  ASSERT_TRUE(found.has_value());
  Shape after = ball;
  after.vertices[a] = after.vertices[b] = found->position;
  EXPECT_NEAR(volume(after), volume(ball), 1e-5 * volume(ball));
}

TEST_F(Look, RefusesAThirdCommonNeighbour) {
  EXPECT_FALSE(at(tetrahedron(), 0, 1).has_value());
  EXPECT_FALSE(at(octahedron(), octahedron().faces[0][0], octahedron().faces[0][1]).has_value());
}

TEST_F(Look, RefusesEdgesOfTheBorder) { EXPECT_FALSE(at(plane_grid(6), 1, 8).has_value()); }

/// The vertices 24 and 25 and the others of a grid, of which one stands so that its faces lie the
/// other way round when both meet in the middle.
TEST_F(Look, RefusesToTurnAFaceOver) {
  Shape grid = plane_grid(6);
  const double step = 1.0 / 6.0;
  grid.vertices[31] += Vector3(-0.45 * step, -0.96 * step, 0.0);
  grid.vertices[32] += Vector3(-0.55 * step, -0.97 * step, 0.0);
  int refused = 0, turned = 0;
  FaceLimits any;
  any.keeps_normal = false;
  for (const Corners& face : grid.faces)
    for (int i = 0; i < 3; ++i) {
      const int a = face[i], b = face[(i + 1) % 3];
      const bool possible = at(grid, a, b, no_limit, any).has_value();
      refused += !at(grid, a, b).has_value() && possible;
      if (const auto found = at(grid, a, b)) {
        Shape after = grid;
        after.vertices[a] = after.vertices[b] = found->position;
        for (const Corners& f : after.faces) {
          const auto t = corners_of(after, f), was = corners_of(grid, f);
          turned += area_vector(t[0], t[1], t[2]).dot(area_vector(was[0], was[1], was[2])) < 0.0;
        }
      }
    }
  EXPECT_GT(refused, 0);
  EXPECT_EQ(turned, 0);
}

/// Two neighbours of a that share a face with it, away from b.
std::pair<int, int> edge_opposite(const Shape& shape, int a, int b) {
  const auto is_near_b = [&](int v) {
    return std::any_of(shape.faces.begin(), shape.faces.end(), [&](const Corners& face) {
      return std::count(face.begin(), face.end(), v) > 0 &&
             std::count(face.begin(), face.end(), b) > 0;
    });
  };
  for (const Corners& face : shape.faces)
    for (int i = 0; i < 3; ++i)
      if (const int v = face[(i + 1) % 3], u = face[(i + 2) % 3];
          face[i] == a && !is_near_b(v) && !is_near_b(u))
        return {v, u};
  return {-1, -1};
}

TEST_F(Look, SeesNeighboursThatHaveMergedInThisPass) {
  const Shape ball = icosphere(2);
  PassSurface surface = surface_of(ball);
  const FanLists fans = fans_of(surface);
  const int a = 0, b = first_neighbour(surface, fans, a);
  std::vector<int> into = nothing_merged(surface);
  const FaceLimits limits;
  const auto before = FanCollapse(surface, fans, limits).look(a, b, into, no_limit);
  const auto [left, right] = edge_opposite(ball, a, b);
  into[right] = left;
  const auto after = FanCollapse(surface, fans, limits).look(a, b, into, no_limit);
  ASSERT_TRUE(before && after);
  EXPECT_NE(before->position, after->position);
}

}  // namespace
}  // namespace curvdecim::test
