// SPDX-License-Identifier: GPL-3.0-or-later
// The refinement brings both surfaces closer and keeps all that the collapses kept.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/decimation.h"
#include "support/fingerprint.h"
#include "support/mesh_group.h"
#include "support/properties.h"
#include "support/rich_mesh.h"

namespace curvdecim::test {
namespace {

EdgeCollapseParams with_sweeps(int sweeps, int faces) {
  EdgeCollapseParams params = to_faces(faces);
  params.preset = Preset::Custom;
  params.refine_sweeps = sweeps;
  params.preserve_topology = true;
  return params;
}

constexpr int sweeps = 4;

Shape plain(const Shape& shape, int faces) { return decimated(shape, with_sweeps(0, faces)).shape; }
Shape refined(const Shape& shape, int faces) {
  return decimated(shape, with_sweeps(sweeps, faces)).shape;
}

// --- on any mesh ---------------------------------------------------------------------------------

class Refined : public testing::TestWithParam<NamedShape> {
 protected:
  const Shape& before_ = GetParam().shape;
  const int target_ = before_.face_count() / 3;
};

TEST_P(Refined, KeepsTopologyAndCounts) {
  const Shape expected = plain(before_, target_), after = refined(before_, target_);
  EXPECT_PRED2(keeps_topology, topology(before_), topology(after));
  EXPECT_TRUE(all_finite(after));
  EXPECT_EQ(after.face_count(), expected.face_count());
  EXPECT_EQ(after.vertex_count(), expected.vertex_count());
}

TEST_P(Refined, FlipsNoMoreFaces) {
  EXPECT_LE(flipped_faces(before_, refined(before_, target_)),
            flipped_faces(before_, plain(before_, target_)));
}

TEST_P(Refined, IsNoFurtherFromTheInput) {
  const double nothing = 1e-9 * diagonal(before_);
  EXPECT_LE(two_sided_rms(before_, refined(before_, target_)),
            1.001 * two_sided_rms(before_, plain(before_, target_)) + nothing);
}

TEST_P(Refined, GivesTheSameBitsOnAnyNumberOfThreads) {
  EdgeCollapseParams params = with_sweeps(sweeps, target_);
  params.threads = 1;
  const Shape expected = decimated(before_, params).shape;
  for (int threads : {2, 3, 8}) {
    params.threads = threads;
    EXPECT_EQ(decimated(before_, params).shape, expected) << threads << " threads";
  }
}

TEST_P(Refined, ScalesByAPowerOfTwoToTheBit) {
  const Shape expected = refined(before_, target_);
  for (int exponent : {-60, 7}) {
    const double factor = std::ldexp(1.0, exponent);
    EXPECT_EQ(refined(scaled(before_, factor), target_), scaled(expected, factor));
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, Refined, testing::ValuesIn(all_meshes()), name_of);

TEST(Refinement, OfALargeMeshGivesTheSameBitsOnAnyNumberOfThreads) {
  const Shape before = noisy_sphere(5, 0.01);
  EdgeCollapseParams params = with_sweeps(2, 4000);
  params.threads = 1;
  const Shape expected = decimated(before, params).shape;
  for (int threads : {2, 5}) {
    params.threads = threads;
    EXPECT_EQ(decimated(before, params).shape, expected) << threads << " threads";
  }
}

// --- what it gains -------------------------------------------------------------------------------

TEST(Refinement, LowersTheErrorOfCurvedSurfaces) {
  for (const NamedShape& mesh :
       {NamedShape{"sphere", icosphere(3)}, NamedShape{"torus", torus(48, 24)},
        NamedShape{"bumpy", bumpy_sphere(3)}, NamedShape{"saddle", saddle(24)}}) {
    const int target = mesh.shape.face_count() / 5;
    EXPECT_LT(two_sided_rms(mesh.shape, refined(mesh.shape, target)),
              0.95 * two_sided_rms(mesh.shape, plain(mesh.shape, target)))
        << mesh.name;
  }
}

TEST(Refinement, IsPartOfBest) {
  const Shape shape = bumpy_sphere(3);
  EdgeCollapseParams params = to_faces(200);
  params.preset = Preset::Best;
  const Shape best = decimated(shape, params).shape;
  params.preset = Preset::Balanced;
  EXPECT_LT(two_sided_rms(shape, best),
            0.95 * two_sided_rms(shape, decimated(shape, params).shape));
}

// --- what must stay ------------------------------------------------------------------------------

TEST(Refinement, LeavesAFlatMeshAsItIs) {
  EXPECT_EQ(refined(plane_grid(12), 40), plain(plane_grid(12), 40));
}

TEST(Refinement, KeepsTheCornersAndSidesOfABox) {
  const Shape box = dense_box(6, {1, 2, 3}), after = refined(box, 60);
  int corners = 0;
  for (const Point& p : after.vertices) {
    bool on_side = false, at_corner = true;
    for (int k = 0; k < 3; ++k) {
      const bool at_end = std::min(std::abs(p[k]), std::abs(p[k] - (k + 1.0))) < 1e-9;
      on_side = on_side || at_end, at_corner = at_corner && at_end;
    }
    EXPECT_TRUE(on_side) << p.transpose();
    corners += at_corner;
  }
  EXPECT_EQ(corners, 8);
}

/// The input, and what the collapses alone make of it and the collapses with the sweeps of Best.
struct Compared {
  Shape input, collapsed, refined;

  Compared(const Shape& shape, int faces) : input(shape) {
    EdgeCollapseParams params = to_faces(faces);
    params.preset = Preset::Balanced, params.preserve_topology = false;
    collapsed = decimated(shape, params).shape;
    params.preset = Preset::Best;
    refined = decimated(shape, params).shape;
  }
};

TEST(Refinement, LeavesAnExactResultExact) {
  const auto expect_exact = [](const Shape& shape, int faces) {
    const Compared result(shape, faces);
    const double nothing = 1e-12 * diagonal(shape);
    EXPECT_LT(two_sided_rms(shape, result.collapsed), nothing) << faces << " faces";
    EXPECT_LT(two_sided_rms(shape, result.refined), nothing) << faces << " faces";
  };
  for (int faces : {60, 90, 124, 180}) expect_exact(dense_box(24, {50, 50, 6}), faces);
  for (int faces : {500, 1000}) expect_exact(book(25, 10), faces);  // pages near each other
}

TEST(Refinement, MovesNoVertexFurtherOutThanTheCollapsesDid) {
  for (int subdivisions : {2, 3}) {
    Shape shape = icosphere(subdivisions);
    for (int f = 0, end = shape.face_count(); f < end; f += 3) {
      const auto [a, b, c] = shape.faces[f];
      shape.faces.push_back({c, b, a});
    }
    const Compared result(shape, shape.face_count() / 5);
    const double reach = 1.0 + two_sided_distance(shape, result.collapsed);
    for (const Point& p : result.refined.vertices)
      EXPECT_LT(p.cwiseAbs().maxCoeff(), reach) << p.transpose();
  }
}

TEST(Refinement, DoesNotPullAtTheBordersOfClosedHoles) {
  constexpr int cells = 48;
  Shape shape = plane_grid(cells);
  const auto is_in_hole = [&](const Corners& face) {
    const auto [a, b, c] = corners_of(shape, face);
    const Point center = (a + b + c) / 3.0 * cells;
    return static_cast<int>(center.x()) % 4 == 1 && static_cast<int>(center.y()) % 4 == 1;
  };
  shape.faces.erase(std::remove_if(shape.faces.begin(), shape.faces.end(), is_in_hole),
                    shape.faces.end());
  for (int part : {10, 20}) {
    const Compared result(shape, shape.face_count() / part);
    EXPECT_LT(two_sided_rms(shape, result.refined), 1.05 * two_sided_rms(shape, result.collapsed))
        << "1 of " << part;
  }
}

TEST(Refinement, KeepsBordersOnTheirCurve) {
  const Shape cylinder = open_cylinder(48, 12), after = refined(cylinder, 300);
  double low = 0.0, high = 0.0;
  for (const Point& p : cylinder.vertices) low = std::min(low, p.z()), high = std::max(high, p.z());
  int at_ends = 0, near_ends = 0;
  for (const Point& p : after.vertices) {
    at_ends += std::min(p.z() - low, high - p.z()) < 1e-9;
    near_ends += std::min(p.z() - low, high - p.z()) < 0.02 * (high - low);
  }
  EXPECT_GE(at_ends, 16);
  EXPECT_EQ(at_ends, near_ends);
}

TEST(Refinement, IsNotDoneWhereOnlyOriginalVerticesMayRemain) {
  const Shape shape = noisy_sphere(3, 0.02);
  EdgeCollapseParams params = with_sweeps(0, 300);
  params.placement = Placement::HalfEdge;
  const Shape expected = decimated(shape, params).shape;
  params.refine_sweeps = sweeps;
  EXPECT_EQ(decimated(shape, params).shape, expected);
}

/// Within a bound it brings the surfaces closer, too, and changes no edge.
TEST(Refinement, StaysWithinAnErrorBound) {
  for (const Shape& shape : {noisy_sphere(3, 0.02), bumpy_sphere(3), saddle(16), torus(24, 12)}) {
    EdgeCollapseParams params = with_sweeps(0, 4);
    params.max_error = 0.01 * diagonal(shape);
    const Shape collapsed = decimated(shape, params).shape;
    params.refine_sweeps = sweeps;
    const auto [refined, report] = decimated(shape, params);
    EXPECT_EQ(refined.faces, collapsed.faces);
    EXPECT_LT(two_sided_rms(shape, refined), 0.97 * two_sided_rms(shape, collapsed));
    EXPECT_LE(sampled_distance(shape, refined), report.max_error * (1.0 + 1e-9));
    EXPECT_LE(report.max_error, params.max_error);
  }
}

TEST(Refinement, IsSoundWhereNothingIsLeft) {
  EdgeCollapseParams params = with_sweeps(sweeps, 0);
  params.pair_distance = 1e-3, params.preserve_normal = false;  // no link condition
  EXPECT_EQ(decimated(octahedron(), params).shape.face_count(), 0);
}

TEST(Refinement, LeavesFacesOutsideTheSelectionAsTheyAre) {
  const Shape shape = scaled(translated(bumpy_sphere(3), {1.5, 1.5, 1.5}), 0.3);
  RichMesh mesh;
  fill_with_attributes(mesh, shape);
  const int selected = select_faces(mesh, [](const vcg::Point3d& p) { return p[0] < 0.45; });
  const auto outside = [&] {
    std::multiset<std::string> faces;
    for (const RichFace& f : mesh.face)
      if (!f.IsD() && !f.IsS()) faces.insert(bytes_of(f));
    return faces;
  };
  const auto before = outside();
  EdgeCollapseParams params = with_sweeps(sweeps, selected / 3);
  params.selected_only = true;
  decimate(mesh, params);
  EXPECT_EQ(outside(), before);
}

TEST(Refinement, CancelledLeavesTheMeshAsItWas) {
  const Shape shape = scaled(translated(noisy_sphere(4, 0.01), {1.5, 1.5, 1.5}), 0.3);
  RichMesh mesh;
  fill_with_attributes(mesh, shape);
  const std::string before = bytes_of(mesh);
  bool seen = false;
  const DecimationReport report =
      decimate(mesh, with_sweeps(sweeps, 800), [&](int percent, const char* stage) {
        seen = std::string(stage) == "Refining" && percent >= 50;
        return !seen;
      });
  EXPECT_TRUE(seen);
  EXPECT_EQ(report.stopped_by, StopReason::Cancelled);
  EXPECT_EQ(bytes_of(mesh), before);
}

// --- attributes ----------------------------------------------------------------------------------

/// Within the unit cube, with smooth attributes.
void fill_sphere(RichMesh& mesh) {
  fill_with_attributes(mesh, scaled(translated(bumpy_sphere(4), {1.5, 1.5, 1.5}), 1.0 / 3.0));
}

TEST(Refinement, TakesVertexAttributesFromTheNearestPointOfTheInput) {
  RichMesh mesh;
  fill_sphere(mesh);
  decimate(mesh, with_sweeps(sweeps, mesh.fn / 10));
  for (const RichVertex& v : mesh.vert) {
    if (v.IsD()) continue;
    EXPECT_NEAR(v.cQ(), affine(v.cP()), 0.02);
    EXPECT_NEAR(v.cT().u(), v.cP()[0], 0.02);
    EXPECT_NEAR(v.cC()[0], 255.0 * affine(v.cP()), 6.0);
    EXPECT_NEAR(v.cN().Norm(), 1.0, 1e-6);
  }
}

TEST(Refinement, CarriesWedgeTextures) {
  RichMesh mesh;
  fill_sphere(mesh);
  decimate(mesh, with_sweeps(sweeps, mesh.fn / 10));
  for (const RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(f.cWT(i).u(), f.cP(i)[0], 0.04);
      EXPECT_NEAR(f.cWT(i).v(), f.cP(i)[1], 0.04);
    }
}

TEST(Refinement, KeepsSeamsOfATextureWhereTheyAreAndDoesNotMixItsPages) {
  const auto decimated_with = [](int times) {
    RichMesh mesh;
    fill_sphere(mesh);
    for (RichFace& f : mesh.face) {
      const bool right = (f.cP(0) + f.cP(1) + f.cP(2))[0] > 1.5;
      for (int i = 0; i < 3 && right; ++i) f.WT(i).u() += 10.0, f.WT(i).n() = 1;
    }
    decimate(mesh, with_sweeps(times, mesh.fn / 10));
    int on_seam = 0;
    for (const RichVertex& v : mesh.vert) {
      std::set<short> pages;
      for (const RichFace& f : mesh.face)
        for (int i = 0; i < 3; ++i)
          if (f.cV(i) == &v) pages.insert(f.cWT(i).n());
      if (pages.size() < 2) continue;
      ++on_seam;
      EXPECT_NEAR(v.cP()[0], 0.5, 0.05);  // that of the input is as rough
    }
    for (const RichFace& f : mesh.face)
      for (int i = 0; i < 3; ++i) EXPECT_EQ(f.cWT(i).u() > 5.0, f.cWT(i).n() == 1);
    return on_seam;
  };
  const int without = decimated_with(0);
  EXPECT_GT(without, 8);
  EXPECT_EQ(decimated_with(sweeps), without);
}

}  // namespace
}  // namespace curvdecim::test
