// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "support/pass_surfaces.h"
#include "support/properties.h"
#include "vcg_ext/metric/curvature_weighted_metric.h"

namespace curvdecim::test {

using namespace detail;

namespace {

// --- the surface ---------------------------------------------------------------------------------

TEST(PassSurface, KeepsWhatIsLeftOfAnArray) {
  for (int threads : {1, 2, 5})
    for (int every : {1, 2, 3, 5000}) {
      std::vector<int> array(5000), left, empty;
      std::iota(array.begin(), array.end(), 0);
      for (int i = every - 1; i < 5000; i += every) left.push_back(i);
      keep_only(left, Parallel(threads), array), keep_only(left, Parallel(threads), empty);
      EXPECT_EQ(array, left);
      EXPECT_TRUE(empty.empty());
    }
}

TEST(PassSurface, ClosesGapsInOrder) {
  const Shape grid = plane_grid(4);
  for (int threads : {1, 3}) {
    const Parallel parallel(threads);
    PassSurface surface = surface_of(grid);
    std::vector<int> into = nothing_merged(surface);
    into[7] = 6;
    surface.close_gaps(into, parallel);
    EXPECT_EQ(surface.vertex_count(), grid.vertex_count() - 1);
    EXPECT_EQ(surface.face_count(), grid.face_count() - 2);
    for (int v = 0; v < surface.vertex_count(); ++v) {
      EXPECT_EQ(surface.vertex_before[v], v < 7 ? v : v + 1);
      EXPECT_EQ(surface.position[v], grid.vertices[surface.vertex_before[v]]);
    }
    for (int f = 0; f < surface.face_count(); ++f) {
      const Corners& was = grid.faces[surface.face_origin[f]];
      for (int i = 0; i < 3; ++i)
        EXPECT_EQ(surface.vertex_before[surface.faces[f][i]], into[was[i]]);
    }
  }
}

// --- whole runs ----------------------------------------------------------------------------------

struct Passed {
  WorkingMesh mesh;
  BlendSteps steps;
  Tally tally;
};

class Passes : public testing::Test {
 protected:
  static CollapsePlan to(const WorkingMesh& mesh, int faces) {
    CollapsePlan plan;
    plan.stop.start = mesh.connectivity.face_count(), plan.stop.faces = faces / 2;
    plan.schedule.passes_goal = faces;
    return plan;
  }

  static Passed run(WorkingMesh mesh, const CollapsePlan& plan, const Parallel& parallel,
                    bool over_surface = false) {
    CurvatureWeightedMetric metric(mesh, {});
    std::optional<PassSurface> surface = prepare(mesh, metric, plan, parallel);
    BlendRecord record(over_surface);
    Tally tally;
    if (!surface) return {std::move(mesh), {}, tally};
    const int count = collapse_in_passes(*std::move(surface), mesh, metric, plan, record, nullptr,
                                         parallel, tally);
    mesh.connectivity.validate();
    BlendSteps steps;
    record.for_each(one_thread, [&](const BlendStep& step) { steps.over_surface.push_back(step); });
    EXPECT_EQ(static_cast<int>(steps.over_surface.size()), count);
    return {std::move(mesh), std::move(steps), tally};
  }

