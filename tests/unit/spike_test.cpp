// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/guard/spike.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// What the collapse of edge 0-1 of a flat fan of six, of radius 1, to x costs.
double price_at(const Vector3& x) {
  const WorkingMesh mesh = working_mesh(fan(6));
  EdgeNeighborhood around;
  around.gather(mesh.connectivity, {0, 1});
  std::vector<FacePlane> after;
  for (int f : around.star()) after.push_back(face_plane(triangle_after(mesh, f, {0, 1}, x)));
  return spike_price(mesh, around, x, after);
}

TEST(SpikePrice, IsNothingNearTheEdge) {
  EXPECT_EQ(price_at({0.5, 0.0, 0.0}), 0.0);
  EXPECT_EQ(price_at({0.5, 0.0, 0.4}), 0.0);
}

TEST(SpikePrice, IsNothingOnTheSurface) { EXPECT_NEAR(price_at({-0.8, 0.0, 0.0}), 0.0, 1e-15); }

TEST(SpikePrice, GrowsWithTheSquaredDistanceAndTheArea) {
  EXPECT_GT(price_at({0.5, 0.0, 2.0}), 4.0 * price_at({0.5, 0.0, 1.0}));
  EXPECT_GT(price_at({0.5, 0.0, 1.0}), 0.3);  // half of the fan is lifted by 1, and more is added
}

}  // namespace
}  // namespace curvdecim::test
