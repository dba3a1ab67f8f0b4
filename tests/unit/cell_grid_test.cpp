// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/clustering/cell_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace curvdecim::detail {

namespace {

const Vector3 half_size(0.4, 0.25, 0.1);

/// Points all over the bounding box, its ends included.
template <class Use>
void for_points(Use use) {
  constexpr int steps = 20;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      for (int k = 0; k <= steps; ++k)
        use(Vector3(2.0 * i / steps - 1.0, 2.0 * j / steps - 1.0, 2.0 * k / steps - 1.0)
                .cwiseProduct(half_size));
}

TEST(CellGrid, APointLiesInItsCell) {
  for (double diameter : {0.03, 0.11, 0.4, 0.9}) {
    const CellGrid grid(half_size, diameter);
    for_points([&](const Vector3& p) {
      const CellBox box = grid.box(grid.key(p));
      EXPECT_LE((box.clamped(p) - p).norm(), 1e-15);
    });
  }
}

TEST(CellGrid, ACellIsNoLargerThanItsDiameterAndInTheBoundingBox) {
  for (double diameter : {0.03, 0.11, 0.4, 0.9}) {
    const CellGrid grid(half_size, diameter);
    for_points([&](const Vector3& p) {
      const CellBox box = grid.box(grid.key(p));
      EXPECT_LE((box.high - box.low).norm(), diameter * (1.0 + 1e-15));
      EXPECT_TRUE((box.low.array() >= -half_size.array()).all());
      EXPECT_TRUE((box.high.array() <= half_size.array()).all());
      EXPECT_TRUE((box.low.array() <= box.high.array()).all());
    });
  }
}

TEST(CellGrid, LeftAndRightAreApart) {
  const CellGrid grid(half_size, 0.3);
  EXPECT_NE(grid.key({-0.001, 0, 0}), grid.key({0.001, 0, 0}));
}

TEST(CellGrid, RoundingDoesNotScatterAPlaneOfSymmetry) {
  const CellGrid grid(half_size, 0.1);
  for (double x : {-1e-12, -1e-16, 0.0, 1e-16, 1e-12})
    EXPECT_EQ(grid.key({x, 0.2, 0.05}), grid.key({0.0, 0.2, 0.05})) << x;
}

TEST(CellGrid, AnAxisShorterThanACellIsNotCut) {
  const CellGrid flat({0.4, 0.3, 0.0}, 0.05), thin({0.4, 0.3, 1e-3}, 0.05);
  EXPECT_EQ(thin.key({0.1, 0.1, -1e-3}), thin.key({0.1, 0.1, 1e-3}));
  EXPECT_EQ(flat.box(flat.key({0.1, 0.1, 0.0})).low.z(), 0.0);
  EXPECT_EQ(flat.box(flat.key({0.1, 0.1, 0.0})).high.z(), 0.0);
}

TEST(CellGrid, TheLargestDiameterIsOneCellAndTheLeastFitsTheKey) {
  const CellGrid one(half_size, CellGrid::largest_diameter(half_size));
  const CellGrid most(half_size, CellGrid::least_diameter(half_size));
  std::set<CellKey> keys;
  for_points([&](const Vector3& p) {
    EXPECT_EQ(one.key(p), one.key(half_size));
    keys.insert(most.key(p));
  });
  EXPECT_EQ(keys.size(), 21u * 21u * 21u);
  const CellKey last = most.key(half_size) & ((CellKey(1) << CellGrid::bits) - 1);
  EXPECT_GT(last, (CellKey(1) << CellGrid::bits) - 16);
  EXPECT_EQ(most.key(half_size) >> 63, 0u);
}

}  // namespace
}  // namespace curvdecim::detail
