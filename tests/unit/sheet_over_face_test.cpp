// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/guard/sheet_over_face.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

struct Found {
  std::optional<SheetOverFace::Result> sheet;
  std::vector<int> over;  // faces over nothing but the face
};

/// The sheet of the shape over the triangle, from the face nearest to its middle.
Found sheet_of(const Shape& shape, const Triangle& t, double limit) {
  const WorkingMesh mesh = working_mesh(shape);
  const ReferenceSurface reference(mesh, Parallel(1));
  const TriangleTree tree(reference, reference.size(), Parallel(1));
  Found found;
  found.sheet = SheetOverFace(reference).find(t, tree.nearest(center_of(t), -1).face, limit,
                                              [&](int r, double height) {
                                                EXPECT_LE(height, limit);
                                                found.over.push_back(r);
                                              });
  return found;
}

bool tells_all(const Found& found) {
  return found.sheet && std::all_of(found.sheet->untold.begin(), found.sheet->untold.end(),
                                    [](double share) { return share == 0.0; });
}

const Triangle low{Vector3(0.11, 0.12, 0.01), Vector3(0.93, 0.14, 0.01), Vector3(0.35, 0.87, 0.01)};

TEST(SheetOverFace, OfAPlaneIsAsHighAsTheFaceIsLow) {
  const Found found = sheet_of(plane_grid(10), low, 0.1);
  ASSERT_TRUE(tells_all(found));
  EXPECT_NEAR(found.sheet->height, 0.01, 1e-8);
  EXPECT_GT(found.over.size(), 20u);
}

TEST(SheetOverFace, FindsTheHighestPointInside) {
  Shape bump = plane_grid(10);
  bump.vertices[5 * 11 + 5].z() = 0.05;
  ASSERT_TRUE(tells_all(sheet_of(bump, low, 0.1)));
  EXPECT_NEAR(sheet_of(bump, low, 0.1).sheet->height, 0.04, 1e-3);
}

/// The part over the bump is not told, so that it must not seem covered.
TEST(SheetOverFace, TellsNothingBelowWhatIsTooHigh) {
  Shape bump = plane_grid(10);
  bump.vertices[3 * 11 + 4].z() = 0.5;
  const Found found = sheet_of(bump, low, 0.1);
  EXPECT_FALSE(tells_all(found));
}

TEST(SheetOverFace, EndsAtABorder) {
  Triangle beyond = low;
  beyond[1].x() = 1.05;
  const Found found = sheet_of(plane_grid(10), beyond, 0.1);
  ASSERT_TRUE(found.sheet.has_value());
  EXPECT_FALSE(tells_all(found));
  EXPECT_GT(*std::max_element(found.sheet->untold.begin(), found.sheet->untold.end()), 0.05);
}

TEST(SheetOverFace, EndsAtAHole) {
  Shape holed = plane_grid(10);
  holed.faces.erase(holed.faces.begin() + 2 * (3 * 10 + 4));
  EXPECT_FALSE(tells_all(sheet_of(holed, low, 0.1)));
}

TEST(SheetOverFace, GoesNoFurtherWhereItTurnsBack) {
  Shape folded = plane_grid(10);
  for (Point& p : folded.vertices)
    if (p.x() > 0.55) p = {1.1 - p.x(), p.y(), 0.02};  // back over itself, within the limit
  EXPECT_FALSE(tells_all(sheet_of(folded, low, 0.1)));
}

TEST(SheetOverFace, IsNoneOverAFaceWithoutArea) {
  EXPECT_FALSE(sheet_of(plane_grid(4), {low[0], low[1], low[1]}, 0.1).sheet.has_value());
}

TEST(SheetOverFace, NamesOnlyWhatLiesOverTheFace) {
  const Shape grid = plane_grid(10);
  for (int f : sheet_of(grid, low, 0.1).over)
    for (int v : grid.faces[f]) {
      Vector3 place = PlaceOverFace(low)(grid.vertices[v]);
      for (int k = 0; k < 3; ++k) EXPECT_GE(PlaceOverFace::weight(place, k), -1e-8);
    }
}

}  // namespace
}  // namespace curvdecim::test
