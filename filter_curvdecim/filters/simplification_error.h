// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <vcg/complex/algorithms/update/color.h>
#include <vcg/complex/complex.h>

#include "filter_curvdecim/filters/common_results.h"
#include "filter_curvdecim/filters/common_rows.h"
#include "filter_curvdecim/table/filter.h"
#include "filter_curvdecim/table/joined.h"
#include "filter_curvdecim/table/references.h"
#include "vcg_ext/simplification_error.h"

namespace curvdecim::glue {

inline constexpr Reference metro = {"Cignoni, Rocchini, Scopigno",
                                    "Metro: measuring error on simplified surfaces, 1998"};

/// The core's, and between which layers of the document the error is.
struct LayerErrorParams : ErrorParams {
  int original_mesh = 0, simplified_mesh = 1;

  static constexpr auto fields() {
    using P = LayerErrorParams;
    return std::tuple_cat(std::tuple(Field("original_mesh", &P::original_mesh, any_layer),
                                     Field("simplified_mesh", &P::simplified_mesh, any_layer)),
                          ErrorParams::fields());
  }
};

struct LayerErrorReport : ErrorReport {
  bool is_shown = false;  ///< as quality and colour of both layers
};

/// Three digits, as a log shows a number.
inline std::string shown(double number) {
  std::ostringstream text;
  text << std::setprecision(3) << number;
  return text.str();
}

/// What follows a length in the log.
inline const char* unit_of(RelativeTo relative_to) {
  switch (relative_to) {
    case RelativeTo::MeshUnit: return "";
    case RelativeTo::Diagonal: return " % of the diagonal";
    case RelativeTo::Tolerance: return " times the tolerance";
  }
  return "";
}

/// The histogram of distances, which is the legend of the colours as well: a line a bin.
inline std::vector<std::string> lines_of(const ErrorHistogram& histogram, const char* unit) {
  constexpr std::array colors = {"red",       "orange", "yellow",     "yellow-green", "green",
                                 "turquoise", "cyan",   "light blue", "blue"};
  static_assert(colors.size() == ErrorHistogram::bins + 1);
  constexpr double signs = 50.0;  // for the whole area
  std::vector<std::string> lines;
  for (std::size_t bin = 0; bin < colors.size(); ++bin) {
    const bool is_last = bin == ErrorHistogram::bins;
    const double bound = histogram.end * (is_last ? 1.0 : (bin + 1.0) / ErrorHistogram::bins);
    const double share = histogram.share[bin];
    lines.push_back(std::string(colors[bin]) + (is_last ? ", beyond " : ", up to ") + shown(bound) +
                    unit + ": " + shown(100.0 * share) + " % of the area " +
                    std::string(static_cast<std::size_t>(std::lround(signs * share)), '#'));
  }
  return lines;
}

/// How far a simplification is from its original, with all that is lost, as numbers and as colours.
struct SimplificationErrorFilter {
  using Params = LayerErrorParams;
  using Report = LayerErrorReport;

  template <class MeshType>
  static Report run(MeshType& original, MeshType& simplified, const Params& params,
                    const Progress& progress) {
    Report report{simplification_error(original, simplified, params, progress)};
    if (!is_done(report)) return report;
    report.is_shown = params.save_quality;
    if (report.is_shown)
      for (MeshType* mesh : {&original, &simplified})
        color_by_distance(*mesh, report.histogram.end);
    report.notes = lines_of(report.histogram, unit_of(params.relative_to));
    return report;
  }

  static Changes changed(const Report& report) { return {false, report.is_shown}; }

  static std::string headline(const Report& report) {
    if (!is_done(report)) return "";
    return "Distances: RMS " + shown(report.rms) + ", mean " + shown(report.mean) + ", largest " +
           shown(report.max) + ".";
  }

  static About about() {
    return {"Simplification Error",
            "get_simplification_error",
            Category::QualityMeasure,
            {false, true},
            "See how far a mesh is from its original after you simplify (decimate, reduce) it." +
                bibliography({metro}),
            "Measure how far two layers are from each other: two-sided mean, RMS and largest "
            "distance, from points all over both surfaces to the exact nearest points of the "
            "other, and for the largest from all vertices and along all edges, too. Counted are "
            "also faces that are flipped, folded or cross others, parts, holes and handles that "
            "were gained or lost, area, volume, and how far a texture has drifted. With <i>Show "
            "distances as colours</i> both layers get their distances as vertex quality, and "
            "colours on one scale, red for none and blue for much; the log has its legend, and "
            "how much of the surfaces has which colour. Layers are measured where they are shown, "
            "and no selection counts. The same numbers come out on any number of cores."};
  }

