// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/host_mesh/write_back.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/drawn_meshes.h"
#include "support/fingerprint.h"
#include "support/properties.h"
#include "support/rich_mesh.h"
#include "support/touching.h"
#include "vcg_ext/host_mesh/read_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

/// A 4 x 4 grid with attributes, and its arrays.
class WriteBackOf : public testing::Test {
 protected:
  void draw(const Shape& shape) {
    fill_with_attributes(mesh_, shape);
    copy_ = read_mesh(mesh_, false, Parallel(1));
  }

  /// The working vertex of a vertex of the mesh.
  int working(int v) const {
    const auto& all = copy_.vertex_of;
    return static_cast<int>(std::find(all.begin(), all.end(), v) - all.begin());
  }

  /// Collapses an edge of the mesh (numbered as in it) into `keep`, which goes to `x`.
  void collapse(int keep, int gone, const Point& x) {
    WorkingMesh& mesh = copy_.mesh;
    mesh.position[working(keep)] = copy_.box.to_box(x);
    mesh.connectivity.collapse(working(keep), working(gone));
    for (int f : mesh.connectivity.faces_of(working(keep))) mesh.update_plane(f);
  }

  void write(const std::vector<BlendStep>& steps = {}) {
    Carried carried;
    carried.blended = BlendRecord(steps);
    WriteBack<RichMesh>(mesh_, copy_, carried, Parallel(2)).run(nullptr);
  }

  RichMesh mesh_;
  WorkingCopy copy_;
};

TEST_F(WriteBackOf, NothingChangedLeavesEveryBit) {
  draw(translated(plane_grid(4), {1.0 / 3.0, 0.1, -7.7}));
  const std::string before = bytes_of(mesh_);
  write();
  EXPECT_EQ(bytes_of(mesh_), before);
}

TEST_F(WriteBackOf, ACollapseIsWrittenAndTheMeshIsCompact) {
  draw(plane_grid(4));
  collapse(12, 17, {0.6, 0.5, 0.2});
  write();
  EXPECT_EQ(mesh_.fn, 30);
  EXPECT_EQ(mesh_.vn, 24);
  EXPECT_EQ(mesh_.face.size(), 30u);
  EXPECT_EQ(mesh_.vert.size(), 24u);
  EXPECT_LT((mesh_.vert[12].cP() - vcg::Point3d(0.6, 0.5, 0.2)).Norm(), 1e-15);
  EXPECT_EQ(mesh_.bbox.max, vcg::Point3d(1, 1, 0.2));
}

TEST_F(WriteBackOf, FacesAwayFromTheCollapseKeepTheirBits) {
  draw(rotated(plane_grid(4), 1.0, {1, 2, 3}));
  for (RichFace& f : mesh_.face) f.N() = {9, 9, 9};  // to see what is written
  const auto is_near = [](const RichFace& f) {
    for (int i = 0; i < 3; ++i)
      if (f.cV(i)->cQ() == 12.0 || f.cV(i)->cQ() == 17.0) return true;
    return false;
  };
  for (std::size_t v = 0; v < mesh_.vert.size(); ++v) mesh_.vert[v].Q() = static_cast<double>(v);
  std::vector<std::string> before, after;
  for (const RichFace& f : mesh_.face)
    if (!is_near(f)) before.push_back(bytes_of(f));
  const vcg::Point3d x = (mesh_.vert[12].cP() + mesh_.vert[17].cP()) / 2.0;
  collapse(12, 17, {x[0], x[1], x[2]});
  write();
  for (const RichFace& f : mesh_.face) {
    if (!is_near(f)) after.push_back(bytes_of(f));
    EXPECT_EQ(is_near(f), f.cN() != vcg::Point3d(9, 9, 9));
    EXPECT_TRUE(!is_near(f) || std::abs(f.cN().Norm() - 1.0) < 1e-12);
  }
  EXPECT_EQ(after, before);
}

TEST_F(WriteBackOf, ANormalOfAVertexThatIsBlendedHasLengthOne) {
  draw(plane_grid(4));
  mesh_.vert[12].N() = {1, 0, 0}, mesh_.vert[17].N() = {0, 0, 1}, mesh_.vert[3].N() = {0, 0, 5};
  collapse(12, 17, {0.6, 0.5, 0});
  write({{working(12), {working(12), working(17), working(11)}, {0.5, 0.5, 0.0}}});
  EXPECT_LT((mesh_.vert[12].cN() - vcg::Point3d(1, 0, 1).Normalize()).Norm(), 1e-15);
  EXPECT_EQ(mesh_.vert[3].cN(), vcg::Point3d(0, 0, 5));
}

TEST_F(WriteBackOf, ColoursAreRoundedAndStayInTheirRange) {
  draw(plane_grid(4));
  mesh_.vert[12].C() = {0, 255, 10, 255}, mesh_.vert[17].C() = {255, 0, 11, 255};
  collapse(12, 17, {0.6, 0.5, 0});
  write({{working(12), {working(12), working(17), working(11)}, {-0.5, 1.5, 0.0}}});
  EXPECT_EQ(mesh_.vert[12].cC(), vcg::Color4b(255, 0, 12, 255));
}

