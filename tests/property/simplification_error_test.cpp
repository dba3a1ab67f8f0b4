// SPDX-License-Identifier: GPL-3.0-or-later
// What holds of every measurement of a simplification's error.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "support/decimation.h"
#include "support/drawn_meshes.h"
#include "support/errors.h"
#include "support/fingerprint.h"
#include "support/rich_mesh.h"

namespace curvdecim::test {
namespace {

Shape original() { return scaled(bumpy_sphere(4), 0.25); }
Shape simplified() { return decimated(original(), to_faces(200)).shape; }

/// All lengths, then what has no unit.
std::vector<double> lengths_of(const ErrorReport& report) {
  const DirectionError &forth = report.original_to_simplified,
                       &back = report.simplified_to_original;
  return {report.rms, report.mean,    report.max, report.rms_salient, report.histogram.end,
          forth.mean, forth.rms,      forth.max,  back.mean,          back.rms,
          back.max,   report.diagonal};
}

std::vector<double> ratios_of(const ErrorReport& report) {
  std::vector<double> ratios(report.histogram.share.begin(), report.histogram.share.end());
  for (double ratio : {report.normal_deviation, double(report.flipped),
                       double(report.simplified.intersecting), double(report.samples)})
    ratios.push_back(ratio);
  return ratios;
}

struct Pair {
  RichMesh first, second;

