// SPDX-License-Identifier: GPL-3.0-or-later
// One test a defect that was found, the smallest mesh that showed it.
#include <gtest/gtest.h>

#include <string>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

EdgeCollapseParams custom(int target, Quadrics quadrics, Placement placement) {
  EdgeCollapseParams params = to_faces(target);
  params.preset = Preset::Custom;
  params.quadrics = quadrics;
  params.placement = placement;
  return params;
}

/// Each collapse turned a face by less than the limit, several of them turned it over.
TEST(Regression, HalfEdgesOnASphereFoldNoFace) {
  EdgeCollapseParams params = custom(160, Quadrics::Accumulated, Placement::HalfEdge);
  params.metric = Metric::Quadric;
  EXPECT_EQ(flipped_faces(icosphere(2), decimated(icosphere(2), params).shape), 0);
}

/// The target lay between the faces given and the faces that can be used: nothing was repaired, and
/// the report claimed that the target was met.
TEST(Regression, ADuplicateFaceGoesThoughTheRestMeetsTheTarget) {
  Shape shape = two_triangles();
  shape.faces.push_back(shape.faces[0]);
  const auto [after, report] = decimated(shape, to_faces(2));
  EXPECT_EQ(after, two_triangles());
  EXPECT_EQ(report.faces, 2);
}

/// The pull towards the edge's midpoint dragged corners that were in the right place.
TEST(Regression, TheOptimumLeavesACornerOfASquareWhereItIs) {
  const EdgeCollapseParams params = custom(2, Quadrics::Accumulated, Placement::Optimal);
  const Shape after = decimated(plane_grid(2), params).shape;
  EXPECT_NEAR(area(after), 1.0, 1e-12);
}

/// Asking for the quality of a mesh type that has none aborted.
TEST(Regression, QualityWeightWithoutQualityIsSaid) {
  EdgeCollapseParams params = to_faces(20);
  params.quality_weight = true;
  const DecimationReport report = decimated(icosphere(1), params).report;
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes[0].find("weight by quality has no effect"), std::string::npos);
}

/// Whenever the rim of a fan changed, all edges of its hub were tried again, each against all faces
/// of the hub: 2 s for 1000 faces, 20 s for 2000.
TEST(Regression, AFanTakesNoCubicTime) {
  constexpr double generous_seconds =
      1.0;  // a few milliseconds, also under a sanitizer on a busy machine
  const auto [after, report] = decimated(fan(1500), to_faces(750));
  EXPECT_EQ(after.face_count(), 750);
  EXPECT_LT(report.seconds, generous_seconds);
}

}  // namespace
}  // namespace curvdecim::test
