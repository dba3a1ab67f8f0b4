// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex clustering on every kind of mesh: soundness, the bound, the target.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <tuple>

#include "support/clustering.h"
#include "support/mesh_group.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

using Case = std::tuple<NamedShape, NamedRepresentative>;

std::string case_name(const testing::TestParamInfo<Case>& info) {
  return std::get<0>(info.param).name + "_" + std::get<1>(info.param).name;
}

class Clustering : public testing::TestWithParam<Case> {
 protected:
  const Shape& shape() const { return std::get<0>(GetParam()).shape; }
  ClusteringParams with_cells(double fraction) const {
    return std::get<1>(GetParam()).of(test::with_cells(fraction * diagonal(shape())));
  }
};

constexpr double cell_sizes[] = {0.05, 0.15, 0.3};  // of the diagonal

TEST_P(Clustering, LeavesASoundMesh) {
  for (double size : cell_sizes) {
    const Shape after = clustered(shape(), with_cells(size)).shape;
    expect_sound_clusters(after);
    EXPECT_LE(after.face_count(), shape().face_count());
  }
}

/// No vertex moves further than the bound, so no point of a face that is left does.
TEST_P(Clustering, StaysWithinItsBoundOfTheInput) {
  for (double size : cell_sizes) {
    const ClusteringParams params = with_cells(size);
    const auto [after, report] = clustered(shape(), params);
    EXPECT_LE(report.largest_move, params.cell_size * (1.0 + 1e-12));
    EXPECT_NEAR(report.cell_size, params.cell_size, 1e-12 * params.cell_size);
    for (const Corners& f : after.faces) {
      const auto [a, b, c] = corners_of(after, f);
      for (const Point& p : {a, b, c, Point((a + b) / 2), Point((a + b + c) / 3)})
        ASSERT_LE(distance_to(shape(), p), report.largest_move * (1.0 + 1e-9) + 1e-15);
    }
  }
}

TEST_P(Clustering, StaysInTheBoundingBox) {
  Point low = shape().vertices[0], high = low;
  for (const Point& p : shape().vertices) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double rounding = 4e-16 * (diagonal(shape()) + low.norm());
  for (double size : cell_sizes)
    for (const Point& p : clustered(shape(), with_cells(size)).shape.vertices)
      EXPECT_LE((p.cwiseMax(low).cwiseMin(high) - p).norm(), rounding);
}

TEST_P(Clustering, OfTinyCellsKeepsTheBits) {
  if (std::get<1>(GetParam()).representative == Representative::CellCenter) return;
  if (std::get<0>(GetParam()).name == "klein_bottle") return;  // it meets itself in vertices
  EXPECT_EQ(clustered(shape(), with_cells(1e-4)).shape, shape());
}

TEST_P(Clustering, CountsEveryFace) {
  for (double size : cell_sizes) {
    const ClusteringReport report = clustered(shape(), with_cells(size)).report;
    EXPECT_EQ(report.faces_before, shape().face_count());
    EXPECT_EQ(report.faces + report.degenerate + report.duplicate + report.crowded,
              report.faces_before);
  }
}

TEST_P(Clustering, LeavesNoCrowdedEdgeOnRequest) {
  for (double size : cell_sizes) {
    ClusteringParams params = with_cells(size);
    const int all = clustered(shape(), params).shape.face_count();
    params.manifold_edges = true;
    const auto [after, report] = clustered(shape(), params);
    EXPECT_EQ(topology(after).nonmanifold_edges, 0);
    EXPECT_EQ(topology(after).unreferenced_vertices, 0);
    EXPECT_EQ(after.face_count(), all - report.crowded);
  }
}

/// The strip is narrower than the cells.
std::vector<NamedShape> all_but_the_strip() {
  std::vector<NamedShape> meshes = all_meshes();
  const auto is_strip = [](const NamedShape& mesh) { return mesh.name == "triangle_strip"; };
  meshes.erase(std::remove_if(meshes.begin(), meshes.end(), is_strip), meshes.end());
  return meshes;
}

INSTANTIATE_TEST_SUITE_P(Drawn, Clustering,
                         testing::Combine(testing::ValuesIn(all_but_the_strip()),
                                          testing::ValuesIn(shape_representatives())),
                         case_name);