  static ParameterRows<Params> parameters() {
    return {layer_row(&Params::original_mesh, "OriginalMesh", "Original mesh",
                      {"The layer that was simplified.", "The layer that was simplified."},
                      {first_layer, "the first layer"}),
            layer_row(&Params::simplified_mesh, "SimplifiedMesh", "Simplified mesh",
                      {"The layer with the result.", "The layer with the result."},
                      {second_layer, "the second layer"}),
            relative_to_row(),
            row<Params>(&Params::tolerance, "Tolerance", "Tolerance",
                        {"How much of the surfaces is further away than this is told. 0: not.",
                         "The share of the surfaces beyond it is told."},
                        MeshDefault{a_thousandth, "a thousandth of the diagonal"}),
            row<Params>(&Params::save_quality, "SaveQuality", "Show distances as colours",
                        {"Writes to every vertex of both layers how far the other layer is, as "
                         "quality, and colours both on one scale. It ends where a hundredth of the "
                         "surfaces is further away, and with <i>Relative to</i> Tolerance at the "
                         "tolerance.",
                         "As vertex quality, too; the log has the legend."}),
            tuning(row<Params>(&Params::sample_num, "SampleNum", "Number of samples",
                               {"Points on each surface that mean and RMS are taken from. 0: "
                                "100,000, or one a vertex of the original if that is more; the RMS "
                                "then repeats within 0.2 %.",
                                "On each surface. 0: enough for 0.2 %."})),
            threads_row<Params>()};
  }

  static ResultRows<Report, Params> results() {
    return joined<ResultRow<Report, Params>>(
        {{only_if([](const Report& report, const Params&) { return !is_done(report); },
                  stopped_by_result<Report, Params>("; only where it was cancelled"))},
         distance_results(),
         surface_results(),
         texture_results(),
         {figure("diagonal", length_unit, "of the original's bounding box", &Report::diagonal),
          figure("scale_end", relative, "where the scale of the colours ends",
                 [](const Report& report) { return report.histogram.end; }),
          figure("samples", "points", "on each surface", &Report::samples),
          figure("seconds", "s", "wall time", &Report::seconds)}});
  }

 private:
  static constexpr const char* relative = "as `RelativeTo` says";

  static bool is_done(const Report& report) { return report.stopped_by != StopReason::Cancelled; }

  /// Red is 0 and blue the end of the scale.
  template <class MeshType>
  static void color_by_distance(MeshType& mesh, double end) {
    vcg::tri::UpdateColor<MeshType>::PerVertexQualityRamp(mesh, 0.0, end > 0.0 ? end : 1.0);
  }

  static Value first_layer(const MeshFacts& mesh) { return mesh.first_layer; }
  static Value second_layer(const MeshFacts& mesh) { return mesh.second_layer; }
  static Value a_thousandth(const MeshFacts& mesh) { return 1e-3 * mesh.diagonal; }

  static ParameterRow<Params> layer_row(int Params::*member, const char* name, const char* label,
                                        const ParameterText& text, const MeshDefault& layer) {
    return row<Params>(member, name, label, text, layer);
  }

  static ParameterRow<Params> relative_to_row() {
    return enum_row<Params>(
        &Params::relative_to, "RelativeTo", "Relative to", "What distances are told in.",
        {{RelativeTo::MeshUnit, "as the layers are", "the layers' own unit of length"},
         {RelativeTo::Diagonal, "per cent of it",
          "per cent of the diagonal of the original's bounding box"},
         {RelativeTo::Tolerance, "1 is just within it",
          "multiples of the tolerance: 1 is just within it"}});
  }

  template <class Get>
  static ResultRow<Report, Params> figure(std::string name, std::string unit, std::string meaning,
                                          Get get) {
    return {{std::move(name), std::move(unit), std::move(meaning)},
            [get](const Report& report, const Params&) -> std::optional<ResultValue> {
              if (!is_done(report)) return std::nullopt;
              return ResultValue(std::invoke(get, report));
            }};
  }

