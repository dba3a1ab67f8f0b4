// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/guard/step_bound.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

constexpr double limit = 0.02;
constexpr int cells = 8, middle = 4 * (cells + 1) + 4;

/// A plane, of which one edge at the middle is asked about.
struct Plane {
  WorkingMesh mesh = working_mesh(plane_grid(cells));
  SurfaceBound surface{mesh, limit, false, Parallel(1)};
  StepBound step{surface};

  Plane() { surface.begin_with_input(); }

  /// The middle and its neighbour meet so high above the middle.
  void lift(double height) {
    EdgeNeighborhood around;
    around.gather(mesh.connectivity, {middle, middle + 1});
    step.change().set_collapse(mesh, around, mesh.position[middle] + Vector3(0, 0, height));
  }
};

TEST(StepBound, TrustsASumWithinTheLimit) {
  Plane plane;
  plane.lift(3.0 * limit);  // it is not asked how far that is
  EXPECT_EQ(plane.step.known(0.5 * limit), 0.5 * limit);
  EXPECT_EQ(plane.step.measure(plane.mesh), 0.5 * limit);
}

TEST(StepBound, MeasuresWhereTheSumSaysTooMuch) {
  Plane plane;
  plane.lift(0.5 * limit);
  EXPECT_EQ(plane.step.known(3.0 * limit), 3.0 * limit);
  ASSERT_TRUE(plane.step.measure(plane.mesh));
  EXPECT_NEAR(*plane.step.measure(plane.mesh), 0.5 * limit, 0.01 * limit);
}

TEST(StepBound, KnowsWhatWasTooFar) {
  Plane plane;
  plane.lift(1.01 * limit);
  EXPECT_TRUE(plane.step.known(3.0 * limit));
  EXPECT_FALSE(plane.step.measure(plane.mesh));
  EXPECT_FALSE(plane.step.known(3.0 * limit));
  plane.lift(1.02 * limit);
  EXPECT_TRUE(plane.step.known(3.0 * limit));
}

TEST(StepBound, AddsToWhatWasThereBefore) {
  Plane plane;
  plane.lift(0.5 * limit);
  plane.step.known(0.75 * limit);
  plane.step.accept(plane.mesh);
  EXPECT_DOUBLE_EQ(*plane.step.known(0.125 * limit), 0.875 * limit);
}

}  // namespace
}  // namespace curvdecim::test