  /// How far, at the most, position as an attribute ends from the position, to how far vertices
  /// went.
  static double error_of_replay(const WorkingMesh& mesh, const Passed& passed) {
    std::vector<Vector3> at = mesh.position;
    for (const BlendStep& step : passed.steps.over_surface) {
      Vector3 sum = Vector3::Zero();
      for (int i = 0; i < 3; ++i) sum += double(step.weight[i]) * at[step.from[i]];
      at[step.keep] = sum;
    }
    double furthest = 0.0, moved = 0.0;
    for (std::size_t v = 0; v < passed.mesh.position.size(); ++v) {
      const int was = passed.mesh.vertex_origin[v];
      furthest = std::max(furthest, (passed.mesh.position[v] - at[was]).norm());
      moved = std::max(moved, (passed.mesh.position[v] - mesh.position[was]).norm());
    }
    return furthest / moved;
  }
};

TEST_F(Passes, EndAtTheGoalAndKeepTheTopology) {
  const Shape ball = scaled(bumpy_sphere(5), 0.25);
  for (int goal : {12000, 5000, 1000}) {
    const WorkingMesh mesh = working_mesh(ball);
    const Passed passed = run(mesh, to(mesh, goal), one_thread);
    const Shape left = shape_of(passed.mesh);
    EXPECT_GT(passed.tally.cost_last, 0.0);
    EXPECT_GE(left.face_count(), goal - 1);
    EXPECT_LE(left.face_count(), goal);
    EXPECT_TRUE(keeps_topology(topology(ball), topology(left))) << topology(left);
  }
}

/// Where all edges cost the same, all could collapse at once.
TEST_F(Passes, DoNotGoBelowTheGoalInAPlane) {
  const Shape grid = plane_grid(60);
  for (double part : {0.9, 0.6, 0.3}) {
    const WorkingMesh mesh = working_mesh(grid);
    const int goal = static_cast<int>(part * grid.face_count());
    EXPECT_GE(run(mesh, to(mesh, goal), one_thread).mesh.connectivity.face_count(), goal - 1);
  }
}

TEST_F(Passes, AreTheSameForAnyNumberOfThreads) {
  const WorkingMesh mesh = working_mesh(scaled(bumpy_sphere(5), 0.25));
  const Passed one = run(mesh, to(mesh, 3000), one_thread);
  for (int threads : {2, 5}) {
    const Passed many = run(mesh, to(mesh, 3000), Parallel(threads));
    EXPECT_EQ(shape_of(many.mesh), shape_of(one.mesh));
    ASSERT_EQ(many.steps.over_surface.size(), one.steps.over_surface.size());
    for (std::size_t i = 0; i < one.steps.over_surface.size(); ++i) {
      const BlendStep &a = many.steps.over_surface[i], &b = one.steps.over_surface[i];
      ASSERT_TRUE(a.keep == b.keep && a.from == b.from && a.weight == b.weight);
    }
  }
}

TEST_F(Passes, LeaveWhatIsHeld) {
  WorkingMesh mesh = working_mesh(scaled(bumpy_sphere(5), 0.25));
  for (int v = 0; v < 400; ++v) mesh.locked[v] = 1;
  const Passed passed = run(mesh, to(mesh, 5000), one_thread);
  std::set<int> left;
  for (std::size_t v = 0; v < passed.mesh.position.size(); ++v) {
    const int was = passed.mesh.vertex_origin[v];
    left.insert(was);
    EXPECT_EQ(passed.mesh.locked[v] != 0, was < 400);
    if (was < 400) {
      EXPECT_EQ(passed.mesh.position[v], mesh.position[was]);
    }
  }
  for (int v = 0; v < 400; ++v) EXPECT_EQ(left.count(v), 1u);
}

TEST_F(Passes, DoNothingWhereMuchIsHeld) {
  WorkingMesh mesh = working_mesh(scaled(bumpy_sphere(4), 0.25));
  const auto lock = [&](double part) {
    std::fill_n(mesh.locked.begin(), static_cast<int>(part * mesh.locked.size()), 1);
    return run(mesh, to(mesh, 3000), one_thread).mesh.connectivity.face_count();
  };
  const int all = mesh.connectivity.face_count();
  EXPECT_LT(lock(0.1), all);
  EXPECT_EQ(lock(0.2), all);
}

TEST_F(Passes, LeaveAnInitializedMetricWhereMuchIsHeld) {
  WorkingMesh mesh = working_mesh(scaled(bumpy_sphere(3), 0.25));
  std::fill_n(mesh.locked.begin(), mesh.locked.size() / 5, 1);
  CurvatureWeightedMetric prepared(mesh, {}), initialized(mesh, {});
  EXPECT_FALSE(prepare(mesh, prepared, to(mesh, 100), one_thread).has_value());
  initialized.initialize(one_thread);
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f) {
    const Edge edge{mesh.connectivity.face(f)[0], mesh.connectivity.face(f)[1]};
    const auto cost = [&](const CurvatureWeightedMetric& metric) {
      return metric.evaluate(edge, Allowed::Anywhere, Vector3::Zero())->cost;
    };
    ASSERT_EQ(cost(prepared), cost(initialized));
  }
}

TEST_F(Passes, KeepTheOriginOfFaces) {
  const WorkingMesh mesh = working_mesh(scaled(bumpy_sphere(4), 0.25));
  const WorkingMesh after = run(mesh, to(mesh, 3000), one_thread).mesh;
  std::set<int> origins(after.face_origin.begin(), after.face_origin.end());
  EXPECT_EQ(static_cast<int>(origins.size()), after.connectivity.face_count());
  int held = 0;
  for (int f = 0; f < after.connectivity.face_slots(); ++f) {
    const Face& was = mesh.connectivity.face(after.face_origin[f]);
    for (int i = 0; i < 3; ++i)
      held += after.vertex_origin[after.connectivity.face(f)[i]] == was[i];
  }
  EXPECT_GT(held, after.connectivity.face_count()) << "most corners are the vertices they were";
}

TEST_F(Passes, NoteStepsThatCanBeReplayed) {
  const WorkingMesh mesh = working_mesh(scaled(bumpy_sphere(4), 0.25));
  for (int threads : {1, 3}) {
    const Parallel parallel(threads);
    const Passed edges = run(mesh, to(mesh, 3000), parallel),
                 surface = run(mesh, to(mesh, 3000), parallel, true);
    EXPECT_LT(error_of_replay(mesh, edges), 0.3);
    EXPECT_LT(error_of_replay(mesh, surface), 0.5 * error_of_replay(mesh, edges));
  }
}

TEST_F(Passes, NoteStepsThatAreReplayedOnAllCoresAsInOrder) {
  const WorkingMesh start = working_mesh(scaled(bumpy_sphere(5), 0.25));
  for (bool over_surface : {false, true}) {
    WorkingMesh mesh = start;
    CurvatureWeightedMetric metric(mesh, {});
    const CollapsePlan plan = to(mesh, 3000);
    std::optional<PassSurface> surface = prepare(mesh, metric, plan, one_thread);
    BlendRecord record(over_surface);
    Tally tally;
    collapse_in_passes(*std::move(surface), mesh, metric, plan, record, nullptr, one_thread, tally);
    EXPECT_GT(record.first_steps().stages[0].size(), 2u) << "blocks that are replayed together";
    const auto replayed = [&](int threads) {
      std::vector<double> values;
      for (const Vector3& p : start.position) values.push_back(p.x() + 2.0 * p.y());
      record.for_each(Parallel(threads),
                      [&](const BlendStep& step) { take(step, values, values); });
      return values;
    };
    EXPECT_EQ(replayed(4), replayed(1));
  }
}

TEST_F(Passes, AreScaledToTheBit) {
  const Shape ball = bumpy_sphere(4);
  const WorkingMesh small = working_mesh(scaled(ball, 0.25)), large = working_mesh(scaled(ball, 1));
  const Shape a = shape_of(run(small, to(small, 3000), one_thread).mesh),
              b = shape_of(run(large, to(large, 3000), one_thread).mesh);
  EXPECT_EQ(scaled(a, 4.0), b);
}

}  // namespace
}  // namespace curvdecim::test
