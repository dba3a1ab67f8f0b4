// SPDX-License-Identifier: GPL-3.0-or-later
// The target is met to the face, or the report says why not.
#include <gtest/gtest.h>

#include <cmath>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/mesh_group.h"
#include "support/rich_mesh.h"

namespace curvdecim::test {
namespace {

class TargetOf : public testing::TestWithParam<NamedShape> {};

TEST_P(TargetOf, FacesIsMetExactlyOrOneBelow) {
  const Shape& before = GetParam().shape;
  for (int target :
       {before.face_count() * 3 / 4, before.face_count() / 2, before.face_count() / 2 + 1}) {
    const auto [after, report] = decimated(before, to_faces(target));
    EXPECT_LE(after.face_count(), target);
    EXPECT_GE(after.face_count(), target - 1);
    EXPECT_EQ(report.stopped_by, StopReason::Target);
  }
}

TEST_P(TargetOf, FractionWinsOverFaces) {
  const Shape& before = GetParam().shape;
  EdgeCollapseParams params = to_faces(before.face_count() / 4);
  params.target_fraction = 0.5;
  const int half = before.face_count() / 2;
  const int faces = decimated(before, params).shape.face_count();
  EXPECT_LE(faces, half);
  EXPECT_GE(faces, half - 1);
}

TEST_P(TargetOf, VerticesIsMetExactly) {
  const Shape& before = GetParam().shape;
  EdgeCollapseParams params;
  params.target_vertices = before.vertex_count() * 2 / 3;
  const auto [after, report] = decimated(before, params);
  EXPECT_EQ(after.vertex_count(), params.target_vertices);
  EXPECT_EQ(report.stopped_by, StopReason::Target);
}

TEST_P(TargetOf, MoreThanThereIsLeavesTheMeshAlone) {
  const Shape& before = GetParam().shape;
  for (int target :
       {before.face_count(), before.face_count() + 1, DecimationParams::no_target - 1}) {
    const auto [after, report] = decimated(before, to_faces(target));
    EXPECT_EQ(after, before);
    EXPECT_FALSE(report.notes.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, TargetOf, testing::ValuesIn(manifold_meshes()), name_of);

/// An edge where many sheets meet takes a face of each.
TEST(Target, IsNotPassedWhereManySheetsMeet) {
  const Shape before = book(20, 8);
  for (Preset preset : {Preset::Fast, Preset::Balanced})
    for (int target : {1000, 300, 150, 100}) {
      EdgeCollapseParams params = to_faces(target);
      params.preset = preset;
      const auto [after, report] = decimated(before, params);
      EXPECT_LE(after.face_count(), target);
      EXPECT_GE(after.face_count(), target - 1);
    }
}

/// What is selected is what lies at the edges where all pages meet.
TEST(Target, IsPassedWhereOnlySuchEdgesAreLeft) {
  constexpr int pages = 20, cells = 8;
  RichMesh mesh;
  fill(mesh, book(pages, cells));
  const int selected = select_faces(
      mesh, [](const vcg::Point3d& p) { return std::hypot(p[0], p[1]) < 1.0 / cells; });
  EdgeCollapseParams params = to_faces(selected - pages - pages / 2);
  params.selected_only = true;
  const int before = mesh.fn;
  EXPECT_EQ(decimate(mesh, params).stopped_by, StopReason::Target);
  EXPECT_EQ(mesh.fn, before - 2 * pages);
}

TEST(Target, FractionOfOneLeavesTheMeshAlone) {
  EdgeCollapseParams params;
  params.target_fraction = 1.0;
  EXPECT_EQ(decimated(icosphere(1), params).shape, icosphere(1));
}

TEST(Target, CountsOnlyTheFacesThatStayWhenSomeAreRepairedAway) {
  Shape sphere = icosphere(2);
  const int good = sphere.face_count();
  for (int f : {3, 5, 7, 9}) sphere.faces.push_back(sphere.faces[f]);
  for (int target : {good + 2, good, good - 1}) {
    const auto [after, report] = decimated(sphere, to_faces(target));
    EXPECT_LE(after.face_count(), target);
    EXPECT_GE(after.face_count(), std::min(target - 1, good));
    EXPECT_EQ(report.faces, after.face_count());
  }
}

TEST(Target, ReachedByTheFloorOfAComponentIsSaid) {
  const auto [after, report] = decimated(tetrahedron(), to_faces(2));
  EXPECT_EQ(after, tetrahedron());
  EXPECT_EQ(report.stopped_by, StopReason::NothingLeft);
  EXPECT_FALSE(report.notes.empty());
}

}  // namespace
}  // namespace curvdecim::test
