// SPDX-License-Identifier: GPL-3.0-or-later
// What PairDistance joins, what it leaves apart, and what it says.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/expectations.h"
#include "support/mesh_group.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

/// 4 x 4 x 4 balls of diameter 1, this far from each other.
Shape balls(double gap) {
  Shape all;
  for (int i = 0; i < 64; ++i)
    all = side_by_side({all, translated(scaled(icosphere(1), 0.5),
                                        (1.0 + gap) * Point(i % 4, i / 4 % 4, i / 16))});
  return all;
}

/// Two waved sheets above each other.
Shape two_sheets(double gap) {
  const Shape sheet = mapped(plane_grid(16), [](const Point& p) {
    return Point(p.x(), p.y(), 0.1 * std::sin(7.0 * p.x()) * std::cos(6.0 * p.y()));
  });
  return side_by_side({sheet, translated(sheet, {0.0, 0.0, gap})});
}

/// Two flat sheets that were never joined where they meet.
Shape cracked_sheet() {
  return side_by_side({plane_grid(12), translated(plane_grid(12), {1.0, 0.0, 0.0})});
}

EdgeCollapseParams joining(double distance, int faces) {
  EdgeCollapseParams params = to_faces(faces);
  params.pair_distance = distance;
  params.join_borders = false;  // pairs are to do it all
  return params;
}

TEST(PairDistance, JoinsSmallPartsOfWhichNoneMayVanish) {
  const Shape parts = balls(0.1);
  EdgeCollapseParams keeping = to_faces(100);
  keeping.preserve_topology = true;
  const DecimationReport alone = decimated(parts, keeping).report;
  ASSERT_EQ(alone.stopped_by, StopReason::NothingLeft);
  ASSERT_EQ(alone.faces, 64 * 4);
  const auto [after, report] = decimated(parts, joining(0.3, 100));
  EXPECT_EQ(report.stopped_by, StopReason::Target);
  EXPECT_LE(after.face_count(), 100);
  EXPECT_EQ(topology(after).components, 1);
}

TEST(PairDistance, HasLessErrorThanPartsThatVanish) {
  const Shape parts = balls(0.1);
  for (int faces : {200, 100, 60})
    EXPECT_LT(two_sided_rms(parts, decimated(parts, joining(0.3, faces)).shape),
              two_sided_rms(parts, decimated(parts, to_faces(faces)).shape))
        << faces;
}

TEST(PairDistance, JoinsSheetsThatAreCloser) {
  const auto [after, report] = decimated(two_sheets(1e-3), joining(1.5e-3, 300));
  EXPECT_EQ(topology(after).components, 1);
  EXPECT_GT(report.pairs_contracted, 50);
}

TEST(PairDistance, LeavesSheetsThatAreNotCloser) {
  const auto [after, report] = decimated(two_sheets(1e-3), joining(0.9e-3, 300));
  EXPECT_EQ(topology(after).components, 2);
  EXPECT_EQ(topology(after).boundary_loops, 2);
  EXPECT_EQ(report.pairs_contracted, 0);
}

TEST(PairDistance, ClosesACrackAndLeavesNoTrace) {
  const auto [after, report] = decimated(cracked_sheet(), joining(1e-6, 60));
  const Topology is = topology(after);
  EXPECT_EQ(is.components, 1);
  EXPECT_EQ(is.boundary_loops, 1);
  EXPECT_EQ(is.euler, 1);
  EXPECT_EQ(is.nonmanifold_vertices, 0);
  EXPECT_EQ(report.pairs_contracted, 13);
  EXPECT_LT(two_sided_distance(cracked_sheet(), after), 1e-12);
}

TEST(PairDistance, SaysWhatItDid) {
  const auto [after, report] = decimated(balls(0.1), joining(0.3, 400));
  ASSERT_GT(topology(after).nonmanifold_vertices, 0);
  EXPECT_TRUE(is_said(report, "the topology was not preserved"));
  EXPECT_TRUE(is_said(report, std::to_string(report.pairs_contracted) + " unconnected pairs"));
  EXPECT_FALSE(is_said(report, "and 0 vertices are non-manifold"));
}

TEST(PairDistance, SaysWhereNothingBecameNonManifold) {
  const DecimationReport report = decimated(cracked_sheet(), joining(1e-6, 60)).report;
  EXPECT_TRUE(is_said(report, "13 unconnected pairs"));
  EXPECT_FALSE(is_said(report, "seams do not close"));
  EXPECT_TRUE(is_said(report, "and 0 vertices are non-manifold"));
}

/// The corners of the small sheet have partners inside the large one, which merge first, for
/// nothing, into vertices that had none.
TEST(PairDistance, HandsOnThePairsOfMergedVertices) {
  const Shape small = translated(scaled(plane_grid(4), 0.5), {0.25, 0.25, 1e-3});
  EdgeCollapseParams params = joining(1.5e-3, 0);
  params.target_vertices = 6;
  const Shape before = side_by_side({plane_grid(8), small});
  const auto [after, report] = decimated(before, params);
  EXPECT_EQ(topology(after).components, 1);
  EXPECT_EQ(report.pairs_contracted, 2);
  EXPECT_LT(two_sided_distance(before, after), 0.2);  // of a sheet of width 1
}

TEST(PairDistance, MakesAJunctionAtOnce) {
  const Shape two = side_by_side({octahedron(), translated(octahedron(), {2.0 + 1e-6, 0.0, 0.0})});
  EdgeCollapseParams params = joining(1e-5, 0);
  params.target_vertices = two.vertex_count() - 1;
  const auto [after, report] = decimated(two, params);
  EXPECT_EQ(after.face_count(), two.face_count());
  EXPECT_EQ(topology(after).components, 1);
  EXPECT_EQ(topology(after).nonmanifold_vertices, 1);
  EXPECT_TRUE(is_said(report, "1 unconnected pairs were contracted, and 1 vertices"));
}

