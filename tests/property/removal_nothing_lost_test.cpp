// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex removal: cancel, selection, attributes, bad input. What must be as it was, is.
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "support/drawn_meshes.h"
#include "support/expectations.h"
#include "support/properties.h"
#include "support/removal.h"

namespace curvdecim::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::multiset<std::string> vertices_of(const RichMesh& mesh) {
  std::multiset<std::string> vertices;
  for (const RichVertex& v : mesh.vert)
    if (!v.IsD()) vertices.insert(Fingerprint().add(v).bytes());
  return vertices;
}

class RemovalWith : public testing::TestWithParam<RemovalVariant> {
 protected:
  VertexRemovalParams to(int faces) const { return GetParam().of(removal_to(faces)); }
};

TEST_P(RemovalWith, CancelLeavesTheMeshAsItWas) {
  expect_cancel_leaves(unit_ball(4), [&](RichMesh& mesh, const Progress& progress) {
    return remove(mesh, to(300), progress);
  });
}

TEST_P(RemovalWith, EveryVertexThatStaysKeepsAllThatItCarries) {
  for (const Shape& shape : {unit_ball(3), plane_grid(20)}) {
    RichMesh mesh;
    fill_with_attributes(mesh, shape);
    for (std::size_t v = 0; v < mesh.vert.size(); ++v)  // nothing that a blend would give
      mesh.vert[v].Q() = static_cast<double>(v * v % 97), mesh.vert[v].R() = float(v % 13);
    auto custom = vcg::tri::Allocator<RichMesh>::AddPerVertexAttribute<int>(mesh, "number");
    for (std::size_t v = 0; v < mesh.vert.size(); ++v) custom[v] = static_cast<int>(v * v % 97);
    const std::multiset<std::string> before = vertices_of(mesh);
    remove(mesh, to(mesh.fn / 4));
    EXPECT_LT(mesh.vn, static_cast<int>(before.size()) / 2);
    for (const std::string& vertex : vertices_of(mesh)) ASSERT_EQ(before.count(vertex), 1u);
    for (std::size_t v = 0; v < mesh.vert.size(); ++v)
      ASSERT_EQ(custom[v], static_cast<int>(mesh.vert[v].cQ()));
    vcg::tri::Allocator<RichMesh>::DeletePerVertexAttribute(mesh, custom);
  }
}

TEST_P(RemovalWith, FacesOutsideTheSelectionAreTheSameToTheBit) {
  for (const Shape& shape : {plane_grid(24), unit_ball(4)}) {
    RichMesh mesh;
    fill_with_attributes(mesh, shape);
    const int selected = select_faces(mesh, is_left), others = mesh.fn - selected;
    const std::multiset<std::string> before = unselected_faces(mesh);
    VertexRemovalParams params = to(selected / 3);
    params.selected_only = true;
    remove(mesh, params);
    EXPECT_EQ(unselected_faces(mesh), before);
    EXPECT_LE(mesh.fn - others, selected / 3);
    EXPECT_GE(mesh.fn - others, selected / 3 - 1);
    EXPECT_EQ(topology(shape_of(mesh)).unreferenced_vertices, 0);
  }
}

TEST_P(RemovalWith, WedgeCoordinatesStayThoseOfTheVertex) {
  RichMesh mesh;
  fill_with_attributes(mesh, plane_grid(20));
  remove(mesh, to(100));
  EXPECT_LE(mesh.fn, 100);
  for (const RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(f.cWT(i).u(), f.cP(i)[0]);
      EXPECT_EQ(f.cWT(i).v(), f.cP(i)[1]);
    }
}

/// Charts meet in the seam x = 1/2 before and after, and no corner has coordinates that its vertex
/// did not have in that chart.
TEST_P(RemovalWith, NothingLeavesASeam) {
  RichMesh mesh;
  fill_with_attributes(mesh, plane_grid(20));
  put_right_half_on_a_page(mesh);
  remove(mesh, to(60));
  EXPECT_LE(mesh.fn, 60);
  double right_area = 0.0;
  for (const RichFace& f : mesh.face) {
    const int page = f.cWT(0).n();
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(f.cWT(i).n(), page);
      EXPECT_EQ(f.cWT(i).u(), f.cP(i)[0] + 10.0 * page);
      EXPECT_TRUE(page == 1 ? f.cP(i)[0] >= 0.5 : f.cP(i)[0] <= 0.5);
    }
    if (page == 1) right_area += 0.5 * ((f.cP(1) - f.cP(0)) ^ (f.cP(2) - f.cP(0))).Norm();
  }
  EXPECT_NEAR(right_area, 0.5, 1e-12);
}

TEST_P(RemovalWith, FacesNormalsAndTheBoxFit) {
  RichMesh mesh;
  fill_with_attributes(mesh, unit_ball(3));
  build_adjacency(mesh);
  remove(mesh, to(200));
  expect_faces_of_the_input(mesh);
  expect_face_normals_that_fit(mesh);
  expect_box_that_fits(mesh);
  expect_no_adjacency(mesh);
}

