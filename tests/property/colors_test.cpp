// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of vertices count in a collapse, by AttributeWeight.
#include <gtest/gtest.h>

#include <cmath>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/properties.h"
#include "support/rich_mesh.h"

namespace curvdecim::test {
namespace {

constexpr double stripes = 12.0;  // radians a unit of height

/// Red in stripes over the height.
double redness(double height) { return 0.5 + 0.5 * std::tanh(4.0 * std::sin(stripes * height)); }

void fill_with_stripes(RichMesh& mesh, int subdivisions) {
  fill(mesh, icosphere(subdivisions));
  for (RichVertex& v : mesh.vert) {
    v.Q() = v.R() = 0;
    v.T() = vcg::TexCoord2d(0, 0);
    const auto red = static_cast<unsigned char>(std::lround(255.0 * redness(v.cP()[2])));
    v.C() = vcg::Color4b(red, 90, 20, 255);
  }
}

/// Root of the mean square, over faces by area, of how red their centres are and should be.
double error_of_colors(const RichMesh& mesh) {
  double sum = 0.0, area = 0.0;
  for (const RichFace& f : mesh.face) {
    double red = 0.0;
    for (int i = 0; i < 3; ++i) red += f.cV(i)->cC()[0] / 255.0 / 3.0;
    const vcg::Point3d center = (f.cP(0) + f.cP(1) + f.cP(2)) / 3.0;
    const double off = red - redness(center[2] / center.Norm());
    const double weight = ((f.cP(1) - f.cP(0)) ^ (f.cP(2) - f.cP(0))).Norm();
    sum += weight * off * off, area += weight;
  }
  return std::sqrt(sum / area);
}

EdgeCollapseParams weighed(int faces, double attribute_weight, Preset preset = Preset::Balanced) {
  EdgeCollapseParams params = to_faces(faces);
  params.attribute_weight = attribute_weight;
  params.preset = preset;
  return params;
}

/// In rounds, and where the first collapses go in passes.
class Colors : public testing::TestWithParam<int> {
 protected:
  double error(double attribute_weight) {
    RichMesh mesh;
    fill_with_stripes(mesh, GetParam());
    const int target = mesh.fn / 12;
    decimate(mesh, weighed(target, attribute_weight));
    EXPECT_LE(mesh.fn, target);
    return error_of_colors(mesh);
  }
};

TEST_P(Colors, AreNearerToThoseOfTheInputWithMoreWeight) {
  const double without = error(0.0);
  EXPECT_LT(error(0.01), 0.95 * without);
  EXPECT_LT(error(0.3), 0.7 * without);
}

INSTANTIATE_TEST_SUITE_P(Subdivisions, Colors, testing::Values(4, 6));

TEST(ColorsWithoutWeight, ChangeNothing) {
  RichMesh plain, colored;
  fill_with_stripes(plain, 4), fill_with_stripes(colored, 4);
  for (RichVertex& v : plain.vert) v.C() = vcg::Color4b(90, 90, 90, 255);
  decimate(plain, weighed(500, 0.0)), decimate(colored, weighed(500, 0.0));
  EXPECT_EQ(shape_of(plain), shape_of(colored));
}

TEST(ColorsThatAreAllAlike, ChangeNothing) {
  RichMesh without, with;
  fill_with_stripes(without, 4), fill_with_stripes(with, 4);
  for (RichMesh* mesh : {&without, &with})
    for (RichVertex& v : mesh->vert) v.C() = vcg::Color4b(90, 90, 90, 255);
  decimate(without, weighed(500, 0.0)), decimate(with, weighed(500, 1.0));
  EXPECT_EQ(shape_of(without), shape_of(with));
}

TEST(ColorsWithWeight, AreTheSameOnAnyNumberOfThreadsAndInAnyScale) {
  std::vector<Shape> results;
  for (int threads : {1, 2, 3}) {
    RichMesh mesh;
    fill_with_stripes(mesh, 6);
    if (threads == 3)
      for (RichVertex& v : mesh.vert) v.P() *= 1024.0;
    EdgeCollapseParams params = weighed(4000, 0.01, Preset::Best);
    params.threads = threads;
    decimate(mesh, params);
    results.push_back(scaled(shape_of(mesh), threads == 3 ? 1.0 / 1024.0 : 1.0));
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

}  // namespace
}  // namespace curvdecim::test