  /// A row for a member of both directions, and for the one of the whole.
  static ResultRows<Report, Params> two_sided(const std::string& name, const std::string& meaning,
                                              double ErrorReport::*whole,
                                              double DirectionError::*side) {
    return {figure(name, relative, meaning, whole),
            figure(name + "_original_to_simplified", relative, "the same, from the original",
                   [side](const Report& report) { return report.original_to_simplified.*side; }),
            figure(name + "_simplified_to_original", relative, "the same, from the simplification",
                   [side](const Report& report) { return report.simplified_to_original.*side; })};
  }

  static ResultRows<Report, Params> distance_results() {
    return joined<ResultRow<Report, Params>>(
        {two_sided("rms", "root of the mean of both directions' squared distances", &Report::rms,
                   &DirectionError::rms),
         two_sided("mean", "mean distance of both directions", &Report::mean,
                   &DirectionError::mean),
         two_sided("max", "largest distance of both directions", &Report::max,
                   &DirectionError::max),
         {figure("rms_salient", relative,
                 "RMS from the fifth of the original's area that is curved most",
                 &Report::rms_salient),
          only_if([](const Report&, const Params& params) { return params.tolerance > 0.0; },
                  figure("beyond_tolerance", "% of the area",
                         "what is further away than `Tolerance`, of both surfaces",
                         [](const Report& report) { return 100.0 * report.beyond_tolerance; })),
          figure("normal_deviation_deg", "degrees",
                 "mean angle between the normals at nearest points, both directions",
                 &Report::normal_deviation)}});
  }

  /// A figure of the simplification and of the original.
  template <class Number>
  static ResultRows<Report, Params> of_both(const std::string& name, const std::string& unit,
                                            const std::string& meaning,
                                            Number SurfaceFigures::*member) {
    return {figure(name, unit, meaning,
                   [member](const Report& report) { return report.simplified.*member; }),
            figure(name + "_original", unit, "the same, of the original",
                   [member](const Report& report) { return report.original.*member; })};
  }

  /// The same, and what came or went.
  template <class Number>
  static ResultRows<Report, Params> with_gain(const std::string& name, const std::string& unit,
                                              const std::string& meaning,
                                              Number SurfaceFigures::*member) {
    ResultRows<Report, Params> rows = of_both(name, unit, meaning, member);
    rows.push_back(figure(name + "_gained", unit, "how much more; below 0: lost",
                          [member](const Report& report) {
                            return report.simplified.*member - report.original.*member;
                          }));
    return rows;
  }

  static ResultRows<Report, Params> surface_results() {
    return joined<ResultRow<Report, Params>>(
        {{figure("flipped", "faces",
                 "turned by more than 90 degrees against the original, at their middle",
                 &Report::flipped)},
         of_both("folded", "faces",
                 "turned by more than 179 degrees at an edge, so that they lie "
                 "on a neighbour",
                 &SurfaceFigures::folded),
         of_both("intersecting", "faces", "that cross another one", &SurfaceFigures::intersecting),
         with_gain("parts", "parts", "pieces of the simplification that hang together",
                   &SurfaceFigures::parts),
         with_gain("holes", "holes", "loops of open border", &SurfaceFigures::holes),
         with_gain("handles", "handles", "as a torus has one", &SurfaceFigures::handles),
         with_gain("area", "in the mesh's unit, squared", "of the simplification",
                   &SurfaceFigures::area),
         with_gain("volume", "in the mesh's unit, cubed",
                   "of the simplification; an open surface is closed by a cone",
                   &SurfaceFigures::volume),
         of_both("faces", "faces", "of the simplification", &SurfaceFigures::faces)});
  }

  static ResultRow<Report, Params> texture_figure(const char* name, const char* unit,
                                                  const char* meaning,
                                                  double TextureDriftError::*member,
                                                  double factor) {
    return {{name, unit, std::string(meaning) + "; only where both have a texture"},
            [member, factor](const Report& report, const Params&) -> std::optional<ResultValue> {
              if (!report.texture) return std::nullopt;
              return ResultValue(factor * ((*report.texture).*member));
            }};
  }

  static ResultRows<Report, Params> texture_results() {
    using Drift = TextureDriftError;
    return {texture_figure("texture_drift_rms", relative,
                           "RMS distance from where the original shows the same of the texture",
                           &Drift::rms, 1.0),
            texture_figure("texture_drift_max", relative, "largest of these distances", &Drift::max,
                           1.0),
            texture_figure("texture_lost", "% of the area",
                           "what shows a place of the texture that the original shows nowhere",
                           &Drift::lost, 100.0)};
  }
};

}  // namespace curvdecim::glue
