// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/attributes/wedge_texture.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"

namespace curvdecim::test {

using namespace detail;

namespace {

constexpr double other_chart = 10.0;  // added to u right of the middle

/// u = x and v = y, in one chart or cut at x = 0.5.
std::vector<FaceWedges> wedges_of(const WorkingMesh& mesh, bool cut) {
  std::vector<FaceWedges> wedges(mesh.plane.size());
  for (std::size_t f = 0; f < wedges.size(); ++f) {
    const Triangle t = mesh.triangle(static_cast<int>(f));
    const bool other = cut && (t[0].x() + t[1].x() + t[2].x()) / 3.0 > 0.5;
    for (int i = 0; i < 3; ++i)
      wedges[f][i] = {t[i].x() + (other ? other_chart : 0.0), t[i].y(), other ? 1 : 0};
  }
  return wedges;
}

/// A 4 x 4 grid of which one edge is collapsed.
class WedgeTextureOf : public testing::Test {
 protected:
  void collapse(int keep, int gone, const Vector3& now, bool cut) {
    WedgeTexture texture(wedges_of(mesh_, cut));
    EdgeNeighborhood around;
    around.gather(mesh_.connectivity, {std::min(keep, gone), std::max(keep, gone)});
    texture.before(mesh_, around, {keep, gone, mesh_.position[keep], mesh_.position[gone], now, 0},
                   0);
    star_ = around.star();
    mesh_.connectivity.collapse(keep, gone);
    for (int f = 0; f < mesh_.connectivity.face_slots(); ++f) after_.push_back(texture.of_face(f));
  }

  /// By face of the star: the wedge at `v`.
  std::vector<WedgeCoordinate> at_vertex(int v) const {
    std::vector<WedgeCoordinate> corners;
    for (int f : star_)
      if (mesh_.connectivity.alive(f) && mesh_.connectivity.face_has(f, v))
        corners.push_back(after_[f][mesh_.connectivity.corner(f, v)]);
    return corners;
  }

  WorkingMesh mesh_ = working_mesh(plane_grid(4));
  std::vector<int> star_;
  std::vector<FaceWedges> after_;
};

TEST_F(WedgeTextureOf, OneChartFollowsTheSurface) {
  collapse(12, 17, {0.6, 0.45, 0.2}, false);  // above the surface, off the edge
  ASSERT_FALSE(at_vertex(12).empty());
  for (const WedgeCoordinate& corner : at_vertex(12)) {
    EXPECT_NEAR(corner.u, 0.6, 1e-15);
    EXPECT_NEAR(corner.v, 0.45, 1e-15);
  }
}

TEST_F(WedgeTextureOf, TwoChartsDoNotMixAlongTheirSeam) {
  collapse(11, 12, {0.5, 0.375, 0.0}, true);
  int left = 0, right = 0;
  for (const WedgeCoordinate& corner : at_vertex(11)) {
    ++(corner.page == 1 ? right : left);
    EXPECT_NEAR(corner.u, corner.page == 1 ? 0.5 + other_chart : 0.5, 1e-15);
    EXPECT_NEAR(corner.v, 0.375, 1e-15);
  }
  EXPECT_GT(left, 0);
  EXPECT_GT(right, 0);
}

TEST_F(WedgeTextureOf, TwoChartsDoNotMixAcrossTheirSeam) {
  collapse(12, 17, {0.6, 0.5, 0.0}, true);
  int left = 0;
  for (const WedgeCoordinate& corner : at_vertex(12)) {
    if (corner.page == 0) ++left;
    // The left chart ends at the seam; the right one has the place.
    EXPECT_NEAR(corner.u, corner.page == 1 ? 0.6 + other_chart : 0.5, 1e-15);
    EXPECT_NEAR(corner.v, 0.5, 1e-15);
  }
  EXPECT_GT(left, 0);
}

TEST_F(WedgeTextureOf, ACornerOfAVertexThatStaysKeepsItsBits) {
  mesh_ = working_mesh(rotated(plane_grid(4), 1.0, {1, 2, 3}));
  const std::vector<FaceWedges> before = wedges_of(mesh_, false);
  const TriangleConnectivity was = mesh_.connectivity;
  collapse(12, 17, mesh_.position[12], false);
  for (int f = 0; f < was.face_slots(); ++f)
    for (int i = 0; i < 3; ++i) {
      if (was.face(f)[i] == 17) continue;
      EXPECT_EQ(after_[f][i], before[f][i]) << f << ' ' << i;
    }
}

/// Otherwise a rounding error tears the chart: it is known by equal coordinates at a vertex.
TEST_F(WedgeTextureOf, CornersThatCameToAVertexThatStaysAreBitwiseTheSame) {
  for (double angle : {0.3, 1.0, 2.2}) {
    mesh_ = working_mesh(rotated(plane_grid(4), angle, {1, 2, 3}));
    after_.clear();
    const int f = *mesh_.connectivity.faces_of(12).begin();
    const WedgeCoordinate expected = wedges_of(mesh_, false)[f][mesh_.connectivity.corner(f, 12)];
    collapse(12, 17, mesh_.position[12], false);
    for (const WedgeCoordinate& corner : at_vertex(12)) {
      EXPECT_EQ(corner.u, expected.u);
      EXPECT_EQ(corner.v, expected.v);
    }
  }
}

}  // namespace
}  // namespace curvdecim::test