// --- target
// ----------------------------------------------------------------------------------------

class ClusteringTarget : public testing::TestWithParam<NamedShape> {};

TEST_P(ClusteringTarget, IsMetWithinTwoPercentOrTheMissIsSaid) {
  const Shape& shape = GetParam().shape;
  for (double fraction : {0.5, 0.2, 0.05}) {
    const int target = static_cast<int>(fraction * shape.face_count());
    const auto [after, report] = clustered(shape, to_clusters(target));
    const bool met = std::abs(after.face_count() - target) <= 0.02 * target;
    EXPECT_EQ(report.stopped_by, met ? StopReason::Target : StopReason::NothingLeft);
    EXPECT_EQ(report.notes.empty(), met);
    EXPECT_GT(after.face_count(), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, ClusteringTarget, testing::ValuesIn(manifold_meshes()), name_of);

class ClusteringTargetOfMany : public testing::TestWithParam<NamedShape> {};

TEST_P(ClusteringTargetOfMany, IsMetWithinTwoPercent) {
  const Shape& shape = GetParam().shape;
  for (double fraction : {0.7, 0.3, 0.1, 0.02}) {
    const int target = static_cast<int>(fraction * shape.face_count());
    ClusteringParams params;
    params.target_fraction = fraction;
    for (bool manifold : {false, true}) {
      params.manifold_edges = manifold;
      const auto [after, report] = clustered(shape, params);
      EXPECT_NEAR(after.face_count(), target, 0.02 * target) << fraction;
      EXPECT_EQ(report.stopped_by, StopReason::Target);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, ClusteringTargetOfMany,
                         testing::Values(NamedShape{"noisy_sphere", noisy_sphere(5, 0.01)},
                                         NamedShape{"bumpy_sphere", bumpy_sphere(5)},
                                         NamedShape{"turned_torus",
                                                    rotated(torus(120, 60), 0.7, {1, 2, 3})}),
                         name_of);

TEST(ClusteringTarget, OfOneFaceGivesTheNearest) {
  const auto [after, report] = clustered(icosphere(3), to_clusters(1));
  EXPECT_GT(after.face_count(), 0);
  EXPECT_LT(after.face_count(), 20);
  EXPECT_EQ(report.stopped_by, StopReason::NothingLeft);
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes[0].find("than " + std::to_string(after.face_count())), std::string::npos);
}

TEST(ClusteringTarget, WinsOverTheSizeOfACell) {
  ClusteringParams params = to_clusters(400), alone = params;
  params.cell_size = 0.9;
  EXPECT_EQ(clustered(bumpy_sphere(3), params).shape, clustered(bumpy_sphere(3), alone).shape);
}

TEST(ClusteringTarget, NotBelowTheCountLeavesTheMeshAndSaysSo) {
  const Shape shape = bumpy_sphere(2);
  for (int target : {shape.face_count(), shape.face_count() + 1}) {
    const auto [after, report] = clustered(shape, to_clusters(target));
    EXPECT_EQ(after, shape);
    EXPECT_EQ(report.stopped_by, StopReason::Target);
    ASSERT_FALSE(report.notes.empty());
    EXPECT_EQ(report.notes[0], "Nothing to do: the mesh has 320 faces already, the target is " +
                                   std::to_string(target) + ".");
  }
}

// --- orientation
// -----------------------------------------------------------------------------------

class ClusteringOf : public testing::TestWithParam<NamedRepresentative> {};

/// Where a corner of a cell only just meets the surface, a sliver may fold over.
TEST_P(ClusteringOf, ADenseSphereKeepsItsOrientation) {
  const Shape sphere = icosphere(5);
  const Shape after = clustered(sphere, GetParam().of(to_clusters(1500))).shape;
  EXPECT_EQ(topology(after).inconsistent_edges, 0);
  if (GetParam().representative == Representative::CellCenter) return;
  EXPECT_LE(flipped_faces(sphere, after), 0.02 * after.face_count());
}

TEST_P(ClusteringOf, MergesTheSidesOfAThinPlateIntoOne) {
  Shape plate = dense_box(8, {1, 1, 0.01});
  const Shape after = clustered(plate, GetParam().of(with_cells(0.4))).shape;
  EXPECT_GT(after.face_count(), 0);
  EXPECT_EQ(topology(after).duplicate_faces, 0);
}

INSTANTIATE_TEST_SUITE_P(All, ClusteringOf, testing::ValuesIn(shape_representatives()),
                         representative_name);

// --- what the representatives are for
// --------------------------------------------------------------

double rms_of(const Shape& shape, const ClusteringParams& params) {
  return two_sided_rms(shape, clustered(shape, params).shape);
}

TEST(QuadricRepresentative, HasTheLowestError) {
  for (const Shape& shape : {bumpy_sphere(4), torus(64, 32), dense_box(16, {1, 2, 3}), saddle(40)})
    for (double fraction : {0.2, 0.05}) {
      ClusteringParams params;
      params.target_fraction = fraction;
      const double quadric = rms_of(shape, params);
      for (const NamedRepresentative& other : shape_representatives()) {
        if (other.representative == Representative::Quadric) continue;
        EXPECT_LT(quadric, rms_of(shape, other.of(params))) << other.name;
      }
    }
}

TEST(BoundaryWeight, HoldsTheOutline) {
  const Shape ring = annulus(128, 16);
  ClusteringParams params = to_clusters(300), without = params;
  without.boundary_weight = 0.0;
  const auto lost = [&](const ClusteringParams& p) {
    return std::abs(area(clustered(ring, p).shape) - area(ring));
  };
  EXPECT_LT(lost(params), 0.5 * lost(without));
}

TEST(WeightedMean, IsDrawnToWhatWeighs) {
  RichMesh plain, painted;
  for (RichMesh* mesh : {&plain, &painted}) {
    fill(*mesh, plane_grid(16));
    for (RichVertex& v : mesh->vert) v.Q() = mesh == &painted ? std::exp(9.0 * v.cP()[0]) : 1.0;
  }
  ClusteringParams params = with_cells(0.35);
  params.representative = Representative::WeightedMean;
  params.mean_weight = MeanWeight::Quality;
  cluster(plain, params), cluster(painted, params);
  ASSERT_EQ(plain.vn, painted.vn);
  for (int v = 0; v < plain.vn; ++v) {
    EXPECT_GT(painted.vert[v].cP()[0], plain.vert[v].cP()[0]);
    EXPECT_NEAR(painted.vert[v].cP()[1], plain.vert[v].cP()[1], 1e-6);
  }
}

TEST(WeightedMean, ByAreaDoesNotFollowTheTessellation) {
  const auto squeezed = [](const Point& p) { return Point(p.x() * p.x(), p.y(), p.z()); };
  const Shape even = plane_grid(48), uneven = mapped(plane_grid(48), squeezed);
  ClusteringParams params = with_cells(0.5);
  const auto mean_x = [](const Shape& shape) {
    double sum = 0.0;
    for (const Point& p : shape.vertices) sum += p.x();
    return sum / shape.vertex_count();
  };
  params.representative = Representative::WeightedMean;
  const auto shift = [&] {
    return std::abs(mean_x(clustered(uneven, params).shape) -
                    mean_x(clustered(even, params).shape));
  };
  const double by_area = shift();
  params.representative = Representative::Mean;
  EXPECT_LT(by_area, 0.3 * shift());
}

TEST(MedianRepresentative, IsAnOriginalVertex) {
  ClusteringParams params = to_clusters(300);
  params.representative = Representative::Median;
  const Shape shape = rotated(bumpy_sphere(4), 0.6, {1, 2, 3});
  for (const Point& p : clustered(shape, params).shape.vertices)
    ASSERT_EQ(std::count(shape.vertices.begin(), shape.vertices.end(), p), 1);
}

TEST(Clustering, SaysSoWhereTheCellsAreTooSmallToJoinAnything) {
  ClusteringParams params;
  params.cell_size = 1e-3;
  const auto [after, report] = clustered(icosphere(2), params);
  EXPECT_EQ(report.faces, report.faces_before);
  EXPECT_EQ(report.stopped_by, StopReason::NothingLeft);
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes.back().find("larger cells"), std::string::npos);
  params.cell_size = 0.5;
  EXPECT_EQ(clustered(icosphere(2), params).report.stopped_by, StopReason::Target);
}

}  // namespace
}  // namespace curvdecim::test
