// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex removal of planes and boxes: there the right answer is known exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/removal.h"

namespace curvdecim::test {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

class RemovalOf : public testing::TestWithParam<RemovalVariant> {
 protected:
  Thinned to(const Shape& shape, int faces) const {
    return thinned(shape, GetParam().of(removal_to(faces)));
  }
};

TEST_P(RemovalOf, ASquareLeavesTwoFacesAndItsCornersToTheBit) {
  for (double turn : {0.0, 0.8}) {
    const Shape square = rotated(plane_grid(16), turn, {1, 2, 3});
    const auto [after, report] = to(square, 2);
    EXPECT_EQ(after.face_count(), 2);
    EXPECT_NEAR(area(after), 1.0, 1e-9);
    EXPECT_LE(report.max_error, 16 * epsilon);
    for (const Point& corner : rotated(two_triangles(), turn, {1, 2, 3}).vertices)
      EXPECT_TRUE(has_vertex(after, corner, 8 * epsilon));
  }
}

TEST_P(RemovalOf, APlaneLosesAllVerticesInsideBeforeItsOutline) {
  // The outline is a polygon of many corners, all of which are seen.
  const Shape disk = mapped(plane_grid(16), [](const Point& p) {
    const Point q = p - Point(0.5, 0.5, 0.0);
    const double square = std::max(std::abs(q.x()), std::abs(q.y()));
    return square > 0.0 ? Point(q * (square / q.norm())) : q;
  });
  const Shape after = to(disk, 62).shape;
  EXPECT_EQ(after.face_count(), 62);
  EXPECT_EQ(after.vertex_count(), 64);
  EXPECT_NEAR(area(after), area(disk), 1e-12);
}

TEST_P(RemovalOf, ADenseBoxEndsAsTwelveFaces) {
  const Point size(1, 2, 4);
  const auto [after, report] = to(dense_box(6, size), 12);
  EXPECT_EQ(after.face_count(), 12);
  EXPECT_NEAR(volume(after), size.prod(), 1e-9);
  EXPECT_LE(report.max_error, 64 * epsilon);
}

TEST_P(RemovalOf, ADenseBoxKeepsItsCornersAtAnyTarget) {
  const Point size(1, 1, 1);
  const auto [after, report] = to(dense_box(6, size), 0);
  EXPECT_EQ(report.stopped_by, StopReason::NothingLeft);
  EXPECT_EQ(after.face_count() == 12, GetParam().features);
}

TEST_P(RemovalOf, ACylinderIsThinnedAlongItsLength) {
  const Shape after = to(open_cylinder(16, 12), 32).shape;
  EXPECT_EQ(after.face_count(), 32);
  EXPECT_LE(two_sided_distance(open_cylinder(16, 12), after), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Each, RemovalOf, testing::ValuesIn(removal_variants()),
                         [](const testing::TestParamInfo<RemovalVariant>& each) {
                           return each.param.name;
                         });

TEST(Removal, OfASphereComesNearerTheMoreFacesItHas) {
  const Shape sphere = icosphere(4);
  const double coarse = two_sided_rms(sphere, thinned(sphere, removal_to(320)).shape);
  const double fine = two_sided_rms(sphere, thinned(sphere, removal_to(1280)).shape);
  EXPECT_GT(coarse, 2.5 * fine);  // error falls with the square of the edges' length: by 4
  EXPECT_LT(coarse, 8.0 * fine);
}

TEST(Removal, OfTheLeastDistanceFirstHasALowerErrorThanPasses) {
  for (const Shape& shape : {noisy_sphere(4, 0.01), bumpy_sphere(4), saddle(32)}) {
    VertexRemovalParams params = removal_to(shape.face_count() / 5);
    const double heap = two_sided_rms(shape, thinned(shape, params).shape);
    params.criterion = RemovalCriterion::Passes;
    EXPECT_LT(heap, two_sided_rms(shape, thinned(shape, params).shape));
  }
}

}  // namespace
}  // namespace curvdecim::test
