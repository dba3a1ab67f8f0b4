// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/clustering/cell_sums.h"

#include <gtest/gtest.h>

namespace curvdecim::detail {

namespace {

struct Sum {
  double value = 0.0;
  Sum& operator+=(const Sum& o) {
    value += o.value;
    return *this;
  }
};

CellSums<Sum> sums_of(int count, int cells, int threads) {
  return sum_over<Sum>(count, cells, Parallel(threads), [&](CellSums<Sum>& into, int i) {
    into[i % cells].value += 1.0 / (1.0 + i);
  });
}

TEST(CellSums, BlocksAddUpToTheWhole) {
  constexpr int count = 1000, cells = 7;
  ASSERT_GT(blocks_of(count, cells), 1);
  const auto sums = sum_over<Sum>(count, cells, Parallel(1),
                                  [&](CellSums<Sum>& into, int i) { into[i % cells].value += i; });
  for (int c = 0; c < cells; ++c) {
    double expected = 0.0;
    for (int i = c; i < count; i += cells) expected += i;
    EXPECT_EQ(sums[c].value, expected);
  }
}

TEST(CellSums, HaveTheSameBitsForAnyNumberOfThreads) {
  constexpr int count = 5000, cells = 11;
  const CellSums<Sum> one = sums_of(count, cells, 1);
  for (int threads : {2, 3, 7}) {
    const CellSums<Sum> many = sums_of(count, cells, threads);
    for (int c = 0; c < cells; ++c) EXPECT_EQ(many[c].value, one[c].value);
  }
}

TEST(CellSums, OfManyCellsTakeOneBlock) {
  EXPECT_EQ(blocks_of(1000, 1000), 1);
  EXPECT_EQ(blocks_of(1000, 1), 8);
  EXPECT_EQ(blocks_of(0, 0), 1);
  for (int cells : {1, 10, 100, 1000, 10000})
    EXPECT_LE((blocks_of(10000, cells) - 1) * cells, 10000);
}

}  // namespace
}  // namespace curvdecim::detail
