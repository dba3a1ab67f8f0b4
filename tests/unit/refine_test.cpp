// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the refinement, each on its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/drawn_meshes.h"
#include "support/working_mesh.h"
#include "vcg_ext/refine/refine.h"

namespace curvdecim::test {

using namespace detail;

namespace {

const Parallel one_thread(1);

InputSurface surface_of(const Shape& shape) {
  return InputSurface(copy_input(working_mesh(shape), QuadricPlan(), one_thread));
}

WorkingMesh refined(const Shape& input, const Shape& mesh, int sweeps) {
  WorkingMesh result = working_mesh(mesh);
  const InputSurface surface = surface_of(input);
  Refinement(result, surface, CollapsePlan(), nullptr, one_thread).run(sweeps);
  return result;
}

Shape in_box(const Shape& shape) { return scaled(shape, 0.25); }

// --- samples -------------------------------------------------------------------------------------

TEST(FacePlaces, ArePartsOfOneSizeAfterTheCorners) {
  const FacePlaces places(8);
  for (int corner = 0; corner < 3; ++corner)
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(places[FacePlaces::of_corner(corner)][i], i == corner ? 1.0 : 0.0);
  EXPECT_EQ(places.first_of_parts(1), 3);
  for (int cuts : {1, 2, 3, 8}) {
    const int first = places.first_of_parts(cuts), count = cuts * cuts;
    if (cuts < 8) {
      EXPECT_EQ(places.first_of_parts(cuts + 1), first + count);
    }
    Barycentric sum{};
    for (int place = first; place < first + count; ++place)
      for (int i = 0; i < 3; ++i) {
        EXPECT_GT(places[place][i], 0.0);
        sum[i] += places[place][i] / count;
      }
    for (double mean : sum) EXPECT_NEAR(mean, 1.0 / 3.0, 1e-14);
  }
}

TEST(InputSamples, WeighAsMuchAsTheSurfaceAndLieOnTheFaceThatTheyMatch) {
  const InputSurface input = surface_of(in_box(bumpy_sphere(2)));
  const WorkingMesh mesh = working_mesh(in_box(bumpy_sphere(1)));
  const int faces = mesh.connectivity.face_slots();
  const double area = total_area(input);
  double weight = 0.0;
  InputSamples samples(input, area, faces, one_thread);
  samples.match(TriangleTree(mesh, faces, one_thread), faces, MatchLimits(area, faces), one_thread);
  for (int f = 0; f < faces; ++f)
    for (int i : samples.of_face(f)) {
      weight += samples.weight(i);
      const Match match = samples.match(mesh.triangle(f), i);
      const double distance2 = (at(mesh.triangle(f), match.at) - match.target).squaredNorm();
      EXPECT_NEAR(distance2, match.distance2, 1e-6 * distance2);
    }
  EXPECT_NEAR(weight, area, 1e-6 * area);
}

TEST(InputSurface, WeighsCurvedPlacesMoreAndOneInTheMean) {
  const WorkingMesh mesh = working_mesh(in_box(capped_cylinder(24, 12)));
  const InputSurface input(copy_input(mesh, CurvatureWeightedPlan(), one_thread));
  double sum = 0.0;
  for (int f = 0; f < input.face_count(); ++f) sum += input.weight[f] * input.area(f);
  EXPECT_NEAR(sum, total_area(input), 1e-6 * sum);
  const auto [least, largest] = std::minmax_element(input.weight.begin(), input.weight.end());
  EXPECT_LT(*least, 0.9 * *largest);
}

// --- fit -----------------------------------------------------------------------------------------

TEST(VertexFit, BringsAVertexBackToThePlane) {
  const Shape input = translated(scaled(plane_grid(12), 0.5), {-0.25, -0.25, 0.0});
  Shape mesh = translated(scaled(plane_grid(4), 0.5), {-0.25, -0.25, 0.0});
  mesh.vertices[12].z() = 0.03;  // the centre
  const WorkingMesh result = refined(input, mesh, 4);
  for (const Vector3& p : result.position) EXPECT_LT(std::abs(p.z()), 1e-3);
}

TEST(VertexFit, MovesNoLockedVertex) {
  const Shape input = in_box(icosphere(3)), mesh = in_box(icosphere(1));
  WorkingMesh result = working_mesh(mesh);
  result.locked[3] = 1;
  const InputSurface surface = surface_of(input);
  Refinement(result, surface, CollapsePlan(), nullptr, one_thread).run(2);
  EXPECT_EQ(result.position[3], mesh.vertices[3]);
  EXPECT_NE(result.position[4], mesh.vertices[4]);
}

TEST(VertexFit, BringsABorderBackToItsCurve) {
  const Shape input = in_box(open_cylinder(48, 12));
  Shape mesh = in_box(open_cylinder(12, 3));
  double top = 0.0;
  for (const Point& p : input.vertices) top = std::max(top, p.z());
  for (Point& p : mesh.vertices)
    if (p.z() == top) p.z() -= 0.02;
  const WorkingMesh result = refined(input, mesh, 5);
  int at_top = 0;
  for (const Vector3& p : result.position) at_top += std::abs(p.z() - top) < 1e-3;
  EXPECT_EQ(at_top, 12);
}

// --- flips ---------------------------------------------------------------------------------------

/// A saddle's cell has a better and a worse diagonal.
TEST(EdgeFlips, LowerTheErrorOfAMeshWithWrongDiagonals) {
  const auto error = [](const WorkingMesh& mesh, const InputSurface& input) {
    const TriangleTree tree(mesh, mesh.connectivity.face_slots(), one_thread);
    double sum = 0.0;
    for (const Vector3& p : input.position) sum += tree.nearest(p, SurfacePoint::none).distance2;
    return sum;
  };
  const Shape input = in_box(torus(96, 48));
  WorkingMesh mesh = working_mesh(in_box(torus(24, 12)));
  const InputSurface surface = surface_of(input);
  const int faces = mesh.connectivity.face_slots();
  const double area = total_area(surface);
  const TriangleTree input_tree(surface, surface.face_count(), one_thread);
  const TriangleTree mesh_tree(mesh, faces, one_thread);
  InputSamples of_input(surface, area, faces, one_thread);
  const MatchLimits limits(area, faces);
  of_input.match(mesh_tree, faces, limits, one_thread);
  MeshSamples of_mesh(surface, input_tree, area, faces);
  const std::vector<int> near(faces, SurfacePoint::none);
  of_mesh.match(mesh, near, limits, one_thread);
  const MoveGuard guard(mesh, surface, input_tree, FaceLimits());
  const TextureDrift no_texture(mesh, surface, 0.0);
  const double before = error(mesh, surface);
  EXPECT_GT(EdgeFlips(mesh, of_input, of_mesh, guard, no_texture, nullptr).run(near, one_thread),
            0);
  EXPECT_NO_THROW(mesh.connectivity.validate());
  EXPECT_LT(error(mesh, surface), before);
}

// --- guard ---------------------------------------------------------------------------------------

std::vector<Farthest> anywhere(const WorkingMesh& mesh) {
  return std::vector<Farthest>(mesh.position.size());
}

TEST(MoveGuard, LetsNoFaceFoldOver) {
  const Shape shape = in_box(icosphere(2));
  const WorkingMesh mesh = working_mesh(shape);
  const InputSurface input = surface_of(shape);
  const TriangleTree tree(input, input.face_count(), one_thread);
  const MoveGuard guard(mesh, input, tree, FaceLimits());
  const std::vector<int> near(mesh.plane.size(), SurfacePoint::none);
  for (const Vector3& pull : {Vector3(0.2, 0.0, 0.0), Vector3(0.0, -0.3, 0.1)}) {
    std::vector<Vector3> steps(mesh.position.size(), Vector3::Zero());
    steps[7] = pull, steps[20] = -pull;
    WorkingMesh moved = mesh;
    moved.position = guard.moved(steps, near, anywhere(mesh), one_thread);
    for (int f = 0; f < mesh.connectivity.face_slots(); ++f)
      EXPECT_GT(area_vector(moved.triangle(f)).dot(mesh.plane[f].normal), 0.0);
  }
}

const Shape flat_grid = translated(scaled(plane_grid(4), 0.5), {-0.25, -0.25, 0.0});

/// The centre of a flat grid, 0.125 from its neighbours, lifted as far as the guard lets it go.
/// farthest2: of the samples around it.
double lifted(double by, const FaceLimits& limits, const Shape& shape = flat_grid,
              double farthest2 = std::numeric_limits<double>::infinity()) {
  const WorkingMesh mesh = working_mesh(shape);
  const InputSurface input = surface_of(shape);
  const TriangleTree tree(input, input.face_count(), one_thread);
  std::vector<Vector3> steps(mesh.position.size(), Vector3::Zero());
  steps[12].z() = by;
  const std::vector<int> near(mesh.plane.size(), SurfacePoint::none);
  std::vector<Farthest> farthest = anywhere(mesh);
  farthest[12].distance2 = farthest2;
  return MoveGuard(mesh, input, tree, limits).moved(steps, near, farthest, one_thread)[12].z();
}

TEST(MoveGuard, CutsAStepToHalfTheShortestEdge) {
  EXPECT_EQ(lifted(0.05, FaceLimits()), 0.05);
  EXPECT_DOUBLE_EQ(lifted(0.1, FaceLimits()), 0.0625);
}

TEST(MoveGuard, HalvesAStepThatTurnsAFaceByMoreThanSixtyDegrees) {
  const Shape slanted =  // heights of 0.025 over the longest edges
      mapped(flat_grid, [](const Point& p) { return Point(p.x(), p.y() + 4.0 * p.x(), 0.0); });
  EXPECT_EQ(lifted(0.04, FaceLimits(), slanted), 0.04);
  EXPECT_EQ(lifted(0.05, FaceLimits(), slanted), 0.025);
}

TEST(MoveGuard, TakesBackAStepThatEndsTwiceAsFarOffAsTheSamplesWere) {
  EXPECT_EQ(lifted(0.03, FaceLimits(), flat_grid, 0.02 * 0.02), 0.03);
  EXPECT_EQ(lifted(0.05, FaceLimits(), flat_grid, 0.02 * 0.02), 0.0);
}

TEST(MoveGuard, TakesBackAStepThatTurnsAFaceByMoreThanTheNormalAngleFromTheInput) {
  FaceLimits limits;
  limits.normal_angle = 30.0;
  EXPECT_EQ(lifted(0.06, limits), 0.0);
  EXPECT_EQ(lifted(0.02, limits), 0.02);
  limits.keeps_normal = false;
  EXPECT_EQ(lifted(0.06, limits), 0.06);
}

TEST(MoveGuard, LetsAllOthersGo) {
  const Shape shape = in_box(icosphere(2));
  const WorkingMesh mesh = working_mesh(shape);
  const InputSurface input = surface_of(shape);
  const TriangleTree tree(input, input.face_count(), one_thread);
  const std::vector<int> near(mesh.plane.size(), SurfacePoint::none);
  const std::vector<Vector3> steps(mesh.position.size(), Vector3(0.01, 0.0, 0.0));
  const std::vector<Vector3> now =
      MoveGuard(mesh, input, tree, FaceLimits()).moved(steps, near, anywhere(mesh), one_thread);
  for (std::size_t v = 0; v < now.size(); ++v) EXPECT_EQ(now[v], mesh.position[v] + steps[v]);
}

}  // namespace
}  // namespace curvdecim::test
