// SPDX-License-Identifier: GPL-3.0-or-later
// What CurvatureWeighted is for: less error on the most curved fifth of the area, little more on
// the whole.
#include <gtest/gtest.h>

#include <cmath>

#include "support/decimation.h"
#include "support/mesh_group.h"
#include "support/properties.h"
#include "support/working_mesh.h"
#include "vcg_ext/curvature/curvature_field.h"

namespace curvdecim::test {

using namespace detail;

namespace {

std::vector<Shape> curved_shapes() { return {bumpy_sphere(4), torus(64, 32), saddle(40)}; }

/// Root of the mean square distance of the vertices of the most curved fifth, by area.
double rms_of_most_curved_fifth(const Shape& original, const Shape& after) {
  const WorkingMesh mesh = working_mesh(original);
  CurvatureParams params;
  params.curvature_kind = CurvatureKind::Gaussian;
  const CurvatureField field = curvature_field(mesh, params, Parallel(1));
  const double least = field.least_of_most_curved(0.2);
  double sum = 0.0, total = 0.0;
  for (int v = 0; v < original.vertex_count(); ++v) {
    if (field.value[v] < least) continue;
    const double distance = distance_to(after, original.vertices[v]);
    sum += field.area[v] * distance * distance, total += field.area[v];
  }
  return std::sqrt(sum / total);
}

struct Errors {
  double most_curved = 0.0, whole = 0.0;  // logarithms of geometric means
};

Errors errors(EdgeCollapseParams params) {
  Errors errors;
  const std::vector<Shape> shapes = curved_shapes();
  for (const Shape& shape : shapes) {
    params.target_faces = shape.face_count() / 8;
    const Shape after = decimated(shape, params).shape;
    errors.most_curved += std::log(rms_of_most_curved_fifth(shape, after)) / shapes.size();
    errors.whole += std::log(two_sided_rms(shape, after)) / shapes.size();
  }
  return errors;
}

/// Against plain quadrics under the same preset.
Errors ratios(const EdgeCollapseParams& params) {
  EdgeCollapseParams plain = params;
  plain.metric = Metric::Quadric;
  const Errors with = errors(params), without = errors(plain);
  return {std::exp(with.most_curved - without.most_curved), std::exp(with.whole - without.whole)};
}

class MostCurvedFifth : public testing::TestWithParam<Preset> {};

TEST_P(MostCurvedFifth, HasLessErrorThanWithPlainQuadricsForLittleOnTheWhole) {
  EdgeCollapseParams params;
  params.preset = GetParam();
  const Errors ratio = ratios(params);
  EXPECT_LT(ratio.most_curved, 0.9);
  EXPECT_LT(ratio.whole, 1.1);  // little: these shapes are curved in every place
}

TEST_P(MostCurvedFifth, HasLessErrorTheLowerTheFloor) {
  EdgeCollapseParams params;
  params.preset = GetParam();
  double before = 1.0;
  for (double floor : {0.7, 0.3, 0.005}) {
    params.curvature_floor = floor;
    const double now = ratios(params).most_curved;
    EXPECT_LT(now, before) << floor;
    before = now;
  }
  EXPECT_LT(before, 0.8);
}

INSTANTIATE_TEST_SUITE_P(Presets, MostCurvedFifth,
                         testing::Values(Preset::Fast, Preset::Balanced, Preset::Best));

}  // namespace
}  // namespace curvdecim::test
