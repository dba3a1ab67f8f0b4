// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a simplification, from its two surfaces. Everything but areas and volumes is in the
// box of diagonal 1 until it is told in what the parameters ask for.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "vcg_ext/error_params.h"
#include "vcg_ext/error_report.h"
#include "vcg_ext/measure/distances.h"
#include "vcg_ext/measure/histogram.h"
#include "vcg_ext/measure/most_curved.h"
#include "vcg_ext/measure/surface_figures.h"
#include "vcg_ext/measure/texture_drift_error.h"

namespace curvdecim::detail {

/// One of the two surfaces.
struct ErrorInput {
  std::unique_ptr<const MeasuredSurface> surface;
  std::vector<FaceWedges> wedges;        // by face of the surface; empty: there is no texture
  std::int64_t faces = 0, vertices = 0;  // of the host's mesh
};

/// What was measured.
struct MeasuredError {
  ErrorReport report;
  std::vector<double> at_original, at_simplified;  // with save_quality: by vertex, to the other one
};

/// So many that the RMS repeats within about 0.2 %.
inline int sample_count(const ErrorParams& params, const MeasuredSurface& original) {
  constexpr std::size_t least = 100'000;
  if (params.sample_num > 0) return params.sample_num;
  return static_cast<int>(std::max(least, original.vertices().size()));
}

/// A length in the box of diagonal 1, in what the parameters ask for.
inline double length_factor(const ErrorParams& params, double diagonal) {
  constexpr double percent = 100.0;
  switch (params.relative_to) {
    case RelativeTo::MeshUnit: return diagonal;
    case RelativeTo::Diagonal: return percent;
    case RelativeTo::Tolerance: return diagonal / params.tolerance;
  }
  return 1.0;
}

/// Measures in steps, each of which is a member; `along` is the stretch of the progress.
class ErrorMeasurement {
 public:
  ErrorMeasurement(const ErrorInput& original, const ErrorInput& simplified, double diagonal,
                   const ErrorParams& params, const Parallel& parallel)
      : original_(original),
        simplified_(simplified),
        diagonal_(diagonal),
        params_(params),
        parallel_(parallel),
        samples_(*original.surface, sample_count(params, *original.surface)),
        samples_of_simplified_(*simplified.surface, samples_.count()) {}

  MeasuredError measure() {
    ProgressMeter& progress = parallel_.progress();
    progress.along(0.0, 0.3, [&] { read(original_, samples_, simplified_, forth_); });
    progress.along(0.3, 0.6, [&] { read(simplified_, samples_of_simplified_, original_, back_); });
    progress.along(0.6, 0.7, [&] { measure_parts(); });
    progress.along(0.7, 0.8, [&] { measure_texture(); });
    progress.along(0.8, 1.0, [&] { measure_surfaces(); });
    conclude();
    return {report_, scaled(forth_.of_vertices), scaled(back_.of_vertices)};
  }

 private:
  struct Direction {
    Readings readings;
    std::vector<double> of_vertices;
    double largest = 0.0;
  };

  void read(const ErrorInput& from, const AreaSamples& samples, const ErrorInput& to,
            Direction& direction) const {
    direction.readings = read_samples(*from.surface, samples, *to.surface, parallel_);
    direction.largest = largest_of(samples.count(), parallel_,
                                   [&](int i) { return direction.readings.distance[i]; });
    read_vertices(*from.surface, *to.surface, direction);
    direction.largest = farthest_along_edges(*from.surface, std::sqrt(samples.share()),
                                             direction.largest, *to.surface, parallel_);
  }

  void read_vertices(const MeasuredSurface& from, const MeasuredSurface& to,
                     Direction& direction) const {
    const std::vector<Vector3>& vertices = from.vertices();
    const int count = static_cast<int>(vertices.size());
    if (params_.save_quality) {
      direction.of_vertices = distances_of(vertices, to, parallel_);
      direction.largest =
          std::max(direction.largest,
                   *std::max_element(direction.of_vertices.begin(), direction.of_vertices.end()));
    } else {
      direction.largest =
          farthest(count, direction.largest, to, parallel_,
                   [&](int v, FarthestPoint& point) { point.look_at(vertices[v]); });
    }
  }

