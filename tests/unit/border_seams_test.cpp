// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/border_seams.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/touching.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

struct Joined {
  Shape shape;  // with joined borders
  int joined;
};

Joined joined(const WorkingMesh& mesh) {
  const Parallel parallel(1);
  BorderSeams seams(mesh, parallel);
  const Revertexed now = seams.join();
  Joined result{{{}, now.faces}, seams.joined()};
  for (int v : now.old_of) result.shape.vertices.push_back(mesh.position[v]);
  if (now.faces.empty()) result.shape = shape_of(mesh);
  return result;
}

Joined joined(const Shape& shape) { return joined(working_mesh(shape)); }

void expect_untouched(const Shape& shape) {
  EXPECT_EQ(joined(shape).joined, 0);
  EXPECT_EQ(joined(shape).shape, shape);
}

void expect_closed(const Shape& shape, int parts) {
  const Topology is = topology(shape);
  EXPECT_EQ(is.boundary_loops, 0);
  EXPECT_EQ(is.nonmanifold_edges, 0);
  EXPECT_EQ(is.nonmanifold_vertices, 0);
  EXPECT_EQ(is.inconsistent_edges, 0);
  EXPECT_EQ(is.components, parts);
}

TEST(BorderSeams, OfASoupCloseIt) {
  const auto [shape, count] = joined(soup_of(cube()));
  expect_closed(shape, 1);
  EXPECT_EQ(shape.vertex_count(), 8);
  EXPECT_EQ(count, 18);
}

TEST(BorderSeams, OfQuadsCloseThem) {
  expect_closed(joined(quads_of(dense_box(3, {1, 2, 3}))).shape, 1);
}

TEST(BorderSeams, OfChunksJoinThemAndLeaveTheOuterBorder) {
  const Shape chunk = scaled(plane_grid(4), 4.0);
  const Shape chunks = side_by_side({chunk, translated(chunk, {4, 0, 0}),
                                     translated(chunk, {0, 4, 0}), translated(chunk, {4, 4, 0})});
  const auto [shape, count] = joined(chunks);
  EXPECT_EQ(shape.vertex_count(), 81);
  EXPECT_EQ(count, 16);
  EXPECT_EQ(topology(shape).boundary_loops, 1);
  EXPECT_EQ(topology(shape).components, 1);
}

TEST(BorderSeams, OfTouchingPartsCloseEach) {
  for (const Shape& boxes :
       {boxes_at_an_edge(2), boxes_at_a_face(false, 2), boxes_at_a_face(true, 2)}) {
    expect_closed(joined(soup_of(boxes)).shape, 2);
    expect_closed(joined(quads_of(boxes)).shape, 2);
  }
}

TEST(BorderSeams, TheFirstVertexStaysForTheOthers) {
  const WorkingMesh mesh = working_mesh(soup_of(two_triangles()));
  const Parallel parallel(1);
  EXPECT_EQ(BorderSeams(mesh, parallel).join().old_of, (std::vector<int>{0, 1, 2, 5}));
}

/// A slit: at its end both sides have the same vertex.
TEST(BorderSeams, OfASlitCloseItUpToItsEnd) {
  const Shape whole = plane_grid(4);
  Shape slit = whole;
  for (int v : {10, 11}) {  // of those in the middle column, 12 is the end
    const int copy = slit.vertex_count();
    slit.vertices.push_back(whole.vertices[v]);
    for (Corners& f : slit.faces)
      if (slit.vertices[f[0]].x() + slit.vertices[f[1]].x() + slit.vertices[f[2]].x() > 1.5)
        std::replace(f.begin(), f.end(), v, copy);
  }
  const auto [shape, count] = joined(slit);
  EXPECT_EQ(count, 2);
  EXPECT_EQ(shape, whole);
}

TEST(BorderSeams, AreNoneWithoutBordersInOnePlace) {
  for (const Shape& shape : {torus(8, 6), plane_grid(4), fan(6), bowtie(), book(4, 4)})
    expect_untouched(shape);
}

TEST(BorderSeams, AreNoneBetweenNeighboursThatDoNotLieOnEachOther) {
  Shape shape = soup_of(two_triangles());
  shape.vertices[3].x() += 1e-12;
  expect_untouched(shape);
}

TEST(BorderSeams, AreNoneBetweenFacesThatRunTheSameWay) {
  Shape shape = soup_of(two_triangles());
  std::swap(shape.faces[1][0], shape.faces[1][1]);
  expect_untouched(shape);
}

TEST(BorderSeams, AreNoneWhereThreeSheetsMeet) {
  const Topology is = topology(joined(soup_of(book(3, 1))).shape);
  EXPECT_EQ(is.components, 3);
  EXPECT_EQ(is.nonmanifold_edges, 0);
}

TEST(BorderSeams, AreNoneOfFacesGivenTwice) {
  expect_untouched(side_by_side({soup_of(cube()), soup_of(cube())}));
  Shape sides = soup_of(two_triangles());  // of a sheet
  for (const Corners& f : soup_of(two_triangles()).faces) sides.faces.push_back({f[1], f[0], f[2]});
  expect_untouched(side_by_side({soup_of(sides), soup_of(sides)}));
}

TEST(BorderSeams, StayApartAtLockedVertices) {
  WorkingMesh mesh = working_mesh(soup_of(two_triangles()));
  mesh.locked[0] = 1;
  EXPECT_EQ(joined(mesh).joined, 0);
}

TEST(BorderSeams, DoNotGiveAFaceAVertexTwice) {
  const Point p(0, 0, 0), c(1, 0, 0);
  expect_untouched({{p, p, c, c, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {3, 4, 5}}});
}

TEST(BorderSeams, DoNotMakeAnEdgeWhoseFacesDoNotPair) {
  const Point a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), e(0, 0, 1);
  // The first two share an edge that both run along in the same way; the last one would close the
  // ring around a, and run along ab as the first one does.
  expect_untouched({{a, b, c, e, a, e}, {{0, 1, 2}, {0, 3, 2}, {4, 1, 5}}});
}

}  // namespace
}  // namespace curvdecim::test
