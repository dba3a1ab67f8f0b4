// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a simplification where it is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/drawn_meshes.h"
#include "support/errors.h"

namespace curvdecim::test {
namespace {

constexpr double noise = 0.002;  // of the samples, relative

void expect_near_relative(double is, double should) { EXPECT_NEAR(is, should, noise * should); }

TEST(SimplificationError, OfAMeshAgainstItselfIsNone) {
  for (const Shape& shape : {bumpy_sphere(3), plane_grid(8), klein_bottle(16, 8)}) {
    const ErrorReport report = error_between(shape, shape);
    EXPECT_EQ(report.max, 0.0);
    EXPECT_EQ(report.rms, 0.0);
    EXPECT_EQ(report.flipped, 0);
    EXPECT_LT(report.normal_deviation, 1e-3);
  }
}

TEST(SimplificationError, OfParallelSquaresIsTheirDistance) {
  constexpr double height = 0.125;
  const Shape square = plane_grid(5);
  const ErrorReport report = error_between(square, translated(plane_grid(2), {0.0, 0.0, height}));
  for (double is : {report.rms, report.mean, report.max, report.rms_salient,
                    report.original_to_simplified.mean, report.simplified_to_original.max})
    EXPECT_NEAR(is, height, 1e-15);
  EXPECT_NEAR(report.diagonal, std::sqrt(2.0), 1e-15);
  EXPECT_EQ(report.normal_deviation, 0.0);
  EXPECT_EQ(report.flipped, 0);
}

TEST(SimplificationError, OfASquareAgainstAQuarterOfItHasTwoSides) {
  const Shape quarter = plane_grid(7);
  const ErrorReport report = error_between(scaled(quarter, 2.0), quarter);
  EXPECT_LT(report.simplified_to_original.max, 1e-15);
  EXPECT_NEAR(report.original_to_simplified.max, std::sqrt(2.0), 1e-15);
  expect_near_relative(report.original_to_simplified.rms, std::sqrt(1.0 / 3.0));
  expect_near_relative(report.rms, std::sqrt(1.0 / 6.0));
  EXPECT_NEAR(report.max, std::sqrt(2.0), 1e-15);
}

/// Mean over the area of a polyhedron of the power of the distance to the unit sphere around it.
double mean_below_sphere(const Shape& polyhedron, int power) {
  constexpr int cuts = 32;  // of an edge
  double sum = 0.0, total = 0.0;
  for (const Corners& face : polyhedron.faces) {
    const auto [a, b, c] = corners_of(polyhedron, face);
    const double area = double_area(polyhedron, face).norm();
    for (int i = 0; i < cuts; ++i)
      for (int j = 0; i + j < cuts; ++j) {
        const Point p = a + (i + 1.0 / 3.0) / cuts * (b - a) + (j + 1.0 / 3.0) / cuts * (c - a);
        sum += area * std::pow(1.0 - p.norm(), power), total += area;
      }
  }
  return sum / total;
}

TEST(SimplificationError, OfAPolyhedronInASphereIsItsDepth) {
  const Shape sphere = icosphere(6), polyhedron = icosphere(1);
  const DirectionError error = error_between(sphere, polyhedron).simplified_to_original;
  constexpr double facets = 0.01;  // the sphere is a polyhedron itself
  EXPECT_NEAR(error.mean / mean_below_sphere(polyhedron, 1), 1.0, facets);
  EXPECT_NEAR(error.rms / std::sqrt(mean_below_sphere(polyhedron, 2)), 1.0, facets);
  double deepest = 0.0;
  for (const Corners& face : polyhedron.faces) {
    const auto [a, b, c] = corners_of(polyhedron, face);
    deepest = std::max(deepest, 1.0 - ((a + b + c) / 3.0).norm());
  }
  EXPECT_NEAR(error.max / deepest, 1.0, facets);
}

/// A square of which two corners across from each other are lifted, cut along either diagonal.
Shape lifted_square(bool between_lifted) {
  Shape shape{{{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}}, {}};
  shape.faces = between_lifted ? std::vector<Corners>{{0, 1, 3}, {1, 2, 3}}
                               : std::vector<Corners>{{0, 1, 2}, {0, 2, 3}};
  return shape;
}

TEST(SimplificationError, MaximumLooksAlongEdges) {
  ErrorParams params;
  params.sample_num = 1;  // which is nowhere near the middle of the diagonal
  const ErrorReport report = error_between(lifted_square(true), lifted_square(false), params);
  EXPECT_NEAR(report.max, std::sqrt(1.0 / 3.0), 1e-12);
}

TEST(SimplificationError, NormalDeviationIsTheAngleOfARoof) {
  const double slope = std::atan(0.25);
  const Shape flat = plane_grid(4);
  const Shape roof = mapped(flat, [](const Point& p) {
    return Point(p.x(), p.y(), 0.25 * std::min(p.x(), 1.0 - p.x()));
  });
  EXPECT_NEAR(error_between(flat, roof).normal_deviation, slope * 180.0 / M_PI, 1e-9);
}

TEST(SimplificationError, CountsFacesThatAreTurnedOver) {
  Shape turned = plane_grid(4);
  for (int f : {3, 7, 20}) std::swap(turned.faces[f][0], turned.faces[f][1]);
  EXPECT_EQ(error_between(plane_grid(4), turned).flipped, 3);
}

TEST(SimplificationError, CurvedPartIsTheFifthAroundTheTip) {
  const auto tent = [](double tip) {
    return mapped(plane_grid(40), [tip](const Point& p) {
      const double r = (p - Point(0.5, 0.5, 0.0)).norm();
      return Point(p.x(), p.y(), r < 0.1 ? tip * (1.0 - r / 0.1) : 0.0);
    });
  };
  const ErrorReport report = error_between(tent(0.2), tent(0.1));
  EXPECT_GT(report.rms_salient, 1.5 * report.original_to_simplified.rms);
  EXPECT_LT(report.rms_salient, report.max);
}

TEST(SimplificationError, TellsTheShareBeyondATolerance) {
  const Shape flat = plane_grid(4);
  const Shape ramp = mapped(flat, [](const Point& p) { return Point(p.x(), p.y(), 1e-3 * p.x()); });
  ErrorParams params;
  params.tolerance = 0.25e-3;
  EXPECT_NEAR(error_between(flat, ramp, params).beyond_tolerance, 0.75, noise);
  params.relative_to = RelativeTo::Tolerance;
  const ErrorReport report = error_between(flat, ramp, params);
  EXPECT_NEAR(report.histogram.share.back(), 0.75, noise);
  EXPECT_NEAR(report.histogram.end, 1.0, 1e-15);
  EXPECT_EQ(error_between(flat, ramp).beyond_tolerance, 0.0);
}

TEST(SimplificationError, IsRelativeToWhatIsAskedFor) {
  const Shape flat = plane_grid(4), above = translated(flat, {0.0, 0.0, 0.5});
  ErrorParams params;
  params.tolerance = 0.125;
  params.relative_to = RelativeTo::Tolerance;
  EXPECT_NEAR(error_between(flat, above, params).rms, 4.0, 1e-12);
  params.relative_to = RelativeTo::Diagonal;
  EXPECT_NEAR(error_between(flat, above, params).max, 50.0 / std::sqrt(2.0), 1e-12);
  params.relative_to = RelativeTo::MeshUnit;
  EXPECT_NEAR(error_between(flat, above, params).mean, 0.5, 1e-12);
}

TEST(SurfaceFigures, OfACube) {
  const SurfaceFigures figures = figures_of(scaled(cube(), 2.0));
  EXPECT_NEAR(figures.area, 24.0, 1e-12);
  EXPECT_NEAR(figures.volume, 8.0, 1e-12);
  EXPECT_EQ(figures.faces, 12);
  EXPECT_EQ(figures.vertices, 8);
}

void expect_topology(const Shape& shape, int parts, int holes, int handles) {
  const SurfaceFigures figures = figures_of(shape);
  EXPECT_EQ(figures.parts, parts);
  EXPECT_EQ(figures.holes, holes);
  EXPECT_EQ(figures.handles, handles);
}

TEST(SurfaceFigures, CountPartsHolesAndHandles) {
  expect_topology(icosphere(2), 1, 0, 0);
  expect_topology(torus(16, 8), 1, 0, 1);
  expect_topology(open_cylinder(12, 4), 1, 2, 0);
  expect_topology(plane_grid(3), 1, 1, 0);
  expect_topology(annulus(12, 3), 1, 2, 0);
  expect_topology(side_by_side({torus(16, 8), icosphere(1), annulus(12, 3)}), 3, 2, 1);
  expect_topology(touching_spheres(), 2, 0, 0);
}

TEST(SurfaceFigures, JoinBordersThatLieOnEachOther) {
  const Shape half = plane_grid(3);
  expect_topology(side_by_side({half, translated(half, {1.0, 0.0, 0.0})}), 1, 1, 0);
  expect_topology(side_by_side({half, translated(half, {1.5, 0.0, 0.0})}), 2, 2, 0);
}

TEST(SurfaceFigures, CountFacesThatCross) {
  const Shape triangle{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};
  const Shape through{{{1, 1, -1}, {1, 1, 1}, {1.5, 1, 1}}, {{0, 1, 2}}};
  EXPECT_EQ(figures_of(side_by_side({triangle, through})).intersecting, 2);
  EXPECT_EQ(figures_of(side_by_side({triangle, translated(through, {0, 0, 1})})).intersecting, 0);
  EXPECT_EQ(figures_of(side_by_side({triangle, translated(through, {4, 4, 0})})).intersecting, 0);
}

TEST(SurfaceFigures, CountFacesThatCrossBeyondTheirSharedVertex) {
  Shape shape{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 1, -1}, {2, 1, 1}}, {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(figures_of(shape).intersecting, 2);
  shape.vertices[3].z() = 0.5;
  EXPECT_EQ(figures_of(shape).intersecting, 0);
}

TEST(SurfaceFigures, TouchingSurfacesDoNotCross) {
  const Shape box = dense_box(3, {1, 1, 1});
  EXPECT_EQ(figures_of(side_by_side({box, translated(box, {1.0, 0.0, 0.0})})).intersecting, 0);
  EXPECT_EQ(figures_of(side_by_side({box, translated(box, {1.0, 0.1, 0.2})})).intersecting, 0);
  EXPECT_GT(figures_of(side_by_side({box, translated(box, {0.9, 0.1, 0.2})})).intersecting, 0);
  EXPECT_EQ(figures_of(bumpy_sphere(3)).intersecting, 0);
}

TEST(SurfaceFigures, CountFacesThatAreFolded) {
  Shape hinge{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  EXPECT_EQ(figures_of(hinge).folded, 2);
  std::swap(hinge.faces[1][0], hinge.faces[1][1]);  // the same surface, turned over in part
  EXPECT_EQ(figures_of(hinge).folded, 2);
  hinge.vertices[3] = {1, 1, 0.1};
  EXPECT_EQ(figures_of(hinge).folded, 0);
}

}  // namespace
}  // namespace curvdecim::test
