// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/removal/loop_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

using Outcome = LoopTriangulation::Outcome;

constexpr double least_aspect = 0.04;

/// Vertex 0 in the middle of a closed loop of the points.
Shape wheel(const Point& middle, const std::vector<Point>& rim) {
  Shape shape{{middle}, {}};
  shape.vertices.insert(shape.vertices.end(), rim.begin(), rim.end());
  const int n = static_cast<int>(rim.size());
  for (int i = 0; i < n; ++i) shape.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  return shape;
}

struct Filled {
  Outcome outcome;
  std::vector<LoopTriangle> triangles;
  double step, error;
};

struct Options {
  double aspect = least_aspect;
  double apex_error = 0.0;
  bool (*accept)(const LoopTriangle&) = [](const LoopTriangle&) { return true; };
};

/// Triangulates the loop around vertex 0.
Filled fill(const Shape& shape, const Options& options = {}) {
  const WorkingMesh mesh = working_mesh(shape);
  VertexFan around;
  EXPECT_TRUE(around.gather(mesh.connectivity, 0));
  LoopPart part;
  part.cut(around, 0, static_cast<int>(around.faces().size()), mesh.position[0]);
  LoopTriangulation filling(mesh, options.aspect);
  const std::vector<double> errors(mesh.position.size(), 0.0);
  const Outcome outcome = filling.run(part, errors, options.apex_error, options.accept);
  return {outcome, filling.triangles(), filling.step(), filling.error()};
}

const std::vector<Point> square = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};

bool has_edge(const Filled& filled, int a, int b) {
  return std::any_of(filled.triangles.begin(), filled.triangles.end(), [=](const LoopTriangle& t) {
    return std::count(t.begin(), t.end(), a) == 1 && std::count(t.begin(), t.end(), b) == 1;
  });
}

TEST(LoopTriangulation, FillsAConvexLoopOfAnyLength) {
  for (int blades = 3; blades <= 20; ++blades) {
    const Filled filled = fill(fan(blades));
    ASSERT_EQ(filled.outcome, Outcome::Done) << blades;
    EXPECT_EQ(static_cast<int>(filled.triangles.size()), blades - 2);
    EXPECT_EQ(filled.step, 0.0);
  }
}

TEST(LoopTriangulation, OfAPlaneTakesTheLargestAspectRatio) {
  // A rectangle with one corner drawn in: the line through that corner is shorter, and leaves the
  // others further away.
  const Filled filled =
      fill(wheel({0, 0.2, 0}, {{0.3, 0.3, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}}));
  ASSERT_EQ(filled.outcome, Outcome::Done);
  EXPECT_TRUE(has_edge(filled, 0, 2) != has_edge(filled, 1, 3));
  EXPECT_TRUE(has_edge(filled, 0, 2));
}

TEST(LoopTriangulation, TakesTheLineThatIsNearestToTheOldFaces) {
  // A ridge from corner to corner: over it the middle lies on the new edge.
  for (int first : {0, 1}) {
    std::vector<Point> rim = square;
    rim[first].z() = rim[first + 2].z() = 0.3;
    const Filled filled = fill(wheel({0, 0, 0.3}, rim));
    ASSERT_EQ(filled.outcome, Outcome::Done);
    EXPECT_TRUE(has_edge(filled, first, first + 2));
    EXPECT_EQ(filled.step, 0.0);
  }
}

TEST(LoopTriangulation, KnowsHowFarTheNewTrianglesAre) {
  const Filled filled = fill(wheel({0, 0, 0.25}, square), {least_aspect, 0.5});
  ASSERT_EQ(filled.outcome, Outcome::Done);
  EXPECT_NEAR(filled.step, 0.25, 1e-12);
  EXPECT_NEAR(filled.error, 0.75, 1e-12);
}

