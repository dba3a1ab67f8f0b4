// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/attributes/attribute_blend.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// The record of one collapse of 12 into 17 of a 4 x 4 grid, to `now`.
BlendRecord record(const WorkingMesh& mesh, const Vector3& now, bool over_surface = true) {
  EdgeNeighborhood around;
  around.gather(mesh.connectivity, {12, 17});
  BlendRecord blend(over_surface);
  blend.make_room(1);
  blend.before(mesh, around, {}, {17, 12, mesh.position[17], mesh.position[12], now, 0.5}, 0);
  return blend;
}

void replay(const BlendRecord& record, std::vector<double>& values) {
  record.for_each(Parallel(1), [&](const BlendStep& step) { take(step, values, values); });
}

TEST(AttributeBlend, TakesTheValueOfThePlaceOnTheSurface) {
  const WorkingMesh mesh = working_mesh(plane_grid(4));
  std::vector<double> values;
  for (const Vector3& p : mesh.position) values.push_back(3.0 * p.x() - 2.0 * p.y());
  const Vector3 now(0.6, 0.4, 0.3);  // above the surface, off the edge
  replay(record(mesh, now), values);
  EXPECT_NEAR(values[17], 3.0 * 0.6 - 2.0 * 0.4, 1e-6);  // of weights in single precision
}

TEST(AttributeBlend, TakesTheValueOfThePlaceOnTheEdge) {
  const WorkingMesh mesh = working_mesh(plane_grid(4));
  std::vector<double> values(mesh.position.size(), 0.0);
  values[12] = 5.0, values[17] = 1.0;
  replay(record(mesh, Vector3(0.6, 0.4, 0.3), false), values);
  EXPECT_EQ(values[17], 3.0);  // halfway
}

TEST(AttributeBlend, LeavesAVertexThatStaysAlone) {
  const WorkingMesh mesh = working_mesh(plane_grid(4));
  for (bool over_surface : {true, false}) {
    const BlendRecord blend = record(mesh, mesh.position[17], over_surface);
    blend.for_each(Parallel(1), [](const BlendStep&) { ADD_FAILURE(); });
    std::vector<double> values(mesh.position.size(), 0.0);
    values[12] = 5.0;
    replay(blend, values);
    EXPECT_EQ(values[17], 0.0);
  }
}

TEST(AttributeBlend, ReplaysInOrder) {
  const BlendRecord steps({{0, {0, 1, 2}, {0.5, 0.5, 0.0}}, {2, {0, 1, 2}, {1.0, 0.0, 0.0}}});
  std::vector<double> values = {0.0, 4.0, 9.0};
  replay(steps, values);
  EXPECT_EQ(values, (std::vector<double>{2.0, 4.0, 2.0}));
}

TEST(AttributeBlend, AValueThatIsNotFiniteDoesNotSpread) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const BlendRecord steps({{0, {0, 1, 2}, {0.25, 0.5, 0.25}}});
  std::vector<double> one_bad = {2.0, nan, 6.0};
  replay(steps, one_bad);
  EXPECT_EQ(one_bad[0], 4.0);  // the mean of the others, by their weights
  std::vector<double> all_bad = {nan, nan, nan};
  replay(steps, all_bad);
  EXPECT_TRUE(std::isnan(all_bad[0]));
  std::vector<double> unused_bad = {2.0, nan, 6.0};
  replay(BlendRecord({{0, {0, 1, 2}, {0.5, 0.0, 0.5}}}), unused_bad);
  EXPECT_EQ(unused_bad[0], 4.0);
}

}  // namespace
}  // namespace curvdecim::test
