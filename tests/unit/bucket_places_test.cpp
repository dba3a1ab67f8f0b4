// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/parallel/bucket_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "vcg_ext/parallel/radix_sort.h"

namespace curvdecim::detail {
namespace {

TEST(BucketPlaces, PutEntriesInTheOrderOfTheirItems) {
  constexpr int items = 5000, buckets = 7;
  const auto goes_to = [](int item, auto use) {  // one has none, most have one, some have two
    if (item == 3) return;
    use(item * item % buckets);
    if (item % 5 == 0) use(item % buckets);
  };
  std::vector<std::vector<int>> expected(buckets);
  for (int item = 0; item < items; ++item)
    goes_to(item, [&](int bucket) { expected[bucket].push_back(item); });
  for (int threads : {1, 2, 3, 16}) {
    const Parallel parallel(threads);
    BucketPlaces places;
    for (int time = 0; time < 2; ++time) {  // also where there are places already
      places.count(items, buckets, parallel, goes_to);
      std::vector<int> entries(places.begin().back());
      places.fill(parallel, [&](int item, auto place_in) {
        goes_to(item, [&](int bucket) { entries[place_in(bucket)] = item; });
      });
      for (int b = 0; b < buckets; ++b)
        EXPECT_EQ(std::vector<int>(entries.begin() + places.begin()[b],
                                   entries.begin() + places.begin()[b + 1]),
                  expected[b]);
    }
  }
}

TEST(RadixSort, IsThatOfKeysAndKeepsTheOrderOfEqualOnes) {
  Array<Keyed> items;
  for (int i = 0; i < 20000; ++i) {
    std::uint64_t key = static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15u >> 1;
    if (i % 3 == 0) key = (key % 5) << 58;  // some in the highest bits, and equal
    items.push_back({key, i});
  }
  Array<Keyed> expected = items;
  std::stable_sort(expected.begin(), expected.end(),
                   [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
  for (int threads : {1, 3}) {
    Array<Keyed> sorted = items;
    radix_sort(sorted, 63, Parallel(threads));
    for (std::size_t i = 0; i < items.size(); ++i) ASSERT_EQ(sorted[i].value, expected[i].value);
  }
}

TEST(Indices, AreThoseForWhichItHolds) {
  const auto holds = [](int i) { return i % 7 == 3; };
  for (int threads : {1, 2, 5})
    for (int count : {0, 3, 4, 5000}) {
      std::vector<int> expected;
      for (int i = 0; i < count; ++i)
        if (holds(i)) expected.push_back(i);
      EXPECT_EQ(indices_where(count, Parallel(threads), holds), expected);
      EXPECT_EQ(any_where(count, Parallel(threads), holds), !expected.empty());
    }
}

}  // namespace
}  // namespace curvdecim::detail
