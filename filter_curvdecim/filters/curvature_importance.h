// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <vcg/complex/algorithms/update/color.h>
#include <vcg/complex/complex.h>

#include "filter_curvdecim/filters/common_results.h"
#include "filter_curvdecim/filters/curvature_rows.h"
#include "filter_curvdecim/table/filter.h"
#include "filter_curvdecim/table/joined.h"
#include "filter_curvdecim/table/references.h"
#include "vcg_ext/curvature_importance.h"

namespace curvdecim::glue {

/// What the quality of the vertices is afterwards.
struct ImportanceReport {
  StopReason stopped_by = StopReason::Target;
  double minimum = 0.0, median = 0.0, maximum = 0.0;
  std::vector<std::string> notes;
};

/// The qualities of the vertices that faces use, ascending.
template <class MeshType>
std::vector<double> sorted_qualities(const MeshType& mesh) {
  std::vector<bool> used(mesh.vert.size(), false);
  for (const auto& face : mesh.face)
    for (int i = 0; i < 3 && !face.IsD(); ++i) used[vcg::tri::Index(mesh, face.cV(i))] = true;
  std::vector<double> qualities;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) qualities.push_back(static_cast<double>(mesh.vert[v].cQ()));
  std::sort(qualities.begin(), qualities.end());
  return qualities;
}

/// The value below which a fraction of them lies; there must be one.
inline double percentile(const std::vector<double>& sorted, double fraction) {
  return sorted[static_cast<std::size_t>(fraction * static_cast<double>(sorted.size() - 1))];
}

/// Shows the qualities as colours. A few spikes of curvature would make the rest one colour; the
/// factor keeps one scale for all meshes.
template <class MeshType>
void color_by_quality(MeshType& mesh, ImportanceOf output, const std::vector<double>& sorted) {
  const bool factor = output == ImportanceOf::Factor;
  const double red = factor ? 0.0 : percentile(sorted, 0.05);
  const double blue = factor ? 1.0 : percentile(sorted, 0.95);
  vcg::tri::UpdateColor<MeshType>::PerVertexQualityRamp(mesh, red, blue);
}

/// The curvature, or the factor on the cost, as quality and colour of the vertices.
struct CurvatureImportanceFilter {
  using Params = ImportanceParams;
  using Report = ImportanceReport;

  template <class MeshType>
  static Report run(MeshType& mesh, const Params& params, const Progress& progress) {
    if (!curvature_importance(mesh, params, progress))
      return {StopReason::Cancelled, 0.0, 0.0, 0.0, {"Cancelled: the mesh is unchanged."}};
    const std::vector<double> sorted = sorted_qualities(mesh);
    color_by_quality(mesh, params.output, sorted);
    return {StopReason::Target, sorted.front(), percentile(sorted, 0.5), sorted.back(), {}};
  }

  static Changes changed(const Report& report) { return {false, is_done(report)}; }

  static std::string headline(const Report& report) {
    return is_done(report) ? "Every vertex has its value as quality and as colour." : "";
  }

  static About about() {
    return {
        "Curvature Importance",
        "compute_scalar_by_curvature_importance",
        Category::QualityMeasure,
        {false, true},
        "Show what edge collapse keeps when you simplify (decimate, reduce)." +
            bibliography({pellizzoni_savio}),
        "Write to the quality of every vertex, and show as colour, what the metric "
        "CurvatureWeighted of <i>Simplification: Curvature-Enhanced Edge Collapse</i> sees with "
        "the same parameters: the curvature, or the factor by which the cost of a collapse is "
        "multiplied. Places with high values keep their faces longest. Red is low and blue is "
        "high. Curvature is coloured from its 5th to its 95th percentile, because a few spikes "
        "would hide the rest; the factor always from 0 to 1, so that settings can be compared."};
  }

  static ParameterRows<Params> parameters() {
    return joined<ParameterRow<Params>>(
        {{output_row(), curvature_floor_row<Params>()}, for_papers(alpha_rows<Params>())});
  }

  static ResultRows<Report, Params> results() {
    const auto cancelled = [](const Report& report, const Params&) { return !is_done(report); };
    return {only_if(cancelled, stopped_by_result<Report, Params>("; only where it was cancelled")),
            quality_result("minimum", "the least value of a vertex", &Report::minimum),
            quality_result("median", "half of the vertices have less", &Report::median),
            quality_result("maximum", "the largest value of a vertex", &Report::maximum)};
  }

 private:
  static bool is_done(const Report& report) { return report.stopped_by != StopReason::Cancelled; }

  static ParameterRow<Params> output_row() {
    return enum_row<Params>(
        &Params::output, "Output", "Value to show",
        "What is written to the quality of the vertices.",
        {{ImportanceOf::Curvature, "in the model's unit",
          "the curvature itself, in the model's unit of length"},
         {ImportanceOf::Factor, "on the cost, 0 to 1", "the factor on the cost, 0 to 1"}});
  }

  static ResultRow<Report, Params> quality_result(const char* name, const char* meaning,
                                                  double Report::*member) {
    const auto done = [](const Report& report, const Params&) { return is_done(report); };
    return only_if(done, result<Report, Params>(name, "as `Output` says", meaning, member));
  }
};

}  // namespace curvdecim::glue
