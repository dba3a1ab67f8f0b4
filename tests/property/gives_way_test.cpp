// SPDX-License-Identifier: GPL-3.0-or-later
// Without PreserveTopology what is smaller than the error gives way, and a manifold stays one.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/expectations.h"
#include "support/mesh_group.h"
#include "support/properties.h"
#include "support/rich_mesh.h"

namespace curvdecim::test {
namespace {

EdgeCollapseParams keeping(int faces) {
  EdgeCollapseParams params = to_faces(faces);
  params.preserve_topology = true;
  return params;
}

class GivingWay : public testing::TestWithParam<NamedShape> {};

TEST_P(GivingWay, ReachesEveryTargetAsAManifold) {
  const Shape& before = GetParam().shape;
  const bool closed = topology(before).boundary_loops == 0;
  for (const Variant& variant : all_variants())
    for (int target : {before.face_count() / 4, 30, 4}) {
      SCOPED_TRACE(variant.name + " to " + std::to_string(target));
      const auto [after, report] = decimated(before, variant.with_target(target));
      const Topology t = topology(after);
      EXPECT_EQ(t.nonmanifold_edges + t.nonmanifold_vertices + t.inconsistent_edges, 0) << t;
      EXPECT_EQ(t.unreferenced_vertices + t.faces_with_repeated_index, 0) << t;
      if (closed) {
        EXPECT_EQ(t.boundary_loops, 0) << t;
      }
      EXPECT_GE(after.face_count(), std::min(target, before.face_count()) - 3);
      EXPECT_LE(after.face_count(), std::max(target, 4)) << report.handles_cut;
      EXPECT_TRUE(all_finite(after));
    }
}

INSTANTIATE_TEST_SUITE_P(Drawn, GivingWay, testing::ValuesIn(manifold_meshes()), name_of);

TEST(GivingWay, CutsTheHandleOfATorus) {
  const Shape before = torus(24, 12);
  const auto [after, report] = decimated(before, to_faces(4));
  EXPECT_GE(report.handles_cut, 1);  // and necks, whose far side vanishes
  EXPECT_EQ(topology(after).components, 1);
  EXPECT_EQ(topology(after).euler, 2);
  EXPECT_GT(report.largest_removed, 0.0);
  EXPECT_LT(report.largest_removed, diagonal(before));
  EXPECT_TRUE(is_said(report, std::to_string(report.handles_cut) + " handle"));
  EXPECT_EQ(topology(decimated(before, keeping(4)).shape).euler, 0);
}

TEST(GivingWay, KeepsAHandleThatIsLargerThanTheError) {
  const auto [after, report] = decimated(torus(48, 24), to_faces(400));
  EXPECT_EQ(report.handles_cut, 0);
  EXPECT_EQ(topology(after).euler, 0);
}

TEST(GivingWay, ClosesSmallHolesAndKeepsTheBorder) {
  const Shape before = grid_with_small_holes(16);
  const auto [after, report] = decimated(before, to_faces(2));
  EXPECT_EQ(report.holes_closed, 4);
  EXPECT_EQ(topology(after).boundary_loops, 1);
  EXPECT_EQ(topology(decimated(before, keeping(2)).shape).boundary_loops,
            topology(before).boundary_loops);
}

TEST(GivingWay, LetsTheSmallPartVanishFirst) {
  const Shape before =
      side_by_side({icosphere(3), scaled(translated(icosphere(2), {150.0, 0.0, 0.0}), 0.01)});
  const auto [after, report] = decimated(before, to_faces(100));
  EXPECT_EQ(report.parts_removed, 1);
  EXPECT_EQ(topology(after).components, 1);
  EXPECT_NEAR(report.largest_removed, 0.03, 0.01);
  EXPECT_TRUE(is_said(report, "1 part"));
  EXPECT_EQ(topology(decimated(before, keeping(100)).shape).components, 2);
}

TEST(GivingWay, KeepsThePartThatIsFarAndLarge) {
  const Shape before = side_by_side({icosphere(3), translated(icosphere(3), {10.0, 0.0, 0.0})});
  const auto [after, report] = decimated(before, to_faces(200));
  EXPECT_EQ(report.parts_removed, 0);
  EXPECT_EQ(topology(after).components, 2);
}

TEST(GivingWay, KeepsThePartWithALockedVertex) {
  const Shape before =
      side_by_side({icosphere(3), scaled(translated(icosphere(1), {150.0, 0.0, 0.0}), 0.01)});
  RichMesh mesh;
  fill(mesh, before);
  for (auto& face : mesh.face)
    if (face.P(0)[0] < 1.2) face.SetS();
  mesh.face.back().ClearS();
  EdgeCollapseParams params = to_faces(50);
  params.selected_only = true;
  EXPECT_EQ(decimate(mesh, params).parts_removed, 0);
}

TEST(GivingWay, PartsSheetsThatMeetWhereTheyAreInTheWay) {
  for (int pages : {3, 4, 5}) {
    SCOPED_TRACE(pages);
    const Shape before = book(pages, 12);
    const auto [after, report] = decimated(before, to_faces(pages - 1));  // they need not meet
    EXPECT_LE(after.face_count(), pages - 1);
    EXPECT_GT(report.junctions_parted, 0);
    EXPECT_EQ(report.stopped_by, StopReason::Target);
    EXPECT_TRUE(is_said(report, "junction"));
    EXPECT_LE(topology(after).nonmanifold_edges, topology(before).nonmanifold_edges);
    EXPECT_TRUE(all_finite(after));
  }
}

TEST(GivingWay, KeepsACurveWhileItIsWorthIt) {
  const Shape before = book(3, 12);
  const auto [after, report] = decimated(before, to_faces(before.face_count() / 4));
  EXPECT_EQ(report.junctions_parted, 0);
  EXPECT_GT(topology(after).nonmanifold_edges, 0);
  EXPECT_EQ(decimated(before, keeping(1)).report.junctions_parted, 0);
}

// --- nothing is gone yet, so that no number is free
// -----------------------------------------------

/// So many vertices in the unit cube, no four in a plane.
Shape vertices_on_a_curve(int count) {
  Shape shape;
  for (int i = 0; i < count; ++i) {
    const double t = double(i) / (count - 1);
    shape.vertices.push_back({t, t * t, t * t * t});
  }
  return shape;
}

/// All triangles of so many vertices.
Shape complete(int vertices) {
  Shape shape = vertices_on_a_curve(vertices);
  for (int a = 0; a < vertices; ++a)
    for (int b = a + 1; b < vertices; ++b)
      for (int c = b + 1; c < vertices; ++c) shape.faces.push_back({a, b, c});
  return shape;
}

/// The torus with the fewest vertices: every two are neighbours.
Shape torus_of_seven() {
  Shape shape = vertices_on_a_curve(7);
  for (int i = 0; i < 7; ++i) {
    shape.faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
    shape.faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return shape;
}

std::vector<Shape> without_free_numbers() {
  return {torus_of_seven(), complete(5), complete(6), complete(10), book(64, 1), book(65, 1)};
}

TEST(GivingWay, NeedsNothingToBeGoneBefore) {
  for (const Variant& variant : all_variants())
    for (const Shape& before : without_free_numbers()) {
      SCOPED_TRACE(variant.name + ", " + std::to_string(before.face_count()) + " faces");
      const auto [after, report] = decimated(before, variant.with_target(4));
      EXPECT_LE(after.face_count(), 4);
      EXPECT_GT(after.face_count(), 0);
      EXPECT_TRUE(all_finite(after));
    }
}

TEST(GivingWay, TakesNoPartWhereItCanPartSheets) {
  Shape many;
  for (int i = 0; i < 200; ++i)
    many = side_by_side({many, translated(complete(5), {2.0 * i, 0.0, 0.0})});
  const auto [after, report] = decimated(many, to_faces(many.face_count() / 2));
  EXPECT_EQ(after.face_count(), many.face_count() / 2);
  EXPECT_EQ(report.parts_removed, 0);
}

/// Vertices stay in their places, and what they carry is affine in the place.
TEST(GivingWay, GivesNewVerticesAndFacesWhatTheOldOnesCarry) {
  EdgeCollapseParams params;
  params.preset = Preset::Custom, params.placement = Placement::HalfEdge;
  for (const Shape& before : {torus_of_seven(), complete(6), complete(10)}) {
    RichMesh mesh;
    fill_with_attributes(mesh, before);
    params.target_faces = before.face_count() / 2;
    const DecimationReport report = decimate(mesh, params);
    EXPECT_EQ(report.stopped_by, StopReason::Target);
    EXPECT_GT(report.junctions_parted + report.handles_cut, 0);
    for (const RichVertex& v : mesh.vert) EXPECT_NEAR(v.cQ(), affine(v.cP()), 1e-6);
    for (const RichFace& face : mesh.face)
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(face.cWT(i).u(), face.cP(i)[0], 1e-6);
  }
}

TEST(GivingWay, IsOffWithABound) {
  EdgeCollapseParams params = to_faces(4);
  params.max_error = 100.0;
  const auto [after, report] = decimated(torus(24, 12), params);
  EXPECT_EQ(report.handles_cut, 0);
  EXPECT_EQ(topology(after).euler, 0);
}

TEST(GivingWay, TurnsNoFairFaceOver) {
  const Shape before = bumpy_sphere(3);
  EXPECT_EQ(flipped_faces(before, decimated(before, to_faces(300)).shape), 0);
}

TEST(GivingWay, LetsARodOfSliversComeDown) {
  const Shape rod = mapped(capped_cylinder(360, 1),
                           [](const Point& p) { return Point(p.x(), p.y(), 200.0 * p.z()); });
  const auto [after, report] = decimated(rod, to_faces(144));
  EXPECT_EQ(report.stopped_by, StopReason::Target);
  EXPECT_LT(two_sided_rms(rod, after), 1e-4 * diagonal(rod));
}

}  // namespace
}  // namespace curvdecim::test
