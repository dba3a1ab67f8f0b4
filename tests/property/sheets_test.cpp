// SPDX-License-Identifier: GPL-3.0-or-later
// Closed parts that touch, decimated each by itself where topology need not be preserved.
#include <gtest/gtest.h>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/rich_mesh.h"
#include "support/touching.h"

namespace curvdecim::test {

namespace {

EdgeCollapseParams without_topology(int faces) {
  EdgeCollapseParams params = to_faces(faces);
  params.preserve_topology = false;
  return params;
}

/// Two closed boxes, whole and in their places.
void expect_two_boxes(const Shape& before, const Shape& after) {
  const Topology is = topology(after);
  EXPECT_EQ(is.components, 2);
  EXPECT_EQ(is.boundary_loops, 0);
  EXPECT_EQ(is.nonmanifold_edges, 0);
  EXPECT_EQ(is.unreferenced_vertices, 0);
  EXPECT_NEAR(volume(after), volume(before), 1e-6);
  EXPECT_LT(two_sided_distance(before, after), 1e-3);
}

TEST(TouchingParts, AreDecimatedEachByItself) {
  for (const Shape& before :
       {boxes_at_an_edge(6), boxes_at_a_face(false, 6), boxes_at_a_face(true, 6)}) {
    const Shape after = decimated(before, without_topology(60)).shape;
    EXPECT_LE(after.face_count(), 60);
    expect_two_boxes(before, after);
  }
}

TEST(TouchingParts, StayTogetherWhereTopologyIsPreserved) {
  const Shape before = boxes_at_an_edge(6);
  EdgeCollapseParams params = to_faces(100);
  params.preserve_topology = true;
  const Shape after = decimated(before, params).shape;
  EXPECT_EQ(topology(after).components, 1);
  EXPECT_PRED2(keeps_topology, topology(before), topology(after));
}

TEST(TouchingParts, OfTheSelectionOnlyWhereNothingIsLocked) {
  RichMesh mesh;
  fill_with_attributes(mesh, scaled(boxes_at_an_edge(6), 0.5));
  select_faces(mesh, [](const vcg::Point3d& p) { return p[0] < 0.5; });
  EdgeCollapseParams params = without_topology(60);
  params.selected_only = true;
  decimate(mesh, params);
  const Topology is = topology(shape_of(mesh));
  EXPECT_EQ(is.components, 1);
  EXPECT_EQ(is.nonmanifold_edges, 6);
  EXPECT_EQ(is.boundary_loops, 0);
}

TEST(TouchingParts, AreNotSeparatedWherePairsMayMerge) {
  EdgeCollapseParams params = without_topology(100);
  params.pair_distance = 1e-3;
  EXPECT_EQ(decimated(boxes_at_an_edge(6), params).report.pairs_contracted, 0);
}

}  // namespace
}  // namespace curvdecim::test
