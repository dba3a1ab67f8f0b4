// SPDX-License-Identifier: GPL-3.0-or-later
// The repository's sample meshes, and real meshes where they are at hand.
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include "support/decimation.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

constexpr Metric metrics[] = {Metric::Quadric, Metric::CurvatureWeighted,
                              Metric::CurvatureAdditive};
constexpr double kept = 0.2;

void expect_sound(const Shape& before) {
  const Topology expected = topology(before);
  for (Metric metric : metrics) {
    EdgeCollapseParams params;
    params.target_fraction = kept;
    params.metric = metric;
    params.preserve_topology = true;
    const auto [after, report] = decimated(before, params);
    EXPECT_PRED2(keeps_topology, expected, topology(after));
    EXPECT_EQ(report.stopped_by, StopReason::Target);
    EXPECT_LE(after.face_count(), kept * before.face_count());
    EXPECT_GE(after.face_count(), kept * before.face_count() - 2);
  }
}

class SampleMesh : public testing::TestWithParam<const char*> {};

TEST_P(SampleMesh, KeepsItsTopologyAndMeetsTheTarget) { expect_sound(sample_mesh(GetParam())); }

INSTANTIATE_TEST_SUITE_P(Files, SampleMesh,
                         testing::Values("plane_grid.ply", "icosphere.ply", "cylinder_open.ply",
                                         "cylinder_capped.ply", "cube_dense.ply", "torus.ply",
                                         "saddle.ply", "bumpy_sphere.ply", "two_spheres.ply",
                                         "fan.ply", "colored_patch.ply", "nonmanifold_edge.ply",
                                         "nonmanifold_vertex.ply", "moebius.ply"));

TEST(DirtySphere, IsRepaired) {
  const Shape before = sample_mesh("dirty_sphere.ply");
  ASSERT_GT(topology(before).duplicate_faces, 0);
  const auto [after, report] = decimated(before, to_faces(100));
  EXPECT_EQ(topology(after).duplicate_faces, 0);
  EXPECT_EQ(topology(after).faces_with_repeated_index, 0);
  EXPECT_LE(after.face_count(), 100);
  EXPECT_FALSE(report.notes.empty());
}

TEST(UnweldedCube, IsNotPerforatedSilently) {
  const Shape before = sample_mesh("unwelded_cube.ply");
  try {
    const auto [after, report] = decimated(before, to_faces(100));
    EXPECT_TRUE(area(after) > 0.999 * area(before) || !report.notes.empty());
  } catch (const InputError&) {  // refused with advice
  }
}

class RealMesh : public testing::TestWithParam<const char*> {};

TEST_P(RealMesh, KeepsItsTopologyAndMeetsTheTarget) {
  const std::optional<Shape> mesh = shared_mesh(GetParam());
  if (!mesh) GTEST_SKIP() << GetParam() << " is not here";
  expect_sound(*mesh);
}

INSTANTIATE_TEST_SUITE_P(Files, RealMesh, testing::Values("fandisk.obj", "rocker-arm.obj"));

}  // namespace
}  // namespace curvdecim::test
