// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/clustering/first_seen.h"

#include <gtest/gtest.h>
#include <malloc.h>

namespace curvdecim::detail {

namespace {

/// Bytes that this process has allocated and not freed.
std::size_t allocated() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

TEST(FirstSeen, NumbersInTheOrderOfAppearance) {
  FirstSeen<std::uint64_t> seen;
  EXPECT_EQ(seen.number(70), 0);
  EXPECT_EQ(seen.number(5), 1);
  EXPECT_EQ(seen.number(70), 0);
  EXPECT_EQ(seen.number(6), 2);
  EXPECT_EQ(seen.keys(), (std::vector<std::uint64_t>{70, 5, 6}));
}

TEST(FirstSeen, GrowsAndFindsAllAgain) {
  FirstSeen<std::array<int, 2>> seen;
  constexpr int count = 10000;
  for (int i = 0; i < count; ++i) ASSERT_EQ(seen.number({i, -i}), i);
  for (int i = 0; i < count; ++i) ASSERT_EQ(seen.number({i, -i}), i);
  EXPECT_EQ(seen.size(), count);
}

TEST(FirstSeen, KeysThatDifferInTheHighestBitsOnlyDoNotCollide) {
  FirstSeen<std::uint64_t> seen;
  for (std::uint64_t i = 0; i < 4096; ++i) seen.number(i << 52);
  EXPECT_EQ(seen.size(), 4096);
}

/// As those of cells are, all over a grid of 2^63 places, each asked for ten times.
TEST(FirstSeen, TakesMemoryByTheNumberOfDifferentKeys) {
  for (std::size_t count : {1000, 100000}) {
    const std::size_t before = allocated();
    FirstSeen<std::uint64_t> seen;
    for (std::size_t i = 0; i < 10 * count; ++i) seen.number(mixed(i % count) >> 1);
    ASSERT_EQ(seen.size(), static_cast<int>(count));
    const std::size_t bytes_a_key = (allocated() - before) / count;
    EXPECT_GE(bytes_a_key, sizeof(std::uint64_t) + sizeof(int)) << count;
    EXPECT_LE(bytes_a_key, 64u) << count;
  }
}

}  // namespace
}  // namespace curvdecim::detail