/// No vertex is off, but the edges of old and new faces cross at a distance.
TEST(LoopTriangulation, CountsCrossingsOfEdges) {
  std::vector<Point> rim;
  for (int i = 0; i < 6; ++i)
    rim.push_back({std::cos(i * M_PI / 3), std::sin(i * M_PI / 3), i % 2 ? 0.2 : -0.2});
  const Filled filled = fill(wheel({0, 0, 0}, rim));
  ASSERT_EQ(filled.outcome, Outcome::Done);
  EXPECT_GT(filled.step, 0.05);
}

TEST(LoopTriangulation, KeepsAllOfOneSideOnThatSide) {
  // A star of four points: lines between neighbouring points leave the loop.
  std::vector<Point> rim;
  for (int i = 0; i < 8; ++i) {
    const double radius = i % 2 ? 0.4 : 1.0;
    rim.push_back({radius * std::cos(i * M_PI / 4), radius * std::sin(i * M_PI / 4), 0});
  }
  const Shape star = wheel({0, 0, 0}, rim);
  const Filled filled = fill(star);
  ASSERT_EQ(filled.outcome, Outcome::Done);
  EXPECT_EQ(filled.triangles.size(), 6u);
  double covered = 0.0;
  for (const LoopTriangle& t : filled.triangles)
    covered += area_vector(rim[t[0]], rim[t[1]], rim[t[2]]).z();
  double all = 0.0;
  for (const Corners& face : star.faces) all += 0.5 * double_area(star, face).z();
  EXPECT_NEAR(covered, all, 1e-12);
  for (int i = 0; i < 8; i += 2) EXPECT_FALSE(has_edge(filled, i, (i + 2) % 8));
}

TEST(LoopTriangulation, RefusesNarrowSplits) {
  // A thin loop: no line leaves the other corners far away.
  std::vector<Point> rim = square;
  for (Point& p : rim) p.y() *= 0.02;
  EXPECT_EQ(fill(wheel({0, 0, 0}, rim)).outcome, Outcome::NoSplit);
  EXPECT_EQ(fill(wheel({0, 0, 0}, rim), {0.0}).outcome, Outcome::Done);
}

TEST(LoopTriangulation, DoesNotDoubleAnEdge) {
  Shape shape = wheel({0, 0, 0.1}, square);
  EXPECT_TRUE(has_edge(fill(shape), 0, 2));
  shape.vertices.push_back({0, 0, -1});  // below: a face that has the edge 1-3 already
  shape.faces.push_back({1, 3, 5});
  const Filled filled = fill(shape);
  ASSERT_EQ(filled.outcome, Outcome::Done);
  EXPECT_FALSE(has_edge(filled, 0, 2));
  shape.faces.push_back({2, 4, 5});  // and the other one
  EXPECT_EQ(fill(shape).outcome, Outcome::NoSplit);
}

TEST(LoopTriangulation, DoesNotDoubleATriangle) {
  EXPECT_EQ(fill(tetrahedron()).outcome, Outcome::EdgeExists);
  EXPECT_EQ(fill(fan(3)).outcome, Outcome::Done);
}

TEST(LoopTriangulation, DoesNotFillALoopThatNoDirectionSees) {
  // The middle hangs over: its faces fold.
  EXPECT_EQ(fill(wheel({3, 0, 0}, square)).outcome, Outcome::NoSplit);
}

TEST(LoopTriangulation, LooksForAnotherWayWhereATriangleIsRefused) {
  const auto not_0_2 = [](const LoopTriangle& t) { return t[0] != 0 || (t[1] != 2 && t[2] != 2); };
  const Filled filled = fill(wheel({0, 0, 0}, square), {least_aspect, 0.0, not_0_2});
  ASSERT_EQ(filled.outcome, Outcome::Done);
  EXPECT_TRUE(has_edge(filled, 1, 3));
  EXPECT_EQ(
      fill(wheel({0, 0, 0}, square), {least_aspect, 0.0, [](const LoopTriangle&) { return false; }})
          .outcome,
      Outcome::NoSplit);
}

}  // namespace
}  // namespace curvdecim::test
