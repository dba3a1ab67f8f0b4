// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex removal: what no criterion may change, on every mesh.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/drawn_meshes.h"
#include "support/mesh_group.h"
#include "support/properties.h"
#include "support/removal.h"
#include "support/removal_record.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

class RemovalOnAnyMesh : public testing::TestWithParam<NamedShape> {};

TEST_P(RemovalOnAnyMesh, KeepsTheTopology) {
  const Shape& before = GetParam().shape;
  const Topology expected = topology(before);
  for (const RemovalVariant& variant : removal_variants())
    for (int target : {before.face_count() / 4, 0}) {
      SCOPED_TRACE(variant.name + " to " + std::to_string(target));
      const Shape after = thinned(before, variant.of(removal_to(target))).shape;
      EXPECT_PRED2(keeps_topology, expected, topology(after));
      EXPECT_LT(after.face_count(), before.face_count());
    }
}

TEST_P(RemovalOnAnyMesh, LeavesVerticesOfTheInputOnlyToTheBit) {
  const Shape& before = GetParam().shape;
  for (const RemovalVariant& variant : removal_variants())
    for (const Point& p :
         thinned(before, variant.of(removal_to(before.face_count() / 3))).shape.vertices)
      ASSERT_GE(std::count(before.vertices.begin(), before.vertices.end(), p), 1) << variant.name;
}

TEST_P(RemovalOnAnyMesh, GivesTheSameBitsAgain) {
  const Shape& before = GetParam().shape;
  for (const RemovalVariant& variant : removal_variants()) {
    const VertexRemovalParams params = variant.of(removal_to(before.face_count() / 3));
    EXPECT_EQ(thinned(before, params).shape, thinned(before, params).shape) << variant.name;
  }
}

TEST_P(RemovalOnAnyMesh, WorksInSinglePrecisionToo) {
  const Shape& before = GetParam().shape;
  EXPECT_PRED2(keeps_topology, topology(before),
               topology(thinned_float(before, removal_to(before.face_count() / 3)).shape));
}

TEST_P(RemovalOnAnyMesh, ReportsWhatItDid) {
  const Shape& before = GetParam().shape;
  for (const RemovalVariant& variant : removal_variants()) {
    SCOPED_TRACE(variant.name);
    const auto [after, report] = thinned(before, variant.of(removal_to(before.face_count() / 2)));
    EXPECT_EQ(report.faces_before, before.face_count());
    EXPECT_EQ(report.faces, after.face_count());
    EXPECT_EQ(report.vertices, after.vertex_count());
    EXPECT_EQ(report.stopped_by == StopReason::Target,
              after.face_count() <= before.face_count() / 2);
    EXPECT_TRUE(report.stopped_by == StopReason::Target ||
                report.notes.back().find("no vertex is left") != std::string::npos);
  }
}

