// SPDX-License-Identifier: GPL-3.0-or-later
// Planes stay planes, boxes stay boxes: there the right answer is known exactly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Pose {  // of a mesh in space
  const char* name;
  double angle;
  Point axis, offset;
};

void PrintTo(const Pose& pose, std::ostream* out) { *out << pose.name; }

class FlatSquare : public testing::TestWithParam<Pose> {
 protected:
  Shape posed(const Shape& shape) const {
    return translated(rotated(shape, GetParam().angle, GetParam().axis), GetParam().offset);
  }
};

TEST_P(FlatSquare, EndsAsTwoFacesWithItsOutlineAndArea) {
  const Shape square = posed(plane_grid(16));
  const double reach = std::max(diagonal(square), GetParam().offset.norm());
  for (const Variant& variant : all_variants()) {
    SCOPED_TRACE(variant.name);
    const Shape two = decimated(square, variant.with_target(2)).shape;
    EXPECT_EQ(two.face_count(), 2);
    EXPECT_NEAR(area(two), 1.0, 1e-9 * reach);
    for (const Point& corner : posed(two_triangles()).vertices)
      EXPECT_TRUE(has_vertex(two, corner, 8 * epsilon * reach));
  }
}

TEST_P(FlatSquare, StaysInItsPlane) {
  const Shape square = posed(plane_grid(16));
  const Point normal = double_area(square, square.faces[0]).normalized();
  const double reach = std::max(diagonal(square), GetParam().offset.norm());
  for (const Variant& variant : all_variants()) {
    SCOPED_TRACE(variant.name);
    for (int target : {200, 20}) {
      const Shape after = decimated(square, variant.with_target(target)).shape;
      EXPECT_NEAR(area(after), 1.0, 1e-9 * reach);
      for (const Point& p : after.vertices)
        EXPECT_LE(std::abs(normal.dot(p - square.vertices[0])), 4 * epsilon * reach);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Poses, FlatSquare,
                         testing::Values(Pose{"Upright", 0.0, {0, 0, 1}, {0, 0, 0}},
                                         Pose{"Oblique", 0.8, {1, 2, 3}, {0, 0, 0}},
                                         Pose{"Offset", 0.0, {0, 0, 1}, {1000, -2000, 500}},
                                         Pose{"ObliqueAndOffset", 2.0, {-3, 1, 1}, {100, 20, -50}}),
                         [](const testing::TestParamInfo<Pose>& pose) {
                           return std::string(pose.param.name);
                         });

TEST(UprightSquare, KeepsItsPlaneAndOutlineToTheBit) {
  for (const Variant& variant : all_variants()) {
    SCOPED_TRACE(variant.name);
    const Shape after = decimated(plane_grid(16), variant.with_target(20)).shape;
    for (const Point& p : after.vertices) EXPECT_EQ(p.z(), 0.0);
    for (const Point& corner : two_triangles().vertices)
      EXPECT_TRUE(has_vertex(after, corner, 0.0));
  }
}

TEST(DenseBox, EndsAsTwelveFacesExactly) {
  const Point size(1, 2, 4);
  for (const Variant& variant : all_variants()) {
    const auto* quadrics = std::get_if<EdgeCollapseParams>(&variant.params);
    if (quadrics && quadrics->metric == Metric::CurvatureAdditive)
      continue;  // it pays for corners that others get free
    const auto* spheres = std::get_if<SphereParams>(&variant.params);
    if (spheres && spheres->placement == SpherePlacement::OnSphereAlongEdge)
      continue;  // as printed, a sphere at a corner is round
    SCOPED_TRACE(variant.name);
    const Shape after = decimated(dense_box(6, size), variant.with_target(12)).shape;
    EXPECT_EQ(after.face_count(), 12);
    EXPECT_NEAR(volume(after), size.prod(), 1e-9);
    for (int corner = 0; corner < 8; ++corner) {
      const Point p((corner & 1) * size.x(), (corner >> 1 & 1) * size.y(),
                    (corner >> 2) * size.z());
      EXPECT_TRUE(has_vertex(after, p, 8 * epsilon * size.norm()));
    }
  }
}

TEST(DenseBox, ObliqueKeepsItsVolume) {
  const Shape box = rotated(dense_box(6, {1, 2, 4}), 0.9, {1, 2, 3});
  const Shape after = decimated(box, to_faces(12)).shape;
  EXPECT_EQ(after.face_count(), 12);
  EXPECT_NEAR(volume(after), 8.0, 1e-9);
}

TEST(Annulus, KeepsBothItsOutlinesNearly) {
  const Shape ring = annulus(64, 8);
  const Shape after = decimated(ring, to_faces(160)).shape;
  EXPECT_NEAR(area(after), area(ring), 0.01 * area(ring));
  EXPECT_EQ(topology(after).boundary_loops, 2);
}

TEST(HalfEdge, KeepsOriginalVerticesBitForBit) {
  for (const Shape& shape :
       {noisy_sphere(3, 0.02), rotated(saddle(16), 1.0, {1, 2, 3}), open_cylinder(32, 10)}) {
    EdgeCollapseParams params = to_faces(shape.face_count() / 5);
    params.preset = Preset::Custom;
    params.placement = Placement::HalfEdge;
    const Shape after = decimated(shape, params).shape;
    for (const Point& p : after.vertices)
      ASSERT_EQ(std::count(shape.vertices.begin(), shape.vertices.end(), p), 1);
  }
}

}  // namespace
}  // namespace curvdecim::test
