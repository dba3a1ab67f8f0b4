// SPDX-License-Identifier: GPL-3.0-or-later
// Textures: what is carried by the corners of faces, and jumps at seams.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/expectations.h"
#include "support/mesh_types.h"
#include "support/removal.h"

namespace curvdecim::test {

namespace {

constexpr double pi = 3.14159265358979323846;

/// A sphere in six charts, one for each side of the cube around it, each in its own cell of the
/// texture: a square that a chart's jagged outline nearly fills.
void fill_cube_map(RichMesh& mesh, int subdivisions) {
  fill(mesh, icosphere(subdivisions));
  for (RichFace& f : mesh.face) {
    const vcg::Point3d c = f.cP(0) + f.cP(1) + f.cP(2);
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(c[k]) > std::abs(c[axis])) axis = k;
    const int page = 2 * axis + (c[axis] > 0.0 ? 1 : 0);
    for (int i = 0; i < 3; ++i) {
      const vcg::Point3d p = f.cP(i);
      const double side = std::abs(p[axis]);
      f.WT(i).u() = 0.5 + 0.3 * p[(axis + 1) % 3] / side * (page % 2 == 0 ? -1.0 : 1.0);
      f.WT(i).v() = 0.5 + 0.3 * p[(axis + 2) % 3] / side;
      f.WT(i).n() = static_cast<short>(page);
    }
  }
}

double area_in_texture(const RichFace& f) {
  return (f.cWT(1).u() - f.cWT(0).u()) * (f.cWT(2).v() - f.cWT(0).v()) -
         (f.cWT(2).u() - f.cWT(0).u()) * (f.cWT(1).v() - f.cWT(0).v());
}

/// How much of the texture is outside of its place on the sphere, in the mean over corners.
double drift(const RichMesh& mesh) {
  double sum = 0.0;
  for (const RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i) {
      const int page = f.cWT(i).n(), axis = page / 2;
      vcg::Point3d there;
      there[axis] = page % 2 == 0 ? -1.0 : 1.0;
      there[(axis + 1) % 3] = (f.cWT(i).u() - 0.5) / 0.3 * (page % 2 == 0 ? -1.0 : 1.0);
      there[(axis + 2) % 3] = (f.cWT(i).v() - 0.5) / 0.3;
      vcg::Point3d direction = there, is = f.cP(i);
      sum += (direction.Normalize() - is.Normalize()).Norm();
    }
  return sum / (3.0 * mesh.fn);
}

class CubeMap : public testing::TestWithParam<Preset> {
 protected:
  CubeMap() {
    fill_cube_map(mesh_, 5);  // 20,480 faces
    params_.preset = GetParam();
    params_.target_faces = 1500;
  }

  RichMesh mesh_;
  EdgeCollapseParams params_;
};

TEST_P(CubeMap, NoFaceIsTurnedOverInTheTexture) {
  for (const RichFace& f : mesh_.face) ASSERT_GT(area_in_texture(f), 0.0);
  decimate(mesh_, params_);
  EXPECT_LE(mesh_.fn, 1500);
  for (const RichFace& f : mesh_.face) EXPECT_GT(area_in_texture(f), 0.0);
}

TEST_P(CubeMap, ChartsDoNotMixAndStayInTheirPlace) {
  decimate(mesh_, params_);
  std::set<int> pages;
  for (const RichFace& f : mesh_.face) {
    pages.insert(f.cWT(0).n());
    for (int i = 0; i < 3; ++i) EXPECT_EQ(f.cWT(i).n(), f.cWT(0).n());
  }
  EXPECT_EQ(pages.size(), 6u);
  EXPECT_LT(drift(mesh_), 0.01);  // an edge is 0.1
}

TEST_P(CubeMap, IsTheSameOnAnyNumberOfThreads) {
  RichMesh other;
  fill_cube_map(other, 5);
  params_.threads = 1;
  decimate(mesh_, params_);
  params_.threads = 3;
  decimate(other, params_);
  EXPECT_EQ(shape_of(mesh_), shape_of(other));
  for (int f = 0; f < mesh_.fn; ++f)
    for (int i = 0; i < 3; ++i) EXPECT_EQ(mesh_.face[f].cWT(i), other.face[f].cWT(i));
}

INSTANTIATE_TEST_SUITE_P(Presets, CubeMap,
                         testing::Values(Preset::Fast, Preset::Balanced, Preset::Best),
                         [](const auto& preset) {
                           return std::string(labels(Preset())[int(preset.param)]);
                         });

/// A cut disk in the plane, its outline a circle: the outline of what is left lies inside of it.
TEST(TextureOutline, OfAConcaveChartIsNotLeft) {
  RichMesh mesh;
  fill(mesh, annulus(96, 24));  // radii 1 and 2: the hole is a concave side of the chart
  for (RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i)
      f.WT(i).u() = 0.5 + 0.2 * f.cP(i)[0], f.WT(i).v() = 0.5 + 0.2 * f.cP(i)[1], f.WT(i).n() = 0;
  EdgeCollapseParams params = to_faces(150);
  decimate(mesh, params);
  const double hole = 0.2 * std::cos(pi / 96.0);  // of the input's polygon, at the middle of a side
  for (const RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i) {
      const double u = 0.5 * (f.cWT(i).u() + f.cWT((i + 1) % 3).u()) - 0.5;
      const double v = 0.5 * (f.cWT(i).v() + f.cWT((i + 1) % 3).v()) - 0.5;
      EXPECT_GE(std::hypot(u, v), hole - 1e-6);
    }
}

TEST(Texture, WithoutAreaChangesNothing) {
  RichMesh textured;
  fill(textured, bumpy_sphere(4));
  BareMesh bare;
  fill(bare, bumpy_sphere(4));
  decimate(textured, to_faces(500));
  decimate(bare, to_faces(500));
  EXPECT_EQ(shape_of(textured), shape_of(bare));
}

TEST(Texture, ThatIsAffineCostsNothing) {
  RichMesh textured;
  fill(textured, saddle(32));
  for (RichFace& f : textured.face)
    for (int i = 0; i < 3; ++i) f.WT(i).u() = 7.0 + f.cP(i)[0], f.WT(i).v() = f.cP(i)[1];
  EdgeCollapseParams params = to_faces(1500);
  RichMesh other;
  fill(other, saddle(32));
  decimate(textured, params);
  decimate(other, params);
  EXPECT_NEAR(textured.fn, other.fn, 1);
  for (const RichFace& f : textured.face)
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(f.cWT(i).u(), 7.0 + f.cP(i)[0], 0.01);
      EXPECT_NEAR(f.cWT(i).v(), f.cP(i)[1], 0.01);
    }
}

