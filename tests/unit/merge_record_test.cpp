// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/merge_record.h"

#include <gtest/gtest.h>

namespace curvdecim::test {

using namespace detail;

namespace {

TEST(MergeRecord, LeadsToTheEndOfEveryChain) {
  MergeRecord record;
  record.begin(6);
  record.note(5, 3), record.note(3, 0), record.note(0, 4);
  EXPECT_EQ(record.ends(), (std::vector<int>{4, 1, 2, 4, 4, 4}));
}

TEST(MergeRecord, KnowsNumbersThatAreGivenLater) {
  MergeRecord record;
  record.begin(2);
  record.make_room(4);
  record.note(1, 3);
  EXPECT_EQ(record.ends(), (std::vector<int>{0, 3, 2, 3}));
}

TEST(MergeRecord, NotesNothingThatWasNotAskedFor) {
  MergeRecord record;
  record.make_room(4);
  record.note(1, 3);
  EXPECT_FALSE(record.exists());
  EXPECT_TRUE(record.ends().empty());
}

}  // namespace
}  // namespace curvdecim::test