  template <class Value>
  double mean(Value value) const {
    return sum_of(samples_.count(), parallel_, value) / samples_.count();
  }

  DirectionError error_of(const Direction& direction) const {
    const Readings& at = direction.readings;
    const double tolerance = params_.tolerance / diagonal_;
    return {mean([&](int i) { return at.distance[i]; }),
            std::sqrt(mean([&](int i) { return at.distance[i] * at.distance[i]; })),
            direction.largest,
            mean([&](int i) { return tolerance > 0.0 && at.distance[i] > tolerance ? 1.0 : 0.0; }),
            mean([&](int i) { return at.turn[i]; })};
  }

  /// What holds for parts of the surfaces: the most curved fifth, flipped faces, bins of distances.
  void measure_parts() {
    const MostCurved is_salient(*original_.surface, samples_, parallel_);
    const int count = samples_.count();
    const double salient =
        sum_of(count, parallel_, [&](int i) { return is_salient(i) ? 1.0 : 0.0; });
    const double squares = sum_of(count, parallel_, [&](int i) {
      const double distance = forth_.readings.distance[i];
      return is_salient(i) ? distance * distance : 0.0;
    });
    report_.rms_salient = std::sqrt(squares / salient);
    report_.flipped = count_flipped(*simplified_.surface, *original_.surface, parallel_);
    const double end = params_.relative_to == RelativeTo::Tolerance
                           ? params_.tolerance / diagonal_
                           : end_of_scale(forth_.readings, back_.readings);
    report_.histogram = histogram_of(forth_.readings, back_.readings, end);
  }

  void measure_texture() {
    if (original_.wedges.empty() || simplified_.wedges.empty()) return;
    report_.texture = texture_drift({*original_.surface, original_.wedges},
                                    {*simplified_.surface, simplified_.wedges},
                                    samples_of_simplified_, parallel_);
  }

  void measure_surfaces() {
    const auto figures = [&](const ErrorInput& input) {
      return surface_figures(*input.surface, input.faces, input.vertices, diagonal_, parallel_);
    };
    report_.original = figures(original_);
    report_.simplified = figures(simplified_);
  }

  /// Joins the directions, and tells lengths in what was asked for.
  void conclude() {
    DirectionError &forth = report_.original_to_simplified, &back = report_.simplified_to_original;
    forth = error_of(forth_), back = error_of(back_);
    report_.rms = std::sqrt(0.5 * (forth.rms * forth.rms + back.rms * back.rms));
    report_.mean = 0.5 * (forth.mean + back.mean);
    report_.max = std::max(forth.max, back.max);
    report_.beyond_tolerance = 0.5 * (forth.beyond_tolerance + back.beyond_tolerance);
    report_.normal_deviation = 0.5 * (forth.normal_deviation + back.normal_deviation);
    report_.diagonal = diagonal_, report_.samples = samples_.count();
    scale_lengths();
  }

  void scale_lengths() {
    const double factor = length_factor(params_, diagonal_);
    for (double* length :
         {&report_.rms, &report_.mean, &report_.max, &report_.rms_salient, &report_.histogram.end})
      *length *= factor;
    for (DirectionError* each : {&report_.original_to_simplified, &report_.simplified_to_original})
      each->mean *= factor, each->rms *= factor, each->max *= factor;
    if (report_.texture) report_.texture->rms *= factor, report_.texture->max *= factor;
  }

  std::vector<double> scaled(std::vector<double> lengths) const {
    const double factor = length_factor(params_, diagonal_);
    for (double& length : lengths) length *= factor;
    return lengths;
  }

  const ErrorInput &original_, &simplified_;
  const double diagonal_;
  const ErrorParams& params_;
  const Parallel& parallel_;
  const AreaSamples samples_, samples_of_simplified_;
  Direction forth_, back_;  // from the original, and from the simplified surface
  ErrorReport report_;
};

}  // namespace curvdecim::detail
