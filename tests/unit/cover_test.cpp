// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/guard/cover.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"
#include "vcg_ext/guard/near_faces.h"

namespace curvdecim::test {

using namespace detail;

namespace {

constexpr int enough = 2000;

std::vector<NumberedFace> faces_of(const Shape& shape) {
  const WorkingMesh mesh = working_mesh(shape);
  std::vector<NumberedFace> faces;
  for (int f = 0; f < shape.face_count(); ++f) faces.push_back({f, mesh.triangle(f)});
  return faces;
}

std::optional<double> covered(const Triangle& t, const Shape& by, double limit,
                              int most_parts = enough) {
  Cover cover;
  std::vector<int> used;
  const std::vector<NumberedFace> faces = faces_of(by);
  cover.add(ConvexPolygon(t));
  return cover.distance(limit, most_parts, NearInList(faces, limit, used));
}

const Triangle over_the_grid{Vector3(0.1, 0.1, 0.01), Vector3(0.9, 0.15, 0.01),
                             Vector3(0.3, 0.8, 0.01)};

TEST(Cover, TellsTheHeightOverManyFaces) {
  const auto distance = covered(over_the_grid, plane_grid(5), 0.02);
  ASSERT_TRUE(distance.has_value());
  EXPECT_GE(*distance, 0.01 - 1e-15);  // parts may look for what is a little further away
  EXPECT_LE(*distance, 0.02);
}

TEST(Cover, RefusesWhatIsTooHigh) {
  EXPECT_FALSE(covered(over_the_grid, plane_grid(5), 0.0099).has_value());
}

/// The corners are near, the middle is not.
TEST(Cover, RefusesWhatSpansAHole) {
  const Triangle across{Vector3(-1, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0)};
  EXPECT_FALSE(covered(across, annulus(32, 4), 0.05).has_value());
}

TEST(Cover, RefusesWhatReachesBeyondTheFaces) {
  const Triangle beyond{Vector3(0.1, 0.1, 0), Vector3(1.1, 0.5, 0), Vector3(0.1, 0.9, 0)};
  EXPECT_TRUE(covered(beyond, plane_grid(5), 0.11).has_value());
  EXPECT_FALSE(covered(beyond, plane_grid(5), 0.09).has_value());
}

/// Cut along the edges of faces that stand on it, nothing was gained, again and again.
TEST(Cover, EndsBesideFacesThatStandOnTheTriangle) {
  Shape both = plane_grid(3);
  const int first = both.vertex_count();
  both.vertices.insert(both.vertices.end(), {{0.2, 0.2, 0.0}, {0.7, 0.7, 0.0}, {0.5, 0.5, 0.4}});
  both.faces.push_back({first, first + 1, first + 2});
  EXPECT_TRUE(covered(over_the_grid, both, 0.02, 200).has_value());
}

TEST(Cover, EndsWithTrianglesWithoutArea) {
  const Triangle needle{Vector3(0.1, 0.1, 0), Vector3(0.9, 0.8, 0), Vector3(0.9, 0.8, 0)};
  EXPECT_TRUE(covered(needle, plane_grid(8), 0.01, 200).has_value());
  const Triangle lifted{Vector3(0.1, 0.1, 0.2), Vector3(0.9, 0.8, 0), Vector3(0.9, 0.8, 0)};
  EXPECT_FALSE(covered(lifted, plane_grid(8), 0.01, 200).has_value());
}

TEST(Cover, TakesWhatIsUndecidedAsNotCovered) {
  EXPECT_FALSE(covered(over_the_grid, plane_grid(20), 0.0101, 3).has_value());
}

TEST(Cover, NamesTheFacesThatItTook) {
  Cover cover;
  std::vector<int> used;
  const std::vector<NumberedFace> faces = faces_of(plane_grid(2));
  cover.add(ConvexPolygon(faces[3].triangle));
  ASSERT_TRUE(cover.distance(1e-6, enough, NearInList(faces, 1e-6, used)).has_value());
  EXPECT_EQ(used, std::vector<int>{3});
}

}  // namespace
}  // namespace curvdecim::test