TEST_P(RemovalWith, QualityProtects) {
  for (double left : {1.0, 1e-4}) {
    RichMesh mesh;
    fill_with_attributes(mesh, unit_ball(4));
    for (RichVertex& v : mesh.vert) v.Q() = is_left(v.cP()) ? left : 1e-2;
    VertexRemovalParams params = to(mesh.fn / 4);
    params.quality_weight = true;
    remove(mesh, params);
    int on_the_left = 0;
    for (const RichVertex& v : mesh.vert) on_the_left += is_left(v.cP());
    EXPECT_TRUE(left == 1.0 ? on_the_left > 0.6 * mesh.vn : on_the_left < 0.4 * mesh.vn)
        << on_the_left << " of " << mesh.vn;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, RemovalWith, testing::ValuesIn(removal_variants()),
                         [](const testing::TestParamInfo<RemovalVariant>& each) {
                           return each.param.name;
                         });

// --- bad input -----------------------------------------------------------------------------------

void expect_refused(RichMesh& mesh, const VertexRemovalParams& params,
                    const std::vector<std::string>& words) {
  expect_refusal(
      mesh, [&] { remove(mesh, params); }, words);
}

TEST(RemovalBadMesh, WithoutFacesIsRefused) {
  RichMesh empty, points, deleted;
  expect_refused(empty, removal_to(10), {"empty"});
  fill(points, {icosphere(0).vertices, {}});
  expect_refused(points, removal_to(10), {"12 points", "no faces"});
  fill_with_attributes(deleted, octahedron());
  for (RichFace& f : deleted.face) vcg::tri::Allocator<RichMesh>::DeleteFace(deleted, f);
  expect_refused(deleted, removal_to(4), {"no faces"});
}

TEST(RemovalBadMesh, NothingSelectedIsRefused) {
  RichMesh mesh;
  fill_with_attributes(mesh, octahedron());
  VertexRemovalParams params = removal_to(4);
  params.selected_only = true;
  expect_refused(mesh, params, {"no face is selected"});
}

TEST(RemovalBadMesh, AVertexThatIsNotFiniteIsNamed) {
  RichMesh mesh;
  fill_with_attributes(mesh, icosphere(1));
  mesh.vert[17].P()[1] = nan;
  expect_refused(mesh, removal_to(10), {"Vertex 17", "finite"});
  RichMesh weighted;
  fill_with_attributes(weighted, icosphere(1));
  weighted.vert[5].Q() = nan;
  VertexRemovalParams params = removal_to(10);
  params.quality_weight = true;
  expect_refused(weighted, params, {"vertex 5", "quality"});
}

TEST(RemovalBadMesh, AllInOnePointIsRefused) {
  RichMesh mesh;
  fill(mesh, scaled(octahedron(), 0.0));
  expect_refused(mesh, removal_to(4), {"one point"});
}

TEST(RemovalBadMesh, FacesWithoutAreaDoNoHarm) {
  Shape flat = plane_grid(8);
  for (Point& p : flat.vertices)
    if (p.x() > 0.4 && p.x() < 0.6) p.x() = 0.5;
  Shape line = plane_grid(8);
  for (Point& p : line.vertices) p.y() = 0.0;
  for (const Shape& shape : {flat, line})
    for (const RemovalVariant& variant : removal_variants()) {
      VertexRemovalParams params = removal_to(10);
      params.join_borders = false;  // those of the line lie on each other, and would make it a tube
      const Shape after = thinned(shape, variant.of(params)).shape;
      EXPECT_TRUE(all_finite(after));
      EXPECT_PRED2(keeps_topology, topology(shape), topology(after));
    }
}

struct BadRemovalParameter {
  const char* name;
  const char* word;  // in the message
  void (*set)(VertexRemovalParams&);
};

void PrintTo(const BadRemovalParameter& parameter, std::ostream* out) { *out << parameter.name; }

class BadRemovalParameters : public testing::TestWithParam<BadRemovalParameter> {};

TEST_P(BadRemovalParameters, AreRefusedByName) {
  RichMesh mesh;
  fill_with_attributes(mesh, icosphere(1));
  VertexRemovalParams params = removal_to(10);
  GetParam().set(params);
  expect_refused(mesh, params, {GetParam().word});
}

using P = VertexRemovalParams;
using B = BadRemovalParameter;

INSTANTIATE_TEST_SUITE_P(
    Each, BadRemovalParameters,
    testing::Values(B{"NoTarget", "No target", [](P& p) { p.target_faces = P::no_target; }},
                    B{"NegativeFaces", "target_faces", [](P& p) { p.target_faces = -1; }},
                    B{"NegativeBound", "distance_bound", [](P& p) { p.distance_bound = -0.1; }},
                    B{"BoundNan", "distance_bound", [](P& p) { p.distance_bound = nan; }},
                    B{"BoundInfinite", "distance_bound", [](P& p) { p.distance_bound = infinity; }},
                    B{"AspectNan", "aspect_ratio_min", [](P& p) { p.aspect_ratio_min = nan; }},
                    B{"AspectAbove", "aspect_ratio_min", [](P& p) { p.aspect_ratio_min = 0.51; }},
                    B{"AspectBelow", "aspect_ratio_min", [](P& p) { p.aspect_ratio_min = -0.01; }},
                    B{"AngleNan", "feature_angle", [](P& p) { p.feature_angle = nan; }},
                    B{"NegativeThreads", "threads", [](P& p) { p.threads = -1; }}),
    [](const testing::TestParamInfo<B>& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace curvdecim::test
