// SPDX-License-Identifier: GPL-3.0-or-later
// A run that ends above its target says why, and what to change.
#include <gtest/gtest.h>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/expectations.h"
#include "support/mesh_group.h"
#include "support/removal.h"

namespace curvdecim::test {
namespace {

constexpr const char* above_target = "above the target";

/// As few faces as the guards allow.
EdgeCollapseParams to_the_end() { return to_faces(0); }

std::string told(const DecimationReport& report) {
  std::string all;
  for (const std::string& note : report.notes) all += note + '\n';
  return all;
}

class EndOfCollapse : public testing::TestWithParam<NamedShape> {};

TEST_P(EndOfCollapse, IsToldWhereTheTargetWasNotReachedAndOnlyThere) {
  for (bool keeps : {false, true})
    for (int target : {GetParam().shape.face_count() / 2, 4, 0}) {
      EdgeCollapseParams params = to_faces(target);
      params.preserve_topology = keeps;
      const DecimationReport report = decimated(GetParam().shape, params).report;
      EXPECT_EQ(is_said(report, above_target), report.stopped_by == StopReason::NothingLeft)
          << told(report);
      EXPECT_EQ(is_said(report, "refused because"), report.stopped_by == StopReason::NothingLeft)
          << told(report);
    }
}

INSTANTIATE_TEST_SUITE_P(Drawn, EndOfCollapse, testing::ValuesIn(all_meshes()), name_of);

TEST(EndOfCollapse, NamesTheTopologyThatIsKept) {
  EdgeCollapseParams params = to_faces(4);
  params.preserve_topology = true;
  const DecimationReport report = decimated(torus(24, 12), params).report;
  EXPECT_TRUE(is_said(report, "refused because the topology could change")) << told(report);
  EXPECT_TRUE(is_said(report, "switch off Preserve topology")) << told(report);
  params.preserve_topology = false;
  EXPECT_FALSE(is_said(decimated(torus(24, 12), params).report, above_target));
}

TEST(EndOfCollapse, NamesTheSheetsThatMeet) {
  EdgeCollapseParams params = to_faces(1);
  params.preserve_topology = true;
  const DecimationReport report = decimated(book(3, 1), params).report;
  EXPECT_TRUE(is_said(report, "vertices stay because of sheets or parts that meet there"))
      << told(report);
  EXPECT_TRUE(is_said(report, "switch off Preserve topology")) << told(report);
}

TEST(EndOfCollapse, SaysThatNothingGivesWayFurther) {
  const DecimationReport report = decimated(large_and_small_sphere(), to_the_end()).report;
  ASSERT_EQ(report.stopped_by, StopReason::NothingLeft);
  EXPECT_TRUE(is_said(report, "Preserve topology is off already")) << told(report);
}

TEST(EndOfCollapse, NamesTheBoundWhereTheTargetIsBeyondIt) {
  EdgeCollapseParams params = to_faces(4);
  params.max_error = 0.01;
  const DecimationReport report = decimated(icosphere(3), params).report;
  ASSERT_EQ(report.stopped_by, StopReason::ErrorBound);
  EXPECT_TRUE(is_said(report, above_target)) << told(report);
  EXPECT_TRUE(is_said(report, "raise Maximum error")) << told(report);
}

TEST(EndOfCollapse, IsAsAskedWhereThereIsABoundOnly) {
  EdgeCollapseParams params;
  params.max_error = 0.01;
  const DecimationReport report = decimated(icosphere(3), params).report;
  ASSERT_EQ(report.stopped_by, StopReason::ErrorBound);
  EXPECT_FALSE(is_said(report, above_target)) << told(report);
}

TEST(EndOfCollapse, SaysThatABoundKeepsTheTopology) {
  EdgeCollapseParams params = to_faces(4);
  params.max_error = 100.0;
  const DecimationReport report = decimated(torus(24, 12), params).report;
  ASSERT_EQ(report.stopped_by, StopReason::NothingLeft);
  EXPECT_TRUE(is_said(report, "Maximum error keeps the topology")) << told(report);
}

/// Runs to one face with the left half of a ball selected; its rim is at faces that are not.
template <class Params, class Run>
void expect_selection_told(Params params, Run run) {
  RichMesh mesh;
  fill(mesh, unit_ball(2));
  for (auto& face : mesh.face)
    if (is_left(face.P(0)) && is_left(face.P(1)) && is_left(face.P(2))) face.SetS();
  params.selected_only = true;
  const DecimationReport report = run(mesh, params);
  ASSERT_EQ(report.stopped_by, StopReason::NothingLeft);
  EXPECT_TRUE(is_said(report, "vertices stay because of faces there that are not selected"))
      << told(report);
}

TEST(EndOfCollapse, CountsTheVerticesThatASelectionHolds) {
  expect_selection_told(to_faces(1),
                        [](auto& mesh, const auto& params) { return decimate(mesh, params); });
}

class EndOfRemoval : public testing::TestWithParam<NamedShape> {};

TEST_P(EndOfRemoval, IsToldWhereTheTargetWasNotReachedAndOnlyThere) {
  for (const RemovalVariant& variant : removal_variants())
    for (int target : {GetParam().shape.face_count() * 3 / 4, 4}) {
      const DecimationReport report =
          thinned(GetParam().shape, variant.of(removal_to(target))).report;
      EXPECT_EQ(is_said(report, above_target), report.stopped_by == StopReason::NothingLeft)
          << variant.name << ": " << told(report);
    }
}

INSTANTIATE_TEST_SUITE_P(Drawn, EndOfRemoval, testing::ValuesIn(all_meshes()), name_of);

/// A long rod: each face of its side reaches from end to end.
Shape rod() {
  return mapped(capped_cylinder(360, 1),
                [](const Point& p) { return Point(p.x(), p.y(), 200.0 * p.z()); });
}

TEST(EndOfRemoval, NamesWhatElseReachesTheTargetOfACadPart) {
  for (const Shape& part : {rough_cones(200, 3), rod(), torus(24, 12)}) {
    const DecimationReport report = thinned(part, removal_to(4)).report;
    ASSERT_EQ(report.stopped_by, StopReason::NothingLeft);
    EXPECT_TRUE(is_said(report, "refused because no line parts the loop")) << told(report);
    EXPECT_TRUE(is_said(report, "on CAD parts, use Curvature-Enhanced Edge Collapse"))
        << told(report);
    EXPECT_EQ(decimated(part, to_faces(4)).report.stopped_by, StopReason::Target);
  }
}

TEST(EndOfRemoval, NamesTheTurnOfFaces) {
  VertexRemovalParams params = removal_to(4);
  params.normal_angle = 10.0;
  const DecimationReport report = thinned(icosphere(2), params).report;
  ASSERT_EQ(report.stopped_by, StopReason::NothingLeft);
  EXPECT_TRUE(is_said(report, "refused because a face would turn too far")) << told(report);
  EXPECT_TRUE(is_said(report, "raise Largest turn of a face")) << told(report);
}

TEST(EndOfRemoval, NamesTheBoundWhereTheTargetIsBeyondIt) {
  VertexRemovalParams params = removal_within(0.01);
  ASSERT_FALSE(is_said(thinned(icosphere(3), params).report, above_target));
  params.target_faces = 4;
  const DecimationReport report = thinned(icosphere(3), params).report;
  ASSERT_EQ(report.stopped_by, StopReason::ErrorBound);
  EXPECT_TRUE(is_said(report, "raise the bound")) << told(report);
}

TEST(EndOfRemoval, NamesTheTopologyThatIsKept) {
  const DecimationReport report = thinned(tetrahedron(), removal_to(0)).report;
  EXPECT_TRUE(is_said(report, "refused because the topology could change")) << told(report);
  EXPECT_TRUE(is_said(report, "always keeps the topology")) << told(report);
}

TEST(EndOfRemoval, SaysThatSharpEdgesAreHeld) {
  VertexRemovalParams params = removal_to(4);
  ASSERT_FALSE(is_said(thinned(cube(), params).report, "Preserve sharp edges"));
  params.preserve_features = true;
  const DecimationReport report = thinned(cube(), params).report;
  EXPECT_EQ(report.faces, 12);
  EXPECT_TRUE(is_said(report, "Preserve sharp edges and corners is on")) << told(report);
}

TEST(EndOfRemoval, CountsTheVerticesThatHaveTooManyFaces) {
  const DecimationReport report = thinned(rough_cones(200, 1), removal_to(4)).report;
  ASSERT_EQ(report.stopped_by, StopReason::NothingLeft);
  EXPECT_TRUE(is_said(report, "2 vertices stay because of more than 64 faces there"))
      << told(report);
}

TEST(EndOfRemoval, CountsTheVerticesThatASelectionHolds) {
  expect_selection_told(removal_to(1),
                        [](auto& mesh, const auto& params) { return remove(mesh, params); });
}

}  // namespace
}  // namespace curvdecim::test
