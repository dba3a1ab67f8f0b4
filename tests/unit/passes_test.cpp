// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/working_mesh.h"
#include "vcg_ext/metric/curvature_weighted_metric.h"
#include "vcg_ext/passes/collapse_in_passes.h"

namespace curvdecim::test {

using namespace detail;

namespace {

const Parallel one_thread(1);
constexpr double no_limit = 1e300;

/// On which all may go that inner vertices have closed fans for.
PassSurface surface_of(const Shape& shape) {
  PassSurface surface;
  const WorkingMesh mesh = working_mesh(shape);
  surface.position = shape.vertices;
  surface.faces = shape.faces;
  surface.memory.resize(shape.vertices.size()), surface.weight.resize(shape.vertices.size());
  for (int v = 0; v < shape.vertex_count(); ++v)
    surface.held.push_back(is_closed_fan(mesh, v) ? 0 : 1);
  surface.vertex_before.resize(shape.vertices.size());
  surface.face_before.resize(shape.faces.size());
  std::iota(surface.vertex_before.begin(), surface.vertex_before.end(), 0);
  std::iota(surface.face_before.begin(), surface.face_before.end(), 0);
  return surface;
}

std::vector<int> nothing_merged(const PassSurface& surface) {
  std::vector<int> into(surface.position.size());
  std::iota(into.begin(), into.end(), 0);
  return into;
}

FanLists fans_of(const PassSurface& surface) {
  FanLists fans;
  fans.build(surface.faces, surface.vertex_count(), one_thread,
             [&](int v) { return surface.held[v] == 0; });
  return fans;
}

// --- the faces of a fan --------------------------------------------------------------------------

/// About the centre, with the wings at its first neighbour.
FanFaces faces_around(const PassSurface& surface, int v) {
  const FanLists fans = fans_of(surface);
  FanCorners corners;
  EXPECT_TRUE(corners.gather(surface, fans, nothing_merged(surface), v, fans.of(v).begin()->next));
  return {surface, corners, surface.position[v], Vector3::Zero()};
}

TEST(FanFaces, AddUpToTheMatrixAndTheAreaOfTheFaces) {
  const WorkingMesh mesh = working_mesh(bumpy_sphere(2));
  const PassSurface surface = surface_of(bumpy_sphere(2));
  for (int v = 0; v < surface.vertex_count(); ++v) {
    const FanFaces faces = faces_around(surface, v);
    Symmetric3 matrix;
    for (int f : mesh.connectivity.faces_of(v))
      matrix += plane_matrix(mesh.plane[f], PlaneWeight::Area);
    const Symmetric3 error = matrix - faces.matrix();
    for (double e : {error.xx, error.xy, error.xz, error.yy, error.yz, error.zz})
      EXPECT_NEAR(e, 0.0, 1e-6 * matrix.trace());
    const Vector3 area = area_vector_around(mesh, v);
    EXPECT_NEAR((faces.area() - area).norm(), 0.0, 1e-6 * area.norm());
  }
}

TEST(FanFaces, TellTheAreaOfTheWings) {
  const Shape disk = fan(5);
  const PassSurface surface = surface_of(disk);
  const int other = fans_of(surface).of(0).begin()->next;
  Vector3 wings = Vector3::Zero();
  for (const Corners& face : disk.faces)
    if (std::count(face.begin(), face.end(), other) > 0) {
      const auto [a, b, c] = corners_of(disk, face);
      wings += area_vector(a, b, c);
    }
  EXPECT_NEAR((faces_around(surface, 0).area_of_wings() - wings).norm(), 0.0, 1e-6 * wings.norm());
}

TEST(FanFaces, CountByTheMeanOfTheirFactors) {
  const auto trace = [](float center, float around) {
    PassSurface surface = surface_of(fan(5));
    for (PassWeight& weight : surface.weight) weight.factor = around;
    surface.weight[0].factor = center;
    return faces_around(surface, 0).matrix().trace();
  };
  const double once = trace(1.0f, 1.0f);
  EXPECT_NEAR(trace(1.0f, 4.0f), 3.0 * once, 1e-6 * once);
  EXPECT_NEAR(trace(7.0f, 1.0f), 3.0 * once, 1e-6 * once);
}

// --- single edges --------------------------------------------------------------------------------

class Look : public testing::Test {
 protected:
  std::optional<Candidate> at(const Shape& shape, int a, int b, double limit = no_limit,
                              FaceLimits limits = {}) {
    const PassSurface surface = surface_of(shape);
    const FanLists fans = fans_of(surface);
    return FanCollapse(surface, fans, limits).look(a, b, nothing_merged(surface), limit);
  }
};

/// A grid of 6 x 6 cells has its inner vertices 24 and 25 in a row.
TEST_F(Look, CostsNothingInAPlane) {
  const Shape grid = plane_grid(6);
  const auto found = at(grid, 24, 25);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->cost, 0.0);
  EXPECT_NEAR(found->position.z(), 0.0, 1e-7);
}

TEST_F(Look, RefusesWhatCostsMoreThanTheLimit) {
  const Shape ball = icosphere(2);
  const int b = ball.faces[0][1], a = ball.faces[0][0];
  const auto found = at(ball, a, b);
  ASSERT_TRUE(found.has_value());
  EXPECT_GT(found->cost, 0.0);
  EXPECT_TRUE(at(ball, a, b, found->cost).has_value());
  EXPECT_FALSE(at(ball, a, b, 0.99 * found->cost).has_value());
}

TEST_F(Look, KeepsTheVolume) {
  const Shape ball = icosphere(2);
  const int a = ball.faces[0][0], b = ball.faces[0][1];
  const auto found = at(ball, a, b);
  ASSERT_TRUE(found.has_value());
  Shape after = ball;
  after.vertices[a] = after.vertices[b] = found->position;
  EXPECT_NEAR(volume(after), volume(ball), 1e-5 * volume(ball));
}

TEST_F(Look, RefusesAThirdCommonNeighbour) {
  EXPECT_FALSE(at(tetrahedron(), 0, 1).has_value());
  EXPECT_FALSE(at(octahedron(), octahedron().faces[0][0], octahedron().faces[0][1]).has_value());
}

TEST_F(Look, RefusesEdgesOfTheBorder) { EXPECT_FALSE(at(plane_grid(6), 1, 8).has_value()); }

/// The vertices 24 and 25 and the others of a grid, of which one stands so that its faces lie the
/// other way round when both meet in the middle.
TEST_F(Look, RefusesToTurnAFaceOver) {
  Shape grid = plane_grid(6);
  const double step = 1.0 / 6.0;
  grid.vertices[31] += Vector3(-0.45 * step, -0.96 * step, 0.0);
  grid.vertices[32] += Vector3(-0.55 * step, -0.97 * step, 0.0);
  int refused = 0, turned = 0;
  FaceLimits any;
  any.keeps_normal = false;
  for (const Corners& face : grid.faces)
    for (int i = 0; i < 3; ++i) {
      const int a = face[i], b = face[(i + 1) % 3];
      const bool possible = at(grid, a, b, no_limit, any).has_value();
      refused += !at(grid, a, b).has_value() && possible;
      if (const auto found = at(grid, a, b)) {
        Shape after = grid;
        after.vertices[a] = after.vertices[b] = found->position;
        for (const Corners& f : after.faces) {
          const auto t = corners_of(after, f), was = corners_of(grid, f);
          turned += area_vector(t[0], t[1], t[2]).dot(area_vector(was[0], was[1], was[2])) < 0.0;
        }
      }
    }
  EXPECT_GT(refused, 0);
  EXPECT_EQ(turned, 0);
}

/// Two neighbours of a that share a face with it, away from b.
std::pair<int, int> edge_opposite(const Shape& shape, int a, int b) {
  const auto is_near_b = [&](int v) {
    return std::any_of(shape.faces.begin(), shape.faces.end(), [&](const Corners& face) {
      return std::count(face.begin(), face.end(), v) > 0 &&
             std::count(face.begin(), face.end(), b) > 0;
    });
  };
  for (const Corners& face : shape.faces)
    for (int i = 0; i < 3; ++i)
      if (const int v = face[(i + 1) % 3], u = face[(i + 2) % 3];
          face[i] == a && !is_near_b(v) && !is_near_b(u))
        return {v, u};
  return {-1, -1};
}

TEST_F(Look, SeesNeighboursThatHaveMergedInThisPass) {
  const Shape ball = icosphere(2);
  PassSurface surface = surface_of(ball);
  const FanLists fans = fans_of(surface);
  const int a = 0, b = fans.of(a).begin()->next;
  std::vector<int> into = nothing_merged(surface);
  const FaceLimits limits;
  const auto before = FanCollapse(surface, fans, limits).look(a, b, into, no_limit);
  const auto [left, right] = edge_opposite(ball, a, b);
  into[right] = left;
  const auto after = FanCollapse(surface, fans, limits).look(a, b, into, no_limit);
  ASSERT_TRUE(before && after);
  EXPECT_NE(before->position, after->position);
}

// --- what is proposed ----------------------------------------------------------------------------

class Ranks : public testing::Test {
 protected:
  explicit Ranks() { ranks_.measure(grid_, fans_of(grid_), one_thread); }