/// u = x^3, v = y.
vcg::Point2d bent(const vcg::Point3d& p) { return {std::pow(p[0], 3.0), p[1]}; }

TEST(TextureByVertex, IsCarriedAsOneByWedge) {
  for (Preset preset : {Preset::Fast, Preset::Balanced, Preset::Best}) {
    SkinnedMesh by_vertex;
    RichMesh by_wedge;
    fill(by_vertex, saddle(32)), fill(by_wedge, saddle(32));
    for (SkinnedVertex& v : by_vertex.vert) v.T().P() = bent(v.cP()), v.T().n() = 0;
    for (RichFace& f : by_wedge.face)
      for (int i = 0; i < 3; ++i) f.WT(i).P() = bent(f.cP(i)), f.WT(i).n() = 0;
    EdgeCollapseParams params = to_faces(500);
    params.preset = preset;
    decimate(by_vertex, params), decimate(by_wedge, params);
    ASSERT_EQ(shape_of(by_vertex), shape_of(by_wedge));
    for (int f = 0; f < by_vertex.fn; ++f)
      for (int i = 0; i < 3; ++i)
        EXPECT_EQ(by_vertex.face[f].cV(i)->cT().P(), by_wedge.face[f].cWT(i).P());
  }
}

TEST(TextureByVertex, ThatIsTheSameEverywhereChangesNothing) {
  SkinnedMesh textured;
  BareMesh bare;
  fill(textured, bumpy_sphere(4)), fill(bare, bumpy_sphere(4));
  for (SkinnedVertex& v : textured.vert) v.T().P() = {0.25, 0.5}, v.T().n() = 0;
  decimate(textured, to_faces(500)), decimate(bare, to_faces(500));
  EXPECT_EQ(shape_of(textured), shape_of(bare));
  for (const SkinnedVertex& v : textured.vert) EXPECT_EQ(v.cT().P(), vcg::Point2d(0.25, 0.5));
}

/// In a plane nothing else costs anything: u = x^3 is followed where it bends.
TEST(AttributeWeight, LowersTheDrift) {
  const auto error_with = [](double weight) {
    RichMesh mesh;
    fill(mesh, plane_grid(40));
    for (RichFace& f : mesh.face)
      for (int i = 0; i < 3; ++i) f.WT(i).P() = bent(f.cP(i));
    EdgeCollapseParams params = to_faces(120);
    params.attribute_weight = weight;
    decimate(mesh, params);
    double worst = 0.0;
    for (const RichFace& f : mesh.face)
      for (int i = 0; i < 3; ++i) {
        const vcg::Point3d middle = (f.cP(i) + f.cP((i + 1) % 3)) / 2.0;
        const double u = 0.5 * (f.cWT(i).u() + f.cWT((i + 1) % 3).u());
        worst = std::max(worst, std::abs(u - std::pow(middle[0], 3.0)));
      }
    return worst;
  };
  EXPECT_LT(error_with(1.0), 0.5 * error_with(0.0));
}

/// Every face is a chart: it has its own place in the texture.
void fill_in_pieces(RichMesh& mesh, int subdivisions) {
  fill(mesh, icosphere(subdivisions));
  for (std::size_t f = 0; f < mesh.face.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      mesh.face[f].WT(i).u() = 0.01 * static_cast<double>(f) + (i == 1 ? 0.009 : 0.0);
      mesh.face[f].WT(i).v() = i == 2 ? 0.5 : 0.0;
    }
}

TEST(TextureInPieces, IsToldWithNumbersAndAWayOut) {
  RichMesh mesh;
  fill_in_pieces(mesh, 2);
  const DecimationReport report = decimate(mesh, to_faces(100));
  EXPECT_TRUE(is_said(report, "in 320 charts of 1 faces in the mean, and 100 % of the vertices"));
  EXPECT_TRUE(is_said(report, "'Transfer: Vertex Attributes to Texture (1 or 2 meshes)'"));
}

TEST(TextureInPieces, IsNotToldOfLargeCharts) {
  RichMesh mesh;
  fill_cube_map(mesh, 4);
  const DecimationReport report = decimate(mesh, to_faces(500));
  EXPECT_FALSE(is_said(report, "in the mean"));
  EXPECT_TRUE(is_said(report, "The texture has seams."));
}

TEST(TextureInPieces, IsNamedAsAReasonWhyVerticesAreNotRemoved) {
  RichMesh mesh;
  fill_in_pieces(mesh, 2);
  const DecimationReport report = remove(mesh, removal_to(4));
  ASSERT_EQ(report.stopped_by, StopReason::NothingLeft);
  EXPECT_TRUE(is_said(report, "because of seams there, of a texture or between groups of faces"));
}

}  // namespace
}  // namespace curvdecim::test