/// Removes all that may go, in the order of the numbers, then takes it all back.
TEST_P(RemovalOnAnyMesh, IsUndoneToTheBitByInsertion) {
  RemovalRecord record;
  RemovalOn removal(GetParam().shape, {}, {&record});
  const WorkingMesh before = removal.mesh;
  for (int v = 0; v < before.connectivity.vertex_slots(); ++v)
    if (const RemovalAnswer answer = removal.ask(v); !answer.refusal) removal.remove(answer);
  ASSERT_GT(record.size(), before.position.size() / 10);
  EXPECT_EQ(removal.mesh.connectivity.vertex_count() + static_cast<int>(record.size()),
            before.connectivity.vertex_count());
  while (record.size() > 0) record.insert_last(removal.mesh);
  EXPECT_EQ(removal.mesh.connectivity.face_count(), before.connectivity.face_count());
  EXPECT_EQ(removal.mesh.connectivity.vertex_count(), before.connectivity.vertex_count());
  for (int f = 0; f < before.connectivity.face_slots(); ++f) {
    ASSERT_EQ(removal.mesh.connectivity.face(f), before.connectivity.face(f));
    ASSERT_EQ(removal.mesh.plane[f].normal, before.plane[f].normal);
    ASSERT_EQ(removal.mesh.plane[f].area, before.plane[f].area);
  }
  for (int v = 0; v < before.connectivity.vertex_slots(); ++v) {
    const IndexRange now = removal.mesh.connectivity.faces_of(v),
                     was = before.connectivity.faces_of(v);
    ASSERT_TRUE(std::equal(now.begin(), now.end(), was.begin(), was.end())) << v;
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, RemovalOnAnyMesh, testing::ValuesIn(all_meshes()), name_of);

class RemovalOnManifold : public testing::TestWithParam<NamedShape> {};

TEST_P(RemovalOnManifold, TurnsNoFaceOver) {
  const Shape& before = GetParam().shape;
  for (const RemovalVariant& variant : removal_variants())
    EXPECT_EQ(flipped_faces(before,
                            thinned(before, variant.of(removal_to(before.face_count() / 4))).shape),
              0)
        << variant.name;
}

TEST_P(RemovalOnManifold, ReachesHalfOfTheFaces) {
  const Shape& before = GetParam().shape;
  for (RemovalCriterion criterion : {RemovalCriterion::Heap, RemovalCriterion::Passes})
    for (int target : {before.face_count() * 3 / 4, before.face_count() / 2}) {
      VertexRemovalParams params = removal_to(target);
      params.criterion = criterion;
      const auto [after, report] = thinned(before, params);
      EXPECT_LE(after.face_count(), target);
      EXPECT_GE(after.face_count(), target - 1);
      EXPECT_EQ(report.stopped_by, StopReason::Target);
    }
}

TEST_P(RemovalOnManifold, MeetsANumberOfVerticesExactly) {
  const Shape& before = GetParam().shape;
  VertexRemovalParams params;
  params.target_vertices = before.vertex_count() * 2 / 3;
  EXPECT_EQ(thinned(before, params).shape.vertex_count(), params.target_vertices);
}

TEST_P(RemovalOnManifold, LeavesTheMeshAloneAtATargetThatIsNotBelow) {
  const Shape& before = GetParam().shape;
  const auto [after, report] = thinned(before, removal_to(before.face_count()));
  EXPECT_EQ(after, before);
  EXPECT_FALSE(report.notes.empty());
}

INSTANTIATE_TEST_SUITE_P(Drawn, RemovalOnManifold, testing::ValuesIn(manifold_meshes()), name_of);

class RemovalOnClosed : public testing::TestWithParam<NamedShape> {};

TEST_P(RemovalOnClosed, LeavesAtLeastATetrahedronAComponent) {
  VertexRemovalParams params = removal_to(0);
  params.preserve_normal = false;
  const auto [after, report] = thinned(GetParam().shape, params);
  EXPECT_GE(after.face_count(), 4 * topology(GetParam().shape).components);
  EXPECT_EQ(report.stopped_by, StopReason::NothingLeft);
  EXPECT_NE(report.notes.back().find(std::to_string(after.face_count())), std::string::npos)
      << report.notes.back();
}

INSTANTIATE_TEST_SUITE_P(Drawn, RemovalOnClosed, testing::ValuesIn(closed_meshes()), name_of);

// --- the bound, measured independently -----------------------------------------------------------

class RemovalBoundOn : public testing::TestWithParam<NamedShape> {};

TEST_P(RemovalBoundOn, IsKeptAllOverBothSurfaces) {
  const Shape& before = GetParam().shape;
  for (const RemovalVariant& variant : removal_variants())
    for (double fraction : {2e-3, 2e-2}) {
      SCOPED_TRACE(variant.name + " within " + std::to_string(fraction));
      const VertexRemovalParams params = variant.of(removal_within(fraction * diagonal(before)));
      const auto [after, report] = thinned(before, params);
      EXPECT_LE(sampled_distance(before, after), report.max_error * (1.0 + 1e-9) + 1e-9);
      EXPECT_LE(report.max_error, params.distance_bound);
      EXPECT_NE(report.stopped_by, StopReason::Target);
    }
}

TEST_P(RemovalBoundOn, IsReportedWithATargetToo) {
  const Shape& before = GetParam().shape;
  const auto [after, report] = thinned(before, removal_to(before.face_count() / 4));
  EXPECT_LE(sampled_distance(before, after), report.max_error * (1.0 + 1e-9) + 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Drawn, RemovalBoundOn,
                         testing::Values(NamedShape{"bumpy_sphere", bumpy_sphere(3)},
                                         NamedShape{"noisy_sphere", noisy_sphere(2, 0.05)},
                                         NamedShape{"saddle", saddle(16)},
                                         NamedShape{"torus", torus(24, 12)},
                                         NamedShape{"open_cylinder", open_cylinder(24, 8)},
                                         NamedShape{"capped_cylinder", capped_cylinder(24, 6)},
                                         NamedShape{"annulus", annulus(32, 4)},
                                         NamedShape{"small_holes", grid_with_small_holes(12)},
                                         NamedShape{"moebius_strip", moebius_strip(30, 6)},
                                         NamedShape{"three_pages", book(3, 8)},
                                         NamedShape{"two_components", large_and_small_sphere()}),
                         name_of);

/// No line splits the loop of a flat star, so that its middle, which costs nothing, is refused; its
/// corners, which go one by one, do not wake it each time.
TEST(RemovalOfAHub, IsSeldomTriedAgain) {
  Shape star = fan(60);
  for (int i = 1; i <= 60; i += 2) star.vertices[i] *= 0.5;
  DecimationReport report = thinned(star, removal_to(20)).report;
  EXPECT_EQ(report.faces, 20);
  EXPECT_EQ(report.rejected[Rejection::LoopSplit], 1);
}

TEST(RemovalBound, LeavesFewerFacesWhenItIsWider) {
  for (const Shape& before : {icosphere(3), noisy_sphere(3, 0.02), torus(24, 12), saddle(12)}) {
    const auto faces_within = [&](double fraction) {
      return thinned(before, removal_within(fraction * diagonal(before))).shape.face_count();
    };
    EXPECT_LT(faces_within(0.02), faces_within(0.001));
  }
}

/// Distances are summed with DistanceBound, and measured with MaxError.
TEST(RemovalBound, LeavesFewerFacesWhenItIsMeasured) {
  for (const Shape& before : {icosphere(3), noisy_sphere(3, 0.02), torus(24, 12), saddle(16)}) {
    const double distance = 0.01 * diagonal(before);
    VertexRemovalParams measured = removal_within(0.0);
    measured.max_error = distance;
    const auto [after, report] = thinned(before, measured);
    EXPECT_LT(after.face_count(), thinned(before, removal_within(distance)).shape.face_count());
    EXPECT_GT(report.max_error, 0.8 * distance);
    EXPECT_EQ(report.stopped_by, StopReason::ErrorBound);
  }
}

TEST(RemovalBound, OfMaxErrorAndDistanceBoundTheSmallerCounts) {
  for (const auto& [max_error, distance_bound] : {std::pair(0.01, 1.0), std::pair(1.0, 0.01)}) {
    VertexRemovalParams params = removal_within(distance_bound);
    params.max_error = max_error;
    const auto [after, report] = thinned(icosphere(3), params);
    EXPECT_LE(report.max_error, 0.01);
    EXPECT_EQ(report.stopped_by, StopReason::ErrorBound);
  }
}

}  // namespace
}  // namespace curvdecim::test