  std::vector<int> proposers() const {
    std::vector<int> left;
    for (int v = 0; v < ranks_.count(); ++v)
      if (ranks_.partner(v) != PassRanks::none) left.push_back(v);
    return left;
  }

  PassSurface grid_ = surface_of(plane_grid(20));  // with edges that cost alike
  PassRanks ranks_;
};

TEST_F(Ranks, AreOfTheNeighbourThatIsNearestToThePlanes) {
  PassSurface tent = surface_of(plane_grid(6));
  for (Vector3& p : tent.position) p.z() = 0.3 * std::abs(p.x());
  PassRanks ranks;
  ranks.measure(tent, fans_of(tent), one_thread);
  const int on_ridge = 24;  // in the middle
  ASSERT_NE(ranks.partner(on_ridge), PassRanks::none);
  EXPECT_EQ(tent.position[ranks.partner(on_ridge)].x(), tent.position[on_ridge].x());
}

TEST_F(Ranks, ChooseNoMoreThanIsWantedAlsoOfWhatCostsTheSame) {
  const std::vector<int> all = proposers();
  const float limit = ranks_.choose(50, 1.0);
  const std::vector<int> chosen = proposers();
  EXPECT_EQ(chosen.size(), 50u);
  for (int v : chosen) EXPECT_LE(ranks_.rank(v), limit);
  EXPECT_LT(chosen.front(), all[all.size() / 4]) << "they are spread over the mesh";
  EXPECT_GT(chosen.back(), all[3 * all.size() / 4]);
}

TEST_F(Ranks, ChooseAShare) {
  const std::size_t all = proposers().size();
  ranks_.choose(1 << 20, 0.5);
  EXPECT_EQ(proposers().size(), all / 2);
}

TEST_F(Ranks, TellHowFarAnEdgeReaches) {
  for (int v : proposers()) {
    const int bits = ranks_.reach(v);
    const FanLists fans = fans_of(grid_);
    int differences = 0;
    for (int end : {v, ranks_.partner(v)})
      for (const FanCorner& corner : fans.of(end)) differences |= corner.next ^ v;
    EXPECT_EQ(differences >> bits, 0);
  }
}

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
      const Corners& was = grid.faces[surface.face_before[f]];
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
    std::optional<PassSurface> surface = prepare(mesh, metric, plan, true, parallel);
    BlendRecord record(over_surface);
    Tally tally;
    if (!surface) return {std::move(mesh), {}, tally};
    const int count =
        collapse_in_passes(*std::move(surface), mesh, metric, plan, record, parallel, tally);
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
  EXPECT_FALSE(prepare(mesh, prepared, to(mesh, 100), true, one_thread).has_value());
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
    std::optional<PassSurface> surface = prepare(mesh, metric, plan, true, one_thread);
    BlendRecord record(over_surface);
    Tally tally;
    collapse_in_passes(*std::move(surface), mesh, metric, plan, record, one_thread, tally);
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