  Pair() : Pair(original(), simplified()) {}
  Pair(const Shape& original, const Shape& simplified) {
    fill_with_attributes(first, original);
    fill_with_attributes(second, simplified);
  }
  ErrorReport error(const ErrorParams& params = {}, const Progress& progress = {}) {
    return error_between(first, second, params, progress);
  }
  std::string bytes() const { return bytes_of(first) + bytes_of(second); }
};

TEST(SimplificationError, HasTheSameBitsOnAnyNumberOfThreads) {
  ErrorParams params;
  params.save_quality = true;
  params.threads = 1;
  Pair one;
  const ErrorReport report = one.error(params);
  EXPECT_GT(report.rms, 0.0);
  for (int threads : {2, 3, 7}) {
    params.threads = threads;
    Pair several;
    const ErrorReport same = several.error(params);
    EXPECT_EQ(lengths_of(same), lengths_of(report)) << threads;
    EXPECT_EQ(ratios_of(same), ratios_of(report)) << threads;
    EXPECT_EQ(several.bytes(), one.bytes()) << threads;
  }
}

TEST(SimplificationError, ScalesToTheBitByAPowerOfTwo) {
  const ErrorReport report = error_between(original(), simplified());
  for (int exponent : {-40, -3, 20}) {
    const double factor = std::ldexp(1.0, exponent);
    const ErrorReport other =
        error_between(scaled(original(), factor), scaled(simplified(), factor));
    std::vector<double> expected = lengths_of(report);
    for (double& length : expected) length *= factor;
    EXPECT_EQ(lengths_of(other), expected) << exponent;
    EXPECT_EQ(ratios_of(other), ratios_of(report)) << exponent;
  }
}

TEST(SimplificationError, IsTheSameInSinglePrecisionButForRounding) {
  const ErrorReport wide = error_between(original(), simplified());
  const ErrorReport narrow = error_between_float(original(), simplified());
  EXPECT_NEAR(narrow.rms, wide.rms, 1e-3 * wide.rms);
  EXPECT_NEAR(narrow.max, wide.max, 1e-3 * wide.max);
}

TEST(SimplificationError, RepeatsWithinItsNoiseForOtherSamples) {
  ErrorParams params;
  const ErrorReport report = error_between(original(), simplified(), params);
  params.sample_num = 345'678;
  const ErrorReport other = error_between(original(), simplified(), params);
  EXPECT_EQ(report.samples, 100'000);
  EXPECT_EQ(other.samples, params.sample_num);
  EXPECT_NEAR(other.rms, report.rms, 2e-3 * report.rms);
  EXPECT_NEAR(other.normal_deviation, report.normal_deviation, 5e-3 * report.normal_deviation);
}

TEST(SimplificationError, LeavesTheMeshesWithoutSaveQuality) {
  Pair pair;
  const std::string before = pair.bytes();
  pair.error();
  EXPECT_EQ(pair.bytes(), before);
}

TEST(SimplificationError, WritesDistancesAsQuality) {
  const Shape flat = plane_grid(4);
  RichMesh first, second;
  fill_with_attributes(first, flat);
  fill_with_attributes(
      second, side_by_side({translated(flat, {0.0, 0.0, 0.5}), translated(flat, {1.0, 0.0, 0.5})}));
  ErrorParams params;
  params.save_quality = true;
  error_between(first, second, params);
  for (const RichVertex& v : first.vert) EXPECT_NEAR(v.cQ(), 0.5, 1e-12);
  for (const RichVertex& v : second.vert)
    EXPECT_NEAR(v.cQ(), std::hypot(0.5, std::max(0.0, v.cP()[0] - 1.0)), 1e-12);
}

TEST(SimplificationError, IsCancelledAtAnyCall) {
  ErrorParams params;
  params.save_quality = true;
  params.sample_num = 2000;
  for (int last = 1;; ++last) {
    Pair pair(plane_grid(6), plane_grid(3));
    const std::string before = pair.bytes();
    int call = 0, percent_before = 0;
    const ErrorReport report = pair.error(params, [&](int percent, const char*) {
      EXPECT_GE(percent, percent_before);
      percent_before = percent;
      return ++call < last;
    });
    if (report.stopped_by != StopReason::Cancelled) {
      EXPECT_GT(last, 20);
      EXPECT_NE(pair.bytes(), before);
      break;
    }
    EXPECT_EQ(call, last);
    EXPECT_TRUE(pair.bytes() == before) << "cancelled at call " << last;
  }
}

std::string message_of(const std::function<void()>& run) {
  try {
    run();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SimplificationError, NamesTheMeshThatCannotBeMeasured) {
  const Shape flat = plane_grid(2), points{flat.vertices, {}};
  const Shape needle{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  const auto message = [](const Shape& first, const Shape& second) {
    return message_of([&] { error_between(first, second); });
  };
  EXPECT_EQ(message(points, flat).rfind("The original mesh: ", 0), 0u);
  EXPECT_EQ(message(flat, points).rfind("The simplified mesh: ", 0), 0u);
  EXPECT_NE(message(flat, needle).find("No face"), std::string::npos);
  EXPECT_NE(message(flat, translated(flat, {1e9, 0, 0})).find("same coordinates"),
            std::string::npos);
  EXPECT_EQ(message(flat, translated(flat, {1e3, 0, 0})), "");
}

TEST(SimplificationError, RefusesParametersThatMakeNoSense) {
  const auto message = [](const ErrorParams& params) {
    return message_of([&] { error_between(plane_grid(2), plane_grid(2), params); });
  };
  ErrorParams params;
  params.relative_to = RelativeTo::Tolerance;
  EXPECT_NE(message(params).find("tolerance is 0"), std::string::npos);
  params.tolerance = -1.0;
  EXPECT_NE(message(params).find("tolerance is -1"), std::string::npos);
  params = {};
  params.sample_num = -1;
  EXPECT_NE(message(params).find("sample_num is -1"), std::string::npos);
}

/// The unit square with a texture of its size, moved by a step; the second mesh is cut otherwise.
ErrorReport error_of_moved_texture(const Shape& after, double step, int page = 0) {
  RichMesh first, second;
  fill_with_attributes(first, plane_grid(6));
  fill_with_attributes(second, after);
  for (RichFace& face : second.face)
    for (int i = 0; i < 3; ++i) face.WT(i).u() += step, face.WT(i).n() = static_cast<short>(page);
  return error_between(first, second);
}

TEST(TextureDrift, IsHowFarTheTextureMoved) {
  const Shape inner = mapped(plane_grid(4), [](const Point& p) {
    return Point(0.25 + 0.5 * p.x(), 0.25 + 0.5 * p.y(), 0.0);
  });
  for (double step : {0.0, 0.0625, -0.125}) {
    const ErrorReport report = error_of_moved_texture(inner, step);
    ASSERT_TRUE(report.texture);
    EXPECT_NEAR(report.texture->rms, std::abs(step), 1e-9);
    EXPECT_NEAR(report.texture->max, std::abs(step), 1e-9);
    EXPECT_EQ(report.texture->lost, 0.0);
  }
}

TEST(TextureDrift, IsLostWhereTheOriginalShowsNothingOfIt) {
  const ErrorReport beside = error_of_moved_texture(plane_grid(4), 0.5);
  EXPECT_NEAR(beside.texture->lost, 0.5, 0.005);
  EXPECT_NEAR(beside.texture->rms, 0.5, 0.001);
  const ErrorReport other_page = error_of_moved_texture(plane_grid(4), 0.0, 1);
  EXPECT_EQ(other_page.texture->lost, 1.0);
  EXPECT_EQ(other_page.texture->rms, 0.0);
}

TEST(TextureDrift, IsNotToldWithoutATexture) {
  EXPECT_FALSE(error_between_float(plane_grid(2), plane_grid(2)).texture);
}

}  // namespace
}  // namespace curvdecim::test