TEST_F(WriteBackOf, FacesThatCannotBeUsedGoWithTheVerticesThatOnlyTheyUsed) {
  Shape shape = plane_grid(4);
  shape.vertices.push_back({2, 2, 2});
  shape.vertices.push_back({3, 3, 3});  // used by no face: stays
  shape.faces.push_back({25, 25, 3});
  draw(shape);
  write();
  EXPECT_EQ(mesh_.fn, 32);
  EXPECT_EQ(mesh_.vn, 26);
  EXPECT_EQ(mesh_.vert[25].cP(), vcg::Point3d(3, 3, 3));
}

/// Two boxes at an edge, read with a vertex of its own for each at both ends of it.
class WriteBackOfCopies : public WriteBackOf {
 protected:
  void draw_boxes() {
    draw(scaled(boxes_at_an_edge(), 0.5));
    copy_ = read_mesh(mesh_, ReadingPlan{false, false, Sheets::AreSeparated}, Parallel(1));
  }

  /// The working vertices of a vertex of the mesh.
  std::vector<int> copies_of(int v) const {
    std::vector<int> copies;
    for (std::size_t w = 0; w < copy_.vertex_of.size(); ++w)
      if (copy_.vertex_of[w] == v) copies.push_back(static_cast<int>(w));
    return copies;
  }
};

TEST_F(WriteBackOfCopies, EachIsAVertexWithAllThatItCarries) {
  draw_boxes();
  auto custom = vcg::tri::Allocator<RichMesh>::AddPerVertexAttribute<int>(mesh_, "custom");
  for (std::size_t v = 0; v < mesh_.vert.size(); ++v) custom[v] = static_cast<int>(v);
  ASSERT_EQ(mesh_.vn, 14);
  write();
  ASSERT_EQ(mesh_.vn, 16);
  const auto [a, b] = edge_in_common(scaled(shape_of(mesh_), 2.0));
  const int of[] = {a, b};
  for (int v : {14, 15}) {
    const RichVertex &copy = mesh_.vert[v], &original = mesh_.vert[of[v - 14]];
    EXPECT_EQ(custom[v], of[v - 14]);
    EXPECT_EQ(copy.cP(), original.cP());
    EXPECT_EQ(copy.cC(), original.cC());
    EXPECT_EQ(copy.cQ(), original.cQ());
    EXPECT_EQ(copy.cT(), original.cT());
  }
  EXPECT_EQ(topology(shape_of(mesh_)).nonmanifold_edges, 0);
  EXPECT_EQ(topology(shape_of(mesh_)).unreferenced_vertices, 0);
}

TEST_F(WriteBackOfCopies, EachHasItsOwnPlaceAndValues) {
  draw_boxes();
  const std::vector<int> copies = copies_of(edge_in_common(boxes_at_an_edge()).first);
  ASSERT_EQ(copies.size(), 2u);
  for (RichVertex& v : mesh_.vert) v.Q() = 1.0;
  const int other = copy_.mesh.connectivity.next_vertex(
      *copy_.mesh.connectivity.faces_of(copies[1]).begin(), copies[1]);
  mesh_.vert[copy_.vertex_of[other]].Q() = 3.0;
  copy_.mesh.position[copies[1]] += Vector3(0.01, 0, 0);
  write({{copies[1], {copies[1], other, other}, {0.5, 0.5, 0.0}}});
  const int a = edge_in_common(scaled(shape_of(mesh_), 2.0)).first;
  ASSERT_GE(a, 0);
  EXPECT_EQ(mesh_.vert[a].cQ(), 1.0);
  const auto moved = std::find_if(mesh_.vert.begin(), mesh_.vert.end(),
                                  [](const RichVertex& v) { return v.cQ() == 2.0; });
  ASSERT_NE(moved, mesh_.vert.end());
  EXPECT_GT(moved->cP()[0], mesh_.vert[a].cP()[0]);
}

TEST_F(WriteBackOfCopies, OnlyOneThatIsLeftIsTheVertexItself) {
  draw_boxes();
  const int v = edge_in_common(boxes_at_an_edge()).first;
  const std::vector<int> copies = copies_of(v);
  TriangleConnectivity& connectivity = copy_.mesh.connectivity;
  const int f = *connectivity.faces_of(copies[0]).begin();
  connectivity.collapse(connectivity.next_vertex(f, copies[0]), copies[0]);
  const vcg::Point3d place = mesh_.vert[v].cP();
  for (int g = 0; g < connectivity.face_slots(); ++g)
    if (connectivity.alive(g)) copy_.mesh.update_plane(g);
  write();
  EXPECT_EQ(mesh_.vn, 15);
  EXPECT_EQ(mesh_.fn, 22);
  EXPECT_EQ(mesh_.vert[v].cP(), place);
  EXPECT_EQ(topology(shape_of(mesh_)).unreferenced_vertices, 0);
}

}  // namespace
}  // namespace curvdecim::test
