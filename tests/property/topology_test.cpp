// SPDX-License-Identifier: GPL-3.0-or-later
// What no variant may change, on every mesh.
#include <gtest/gtest.h>

#include "support/decimation.h"
#include "support/mesh_group.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

class AnyMesh : public testing::TestWithParam<NamedShape> {};

TEST_P(AnyMesh, KeepsItsTopologyWithEveryVariant) {
  const Shape& before = GetParam().shape;
  const Topology expected = topology(before);
  for (const Variant& variant : all_variants())
    for (int target : {before.face_count() / 4, 0}) {
      SCOPED_TRACE(variant.name + " to " + std::to_string(target));
      AnyParams params = variant.with_target(target);
      shared(params).preserve_topology = true;
      const Shape after = decimated(before, params).shape;
      EXPECT_PRED2(keeps_topology, expected, topology(after));
      EXPECT_TRUE(all_finite(after));
      EXPECT_LT(after.face_count(), before.face_count());
    }
}

TEST_P(AnyMesh, GivesTheSameBitsAgain) {
  for (const Variant& variant : all_variants()) {
    SCOPED_TRACE(variant.name);
    const AnyParams params = variant.with_target(GetParam().shape.face_count() / 3);
    EXPECT_EQ(decimated(GetParam().shape, params).shape, decimated(GetParam().shape, params).shape);
  }
}

TEST_P(AnyMesh, IsDecimatedInSinglePrecisionToo) {
  const Topology expected = topology(GetParam().shape);
  const int target = GetParam().shape.face_count() / 3;
  for (AnyParams params : {AnyParams(to_faces(target)), AnyParams(spheres_to_faces(target))}) {
    shared(params).preserve_topology = true;
    EXPECT_PRED2(keeps_topology, expected,
                 topology(decimated_float(GetParam().shape, params).shape));
  }
}

TEST_P(AnyMesh, ReportsWhatItDid) {
  const Shape& before = GetParam().shape;
  const auto [after, report] = decimated(before, to_faces(before.face_count() / 2));
  EXPECT_EQ(report.faces_before, before.face_count());
  EXPECT_EQ(report.vertices_before, before.vertex_count());
  EXPECT_EQ(report.faces, after.face_count());
  EXPECT_EQ(report.vertices, after.vertex_count());
  EXPECT_GE(report.cost_last, 0.0);
  EXPECT_EQ(report.stopped_by == StopReason::Target, after.face_count() <= before.face_count() / 2);
}

INSTANTIATE_TEST_SUITE_P(Drawn, AnyMesh, testing::ValuesIn(all_meshes()), name_of);

class ManifoldMesh : public testing::TestWithParam<NamedShape> {};

TEST_P(ManifoldMesh, TurnsNoFaceOver) {
  const Shape& before = GetParam().shape;
  ASSERT_EQ(flipped_faces(before, before), 0);
  for (const Variant& variant : all_variants()) {
    SCOPED_TRACE(variant.name);
    EXPECT_EQ(flipped_faces(before,
                            decimated(before, variant.with_target(before.face_count() / 4)).shape),
              0);
  }
}

TEST_P(ManifoldMesh, StaysNearItself) {
  constexpr double near = 0.08;  // of the diagonal, at a quarter of very few faces
  const Shape& before = GetParam().shape;
  for (const Variant& variant : all_variants()) {
    SCOPED_TRACE(variant.name);
    AnyParams params = variant.with_target(before.face_count() / 4);
    shared(params).preserve_topology = true;
    const Shape after = decimated(before, params).shape;
    EXPECT_LT(two_sided_distance(before, after), near * diagonal(before));
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, ManifoldMesh, testing::ValuesIn(manifold_meshes()), name_of);

class ClosedMesh : public testing::TestWithParam<NamedShape> {};

TEST_P(ClosedMesh, CannotGoBelowATetrahedronPerComponent) {
  const Topology before = topology(GetParam().shape);
  EdgeCollapseParams params = to_faces(0);
  params.preserve_normal = false, params.preserve_topology = true;
  const auto [after, report] = decimated(GetParam().shape, params);
  EXPECT_GE(after.face_count(), 4 * before.components);
  EXPECT_EQ(report.stopped_by, StopReason::NothingLeft);
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes.back().find(std::to_string(after.face_count())), std::string::npos)
      << report.notes.back();
}

INSTANTIATE_TEST_SUITE_P(Drawn, ClosedMesh, testing::ValuesIn(closed_meshes()), name_of);

}  // namespace
}  // namespace curvdecim::test
