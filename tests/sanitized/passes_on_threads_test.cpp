// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh that is large enough for passes (docs/decisions/passes.md).
#include <gtest/gtest.h>

#include "support/decimation.h"
#include "support/drawn_meshes.h"

namespace curvdecim::test {
namespace {

TEST(Passes, DoOnThreadsWhatTheyDoOnOne) {
  const Shape ball = bumpy_sphere(5);
  for (Preset preset : {Preset::Fast, Preset::Balanced}) {
    EdgeCollapseParams params = to_faces(2000);
    params.preset = preset;
    params.threads = 1;
    const Shape one = decimated(ball, params).shape;
    params.threads = 3;
    EXPECT_EQ(decimated(ball, params).shape, one);
  }
}

}  // namespace
}  // namespace curvdecim::test
