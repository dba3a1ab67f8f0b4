// SPDX-License-Identifier: GPL-3.0-or-later
// How far collapses in rounds lead from the surface. Large meshes are measured against the smooth
// surface that they sample, since the nearest faces of each other would take too long to find.
#include <gtest/gtest.h>

#include <cmath>

#include "support/decimation.h"
#include "support/mesh_group.h"
#include "support/properties.h"

namespace curvdecim::test {
namespace {

/// A target that is reached within the rounds.
constexpr int last_in_rounds = 2 * 4096;

Shape decimated_by(Scheduler scheduler, const Shape& shape) {
  EdgeCollapseParams params = to_faces(last_in_rounds);
  params.preset = Preset::Custom;
  params.scheduler = scheduler;
  return decimated(shape, params).shape;
}

/// A mesh with its vertices on a smooth surface.
struct SmoothSurface {
  std::string name;
  Shape mesh;
  std::function<double(const Point&)> height;  // over the surface; grows outwards
};

void PrintTo(const SmoothSurface& surface, std::ostream* out) { *out << surface.name; }

std::vector<SmoothSurface> smooth_surfaces() {
  return {
      {"sphere", icosphere(5), [](const Point& p) { return p.norm() - 1.0; }},
      {"torus", torus(160, 80),
       [](const Point& p) { return std::hypot(std::hypot(p.x(), p.y()) - 1.0, p.z()) - 0.4; }},
      {"saddle", saddle(110), [](const Point& p) { return p.z() - p.x() * p.x() + p.y() * p.y(); }},
      {"open_cylinder", open_cylinder(160, 80),
       [](const Point& p) { return std::hypot(p.x(), p.y()) - 1.0; }},
      {"plane_grid", plane_grid(110), [](const Point& p) { return p.z(); }}};
}

/// Faces whose normal points inwards.
int turned_faces(const Shape& shape, const SmoothSurface& surface) {
  int turned = 0;
  for (const Corners& face : shape.faces) {
    const auto [a, b, c] = corners_of(shape, face);
    const Point centre = (a + b + c) / 3.0, step = 1e-5 * double_area(shape, face).normalized();
    turned += !(surface.height(centre + step) > surface.height(centre - step));
  }
  return turned;
}

/// Root of the mean square height of the faces' corners and centres, by area.
double rms_height(const Shape& shape, const SmoothSurface& surface) {
  double sum = 0.0, total = 0.0;
  for (const Corners& face : shape.faces) {
    const auto [a, b, c] = corners_of(shape, face);
    const double area = double_area(shape, face).norm();
    for (const Point& p : {a, b, c, Point((a + b + c) / 3.0)})
      sum += area * surface.height(p) * surface.height(p), total += area;
  }
  return std::sqrt(sum / total);
}

class RoundsOn : public testing::TestWithParam<SmoothSurface> {};

TEST_P(RoundsOn, TurnNoFaceOver) {
  ASSERT_GT(GetParam().mesh.face_count(), 2 * last_in_rounds);
  ASSERT_EQ(turned_faces(GetParam().mesh, GetParam()), 0);
  const Shape after = decimated_by(Scheduler::Rounds, GetParam().mesh);
  EXPECT_EQ(turned_faces(after, GetParam()), 0);
}

TEST_P(RoundsOn, AreNearlyAsGoodAsOneByOne) {
  constexpr double allowance = 1.05, nothing = 1e-9;
  const auto rms = [](Scheduler scheduler) {
    return rms_height(decimated_by(scheduler, GetParam().mesh), GetParam());
  };
  EXPECT_LE(rms(Scheduler::Rounds), allowance * rms(Scheduler::Eager) + nothing);
}

INSTANTIATE_TEST_SUITE_P(Drawn, RoundsOn, testing::ValuesIn(smooth_surfaces()),
                         [](const auto& surface) { return surface.param.name; });

// --- error bound ---------------------------------------------------------------------------------

/// Largest distance of some hundred vertices of the one to the other.
double distance_of_some(const Shape& from, const Shape& to) {
  double largest = 0.0;
  for (int v = 0; v < from.vertex_count(); v += from.vertex_count() / 200)
    largest = std::max(largest, distance_to(to, from.vertices[v]));
  return largest;
}

class ErrorBoundInRounds : public testing::TestWithParam<NamedShape> {};

TEST_P(ErrorBoundInRounds, IsKept) {
  constexpr double rounding = 1e-14;
  const Shape& before = GetParam().shape;
  EdgeCollapseParams params = to_faces(last_in_rounds);
  params.max_error = 5e-4 * diagonal(before);
  const auto [after, report] = decimated(before, params);
  EXPECT_LE(report.max_error, params.max_error);
  EXPECT_LE(distance_of_some(before, after), report.max_error + rounding);
  EXPECT_LE(distance_of_some(after, before), report.max_error + rounding);
  EXPECT_LT(after.face_count(), before.face_count() * 4 / 5);
}

INSTANTIATE_TEST_SUITE_P(Drawn, ErrorBoundInRounds,
                         testing::Values(NamedShape{"noisy_sphere", noisy_sphere(5, 0.002)},
                                         NamedShape{"torus", torus(128, 64)},
                                         NamedShape{"saddle", saddle(80)},
                                         NamedShape{"open_cylinder", open_cylinder(100, 64)}),
                         name_of);

}  // namespace
}  // namespace curvdecim::test
