// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/seams.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/texture.h"
#include "support/working_mesh.h"
#include "vcg_ext/guard/collapse_rule.h"
#include "vcg_ext/mesh/charts.h"

namespace curvdecim::test {

namespace {

using Answer = std::optional<Allowed>;
constexpr Answer stays = std::nullopt;

/// A 4 x 4 grid, cut along its middle column (vertices 10 to 14) if at all.
WorkingMesh textured_grid(bool is_cut) {
  WorkingMesh mesh = working_mesh(plane_grid(4));
  give_plane_texture(mesh, is_cut ? 0.5 : 1e9);
  return mesh;
}

TEST(Seams, AreWhereFacesDoNotAgreeAboutACorner) {
  const WorkingMesh mesh = textured_grid(true);
  for (int v : {10, 11, 12, 13, 14}) EXPECT_TRUE(is_on_seam(mesh, v)) << v;
  EXPECT_FALSE(is_on_seam(mesh, 7));
  EXPECT_TRUE(is_seam_edge(mesh, Edge{11, 12}));
  EXPECT_FALSE(is_seam_edge(mesh, Edge{7, 12}));
}

TEST(Seams, AreNoneInOneChart) {
  WorkingMesh mesh = textured_grid(false);
  EXPECT_TRUE(mesh.on_seam.empty());
  EXPECT_FALSE(is_on_seam(mesh, 12));
  mesh.wedges = {};
  find_seams(mesh, Parallel(1));
  EXPECT_TRUE(mesh.on_seam.empty());
}

TEST(Seams, MayEndInsideAChart) {
  WorkingMesh mesh = working_mesh(plane_grid(4));
  give_slit_texture(mesh);
  EXPECT_TRUE(is_seam_edge(mesh, Edge{11, 12}));
  EXPECT_TRUE(is_on_seam(mesh, 12));
  EXPECT_FALSE(is_on_seam(mesh, 13));
}

TEST(Charts, AreCountedBetweenSeams) {
  EXPECT_EQ(find_charts(textured_grid(true)).count, 2);
  EXPECT_EQ(find_charts(textured_grid(false)).count, 1);
  WorkingMesh slit = working_mesh(plane_grid(4));
  give_slit_texture(slit);
  EXPECT_EQ(find_charts(slit).count, 1);
}

TEST(CollapseRule, LetsAChartGoOntoASeamAndASeamAlongItself) {
  const WorkingMesh mesh = textured_grid(true);
  const CollapseRule rule(mesh, {});
  EXPECT_EQ(rule({7, 12}), Allowed::Anywhere);
  EXPECT_EQ(rule({11, 12}), Allowed::Anywhere);
  EXPECT_EQ(rule({10, 11}), Allowed::OntoA);  // the border
  EXPECT_TRUE(rule.is_free(12));
  EXPECT_FALSE(rule.is_free(10));
  EXPECT_FALSE(rule.pinches({7, 12}));
  EXPECT_FALSE(rule.pinches({11, 12}));
}

TEST(CollapseRule, PinchesNoChartBetweenTwoSeams) {
  WorkingMesh mesh = working_mesh(plane_grid(4));
  give_texture(mesh, [&](int f, int i) {  // cut at x = 0.25 and 0.5
    const Triangle t = mesh.triangle(f);
    const double x = center_of(t).x();
    return Vector2(t[i].x() + (x > 0.5 ? 20.0 : x > 0.25 ? 10.0 : 0.0), t[i].y());
  });
  const CollapseRule rule(mesh, {});
  EXPECT_EQ(rule({7, 12}), stays);
  EXPECT_EQ(rule({11, 12}), Allowed::Anywhere);
  EXPECT_EQ(rule({12, 17}), Allowed::Anywhere);
}

}  // namespace
}  // namespace curvdecim::test