TEST(PairDistance, SaysNothingWhereItIsNotUsed) {
  const DecimationReport report = decimated(balls(0.1), to_faces(400)).report;
  EXPECT_FALSE(is_said(report, "pair_distance"));
  EXPECT_EQ(report.pairs_contracted, 0);
}

TEST(PairDistance, PromisesNotThatThereWillBeNoMoreNonManifoldPlaces) {
  const Shape shape = book(3, 8);
  EXPECT_TRUE(is_said(decimated(shape, to_faces(20)).report, "there will not be more"));
  EXPECT_FALSE(is_said(decimated(shape, joining(0.1, 20)).report, "there will not be more"));
}

TEST(PairDistance, IsRefusedTogetherWithABound) {
  RichMesh mesh;
  fill_with_attributes(mesh, icosphere(2));
  EdgeCollapseParams params = joining(0.1, 40);
  params.max_error = 0.1;
  expect_refusal(mesh, [&] { decimate(mesh, params); }, {"pair_distance", "max_error", "0"});
}

TEST(PairDistance, IsRefusedWhereItMeansTheWholeMesh) {
  RichMesh mesh;
  fill_with_attributes(mesh, icosphere(3));
  expect_refusal(mesh, [&] { decimate(mesh, joining(2.0, 40)); },
                 {"pair_distance", "64", "smaller"});
}

TEST(PairDistance, LeavesTheMeshWhenCancelled) {
  RichMesh mesh;
  fill_with_attributes(mesh, balls(0.1));
  const std::string before = bytes_of(mesh);
  int asked = 0;
  const DecimationReport report =
      decimate(mesh, joining(0.3, 60), [&](int, const char*) { return ++asked < 4; });
  EXPECT_EQ(report.stopped_by, StopReason::Cancelled);
  EXPECT_EQ(bytes_of(mesh), before);
}

TEST(PairDistance, JoinsWhatIsSelectedOnly) {
  RichMesh mesh;
  fill_with_attributes(mesh, scaled(balls(0.1), 0.25));
  const int selected = select_faces(mesh, is_left), others = mesh.fn - selected;
  const auto before = unselected_faces(mesh);
  EdgeCollapseParams params = joining(0.1, selected / 10);
  params.selected_only = true;
  const DecimationReport report = decimate(mesh, params);
  EXPECT_EQ(unselected_faces(mesh), before);
  EXPECT_LE(mesh.fn - others, selected / 10);
  EXPECT_GT(report.pairs_contracted, 0);
}

TEST(PairDistance, JoinsNothingToWhatIsNotSelected) {
  RichMesh mesh;
  fill_with_attributes(mesh, two_sheets(1e-3));
  const int half = mesh.fn / 2;
  for (int f = 0; f < half; ++f) mesh.face[f].SetS();
  const auto before = unselected_faces(mesh);
  EdgeCollapseParams params = joining(1.5e-3, half / 4);
  params.selected_only = true;
  EXPECT_EQ(decimate(mesh, params).pairs_contracted, 0);
  EXPECT_EQ(unselected_faces(mesh), before);
  EXPECT_LE(mesh.fn - half, half / 4);
}

/// Meshes of one part too: pairs across bends and holes.
class PairsOf : public testing::TestWithParam<NamedShape> {};

TEST_P(PairsOf, GiveASoundMeshWithEveryVariant) {
  const Shape& before = GetParam().shape;
  for (const Variant& variant : quadric_variants()) {
    SCOPED_TRACE(variant.name);
    auto params = std::get<EdgeCollapseParams>(variant.with_target(before.face_count() / 6));
    params.pair_distance = 0.05 * diagonal(before);
    const auto [after, report] = decimated(before, params);
    const Topology is = topology(after);
    EXPECT_TRUE(all_finite(after));
    EXPECT_EQ(is.duplicate_faces + is.faces_with_repeated_index + is.unreferenced_vertices, 0);
    EXPECT_EQ(is_said(report, "and 0 vertices are non-manifold"),
              is.nonmanifold_edges + is.nonmanifold_vertices == 0);
  }
}

std::vector<NamedShape> meshes_with_pairs() {
  std::vector<NamedShape> all = all_meshes();
  all.push_back({"balls", balls(0.1)});
  all.push_back({"two_sheets", two_sheets(1e-3)});
  all.push_back({"cracked_sheet", cracked_sheet()});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Drawn, PairsOf, testing::ValuesIn(meshes_with_pairs()), name_of);

// --- what must not matter ------------------------------------------------------------------------

TEST(PairDistance, ScalesWithTheMeshToTheBit) {
  const Shape parts = balls(0.1);
  const Shape expected = decimated(parts, joining(0.3, 150)).shape;
  for (int exponent : {-60, -7, 1, 60}) {
    const double factor = std::ldexp(1.0, exponent);
    EXPECT_EQ(decimated(scaled(parts, factor), joining(0.3 * factor, 150)).shape,
              scaled(expected, factor))
        << "2^" << exponent;
  }
}

TEST(PairDistance, GivesTheSameBitsWithAnyNumberOfThreads) {
  const Shape parts = balls(0.1);
  for (Scheduler scheduler : {Scheduler::Lazy, Scheduler::Eager, Scheduler::Rounds}) {
    EdgeCollapseParams params = joining(0.3, 150);
    params.preset = Preset::Custom, params.scheduler = scheduler, params.threads = 1;
    const Shape expected = decimated(parts, params).shape;
    for (int threads : {0, 2, 4}) {
      params.threads = threads;
      EXPECT_EQ(decimated(parts, params).shape, expected) << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace curvdecim::test
