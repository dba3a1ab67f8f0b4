// SPDX-License-Identifier: GPL-3.0-or-later
// keep_borders_of: the borders between groups of faces stay where they are.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "support/custom_mesh.h"
#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/removal.h"

namespace curvdecim::test {
namespace {

/// A wavy sheet over the unit square.
Shape sheet() {
  Shape shape = plane_grid(40);
  for (Point& p : shape.vertices) p.z() = 0.1 * std::sin(7.0 * p.x()) * std::cos(5.0 * p.y());
  return shape;
}

/// Whether the centre of a face is inside a circle.
bool is_inside(const RichFace& f) {
  const vcg::Point3d center = (f.cP(0) + f.cP(1) + f.cP(2)) / 3.0;
  return std::hypot(center[0] - 0.5, center[1] - 0.5) < 0.3;
}

void mark_inside(CustomMesh& mesh) {
  auto label = vcg::tri::Allocator<RichMesh>::AddPerFaceAttribute<int>(mesh, "label");
  for (RichFace& f : mesh.face) {
    f.C() = is_inside(f) ? vcg::Color4b(255, 0, 0, 255) : vcg::Color4b(0, 0, 255, 255);
    f.Q() = label[f] = is_inside(f) ? 7 : -2;
    for (int i = 0; i < 3; ++i) f.WT(i).u() = f.WT(i).v() = 0;
  }
}

/// The area of the faces with the mark, seen from above.
double marked_area(const CustomMesh& mesh) {
  double sum = 0.0;
  for (const RichFace& f : mesh.face)
    if (f.cQ() == 7.0) sum += 0.5 * ((f.cP(1) - f.cP(0)) ^ (f.cP(2) - f.cP(0)))[2];
  return sum;
}

void decimate_edges(RichMesh& mesh, KeepBordersOf by, int faces) {
  EdgeCollapseParams params = to_faces(faces);
  params.keep_borders_of = by;
  decimate(mesh, params);
}
void remove_vertices(RichMesh& mesh, KeepBordersOf by, int faces) {
  VertexRemovalParams params = removal_to(faces);
  params.keep_borders_of = by;
  remove(mesh, params);
}

using Decimate = std::function<void(RichMesh&, KeepBordersOf, int faces)>;

class KeepBorders : public testing::TestWithParam<Decimate> {
 protected:
  /// How much of the marked area is gone or new, as a share.
  double change_of_area(KeepBordersOf by) {
    CustomMesh mesh(sheet());
    mark_inside(mesh);
    const double before = marked_area(mesh);
    GetParam()(mesh, by, 200);
    return std::abs(marked_area(mesh) / before - 1.0);
  }

  /// The length of the border of the marked area, as a share of that before.
  double length_of_border(KeepBordersOf by) {
    CustomMesh mesh(sheet());
    mark_inside(mesh);
    const double before = border_length(mesh);
    GetParam()(mesh, by, 200);
    return border_length(mesh) / before;
  }

 private:
  /// Sums up the edges between a marked face and another one.
  static double border_length(const CustomMesh& mesh) {
    double sum = 0.0;
    for (const RichFace& f : mesh.face)
      for (const RichFace& g : mesh.face)
        for (int i = 0; i < 3 && f.cQ() > g.cQ(); ++i)
          for (int j = 0; j < 3; ++j)
            if (f.cV(i) == g.cV((j + 1) % 3) && f.cV((i + 1) % 3) == g.cV(j))
              sum += (f.cP(i) - f.cP((i + 1) % 3)).Norm();
    return sum;
  }
};

TEST_P(KeepBorders, OfAColourKeepTheirArea) {
  EXPECT_LT(change_of_area(KeepBordersOf::FaceColor), 0.003);
  EXPECT_LT(length_of_border(KeepBordersOf::FaceColor), 1.0);
}

TEST_P(KeepBorders, OfAQualityKeepTheirArea) {
  EXPECT_LT(change_of_area(KeepBordersOf::FaceQuality), 0.003);
  EXPECT_LT(length_of_border(KeepBordersOf::FaceQuality), 1.0);
}

TEST_P(KeepBorders, OfALabelKeepTheirArea) {
  EXPECT_LT(change_of_area(KeepBordersOf::FaceAttributes), 0.003);
  EXPECT_LT(length_of_border(KeepBordersOf::FaceAttributes), 1.0);
}

/// Otherwise the tests above say nothing.
TEST_P(KeepBorders, ShiftWhereNobodyAsks) {
  EXPECT_GT(change_of_area(KeepBordersOf::Nothing), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Filters, KeepBorders, testing::Values(decimate_edges, remove_vertices));

TEST(KeepBordersOfNothingThatIsThere, IsTheSameAsNotAsking) {
  CustomMesh with(sheet()), without(sheet());
  decimate_edges(with, KeepBordersOf::FaceAttributes, 300);
  decimate_edges(without, KeepBordersOf::Nothing, 300);
  EXPECT_EQ(shape_of(with), shape_of(without));
}

}  // namespace
}  // namespace curvdecim::test
