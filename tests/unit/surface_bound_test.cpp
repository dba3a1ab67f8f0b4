// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/guard/surface_bound.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

constexpr double limit = 0.02;
constexpr double just_inside = 0.999 * limit;

/// A mesh that is asked about, from where it is its own input.
struct Asked {
  WorkingMesh mesh;
  SurfaceBound bound;

  SurfaceChange change;

  explicit Asked(const Shape& shape, bool one_sided = false)
      : mesh(working_mesh(shape)), bound(mesh, limit, one_sided, Parallel(1)) {
    EXPECT_TRUE(bound.begin(mesh, mesh.connectivity.face_slots(), Parallel(1)));
    EXPECT_LE(bound.at_start(), 1e-8);
  }

  EdgeNeighborhood around(Edge edge) const {
    EdgeNeighborhood around;
    around.gather(mesh.connectivity, edge);
    return around;
  }

  double after(Edge edge, const Vector3& x) {
    change.set_collapse(mesh, around(edge), x);
    return bound.after(mesh, change);
  }

  void collapse(Edge edge, const Vector3& x) {
    ASSERT_LE(after(edge, x), limit);
    bound.accept(change);
    move(edge, x);
  }

  /// The same unasked; the distance is known.
  void collapse_within(double distance, Edge edge, const Vector3& x) {
    change.set_collapse(mesh, around(edge), x);
    bound.follow(mesh, change, distance);
    move(edge, x);
  }

  void move(Edge edge, const Vector3& x) {
    mesh.position[edge.a] = x;
    mesh.connectivity.collapse(edge.a, edge.b);
  }
};

constexpr int cells = 8;
int vertex(int i, int j) { return j * (cells + 1) + i; }
Vector3 middle_of(const Asked& asked, Edge edge) {
  return 0.5 * (asked.mesh.position[edge.a] + asked.mesh.position[edge.b]);
}

const Edge inside{vertex(3, 4), vertex(4, 4)};

TEST(SurfaceBound, OfMovesInAPlaneIsZero) {
  Asked asked(plane_grid(cells));
  EXPECT_LE(asked.after(inside, middle_of(asked, inside)), 1e-8);
}

TEST(SurfaceBound, OfALiftedVertexIsItsHeight) {
  Asked asked(plane_grid(cells));
  const Vector3 up(0, 0, 1), x = middle_of(asked, inside);
  EXPECT_NEAR(asked.after(inside, x + just_inside * up), just_inside, 1e-8);
  EXPECT_GT(asked.after(inside, x + 1.001 * limit * up), limit);
}

/// Up and down again: the sum of moves is three times the limit.
TEST(SurfaceBound, DoesNotAddUpWhatComesBack) {
  Asked asked(plane_grid(cells));
  const Vector3 lift(0, 0, just_inside);
  asked.collapse(inside, middle_of(asked, inside) + lift);
  const Edge next{vertex(3, 4), vertex(5, 4)};
  const Vector3 x = middle_of(asked, next);
  asked.collapse(next, {x.x(), x.y(), -just_inside});
  const Edge last{vertex(3, 4), vertex(3, 5)};
  EXPECT_LE(asked.after(last, {0.5, 0.55, 0.0}), limit);
}

/// One collapse after the other leaves the surface: each of them adds less than the limit.
TEST(SurfaceBound, StillKnowsTheInputAfterManyCollapses) {
  Asked asked(plane_grid(cells));
  const Vector3 lift(0, 0, 0.6 * limit);
  asked.collapse(inside, middle_of(asked, inside) + lift);
  const Edge next{vertex(3, 4), vertex(5, 4)};
  EXPECT_GT(asked.after(next, middle_of(asked, next) + 2.0 * lift), limit);
}

/// From the mesh all is near; the input's corner is not.
TEST(SurfaceBound, LooksFromTheInputToo) {
  Asked asked(plane_grid(cells));
  const Edge at_corner{vertex(0, 0), vertex(1, 0)};
  const Vector3 cut_off(1.0 / cells, 0, 0);
  EXPECT_GT(asked.after(at_corner, cut_off), limit);
  EXPECT_LE(asked.after(at_corner, {0, 0, 0}), 1e-8);
}

TEST(SurfaceBound, OneSidedLooksFromTheMeshOnly) {
  Asked asked(plane_grid(cells), true);
  const Edge at_corner{vertex(0, 0), vertex(1, 0)};
  EXPECT_LE(asked.after(at_corner, {1.0 / cells, 0, 0}), 1e-8);
  EXPECT_GT(asked.after(at_corner, {-1.001 * limit, 0, 0}), limit);
}

/// What was not asked about is known to what comes after: the input and how far it is.
TEST(SurfaceBound, FollowsWhatIsKnownToBeNear) {
  Asked asked(plane_grid(cells));
  const Vector3 lift(0, 0, 0.6 * limit);
  asked.collapse_within(0.6 * limit, inside, middle_of(asked, inside) + lift);
  const Edge next{vertex(3, 4), vertex(5, 4)};
  EXPECT_GT(asked.after(next, middle_of(asked, next) + 2.0 * lift), limit);
  EXPECT_EQ(asked.bound.before(asked.change), 0.6 * limit);
  asked.collapse(next, {0.5, 0.5, 0.0});
  asked.change.set_collapse(asked.mesh, asked.around({vertex(3, 4), vertex(3, 5)}), {0.5, 0.5, 0});
  EXPECT_LT(asked.bound.before(asked.change), 0.6 * limit);
}

TEST(SurfaceBound, TellsWhichFacesHaveMovedTooFar) {
  Asked asked(plane_grid(cells));
  EXPECT_TRUE(asked.bound.reached(asked.mesh, Parallel(2)).too_far.empty());
  asked.mesh.position[vertex(4, 4)].z() = just_inside;
  EXPECT_NEAR(asked.bound.reached(asked.mesh, Parallel(2)).distance, just_inside, 1e-8);
  asked.mesh.position[vertex(4, 4)].z() = 1.001 * limit;
  const auto moved = asked.mesh.connectivity.faces_of(vertex(4, 4));
  EXPECT_EQ(asked.bound.reached(asked.mesh, Parallel(2)).too_far.size(), moved.size());
}

bool begins(SurfaceBound& bound, const WorkingMesh& mesh) {
  return bound.begin(mesh, mesh.connectivity.face_slots(), Parallel(1));
}

TEST(SurfaceBound, BeginsWithNothingThatIsTooFar) {
  const WorkingMesh input = working_mesh(plane_grid(cells));
  SurfaceBound bound(input, limit, false, Parallel(1));
  const WorkingMesh near = working_mesh(translated(plane_grid(2), {0, 0, just_inside}));
  const WorkingMesh far = working_mesh(translated(plane_grid(2), {0, 0, 1.001 * limit}));
  const WorkingMesh part = working_mesh(scaled(plane_grid(2), 0.9));
  for (const WorkingMesh* mesh : {&far, &part}) {
    EXPECT_TRUE(begins(bound, near));
    EXPECT_NEAR(bound.at_start(), just_inside, 1e-8);
    EXPECT_FALSE(begins(bound, *mesh));
    EXPECT_FALSE(bound.has_begun());
  }
}

/// What was collapsed may be taken back: then there is nothing to ask about.
TEST(SurfaceBound, CanBeStopped) {
  const WorkingMesh input = working_mesh(plane_grid(cells));
  SurfaceBound bound(input, limit, false, Parallel(1));
  ASSERT_TRUE(begins(bound, working_mesh(translated(plane_grid(2), {0, 0, just_inside}))));
  bound.stop();
  EXPECT_FALSE(bound.has_begun());
  EXPECT_EQ(bound.at_start(), 0.0);
  EXPECT_TRUE(begins(bound, input));
  EXPECT_LE(bound.at_start(), 1e-8);
}

TEST(SurfaceBound, ThatSamplesHoldNeedNotHoldAllOver) {
  const WorkingMesh input = working_mesh(bumpy_sphere(2));
  const SurfaceBound bound(input, limit, false, Parallel(2));
  const auto holds = [&](const Shape& shape, double share) {
    const WorkingMesh mesh = working_mesh(shape);
    return bound.holds_in_samples(mesh, shape.face_count(), share, Parallel(2));
  };
  EXPECT_TRUE(holds(bumpy_sphere(2), 1e-6));
  EXPECT_FALSE(holds(translated(bumpy_sphere(2), {0.1, 0, 0}), 1.0));
}

}  // namespace
}  // namespace curvdecim::test
