// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_curvdecim/filters/common_results.h"
#include "filter_curvdecim/filters/common_rows.h"
#include "filter_curvdecim/filters/curvature_rows.h"
#include "filter_curvdecim/table/filter.h"
#include "filter_curvdecim/table/joined.h"
#include "filter_curvdecim/table/references.h"
#include "vcg_ext/edge_collapse.h"

namespace curvdecim::glue {

/// Edge collapse by quadrics and curvature.
struct EdgeCollapseFilter {
  using Params = EdgeCollapseParams;
  using Report = DecimationReport;

  template <class MeshType>
  static Report run(MeshType& mesh, const Params& params, const Progress& progress) {
    return decimate_edge_collapse(mesh, params, progress);
  }

  static Changes changed(const Report& report) { return change_of_shape(report); }

  static std::string headline(const Report& report) { return headline_of(report, changed(report)); }

  static About about() {
    return {"Simplification: Curvature-Enhanced Edge Collapse",
            "meshing_decimation_curvature_edge_collapse",
            Category::Remeshing,
            {true, false},
            "Simplify (decimate, reduce); what is curved keeps more faces." +
                bibliography({pellizzoni_savio}),
            "Edges collapse where a quadric error (Garland, Heckbert) is least; curved places, "
            "borders and sharp edges keep more faces. A closed manifold stays one. <i>Curvature "
            "Importance</i> shows what is protected."};
  }

  static ParameterRows<Params> parameters() {
    return joined<ParameterRow<Params>>({collapse_target_rows<Params>(),
                                         {for_all(preset_row()), curvature_floor_row<Params>()},
                                         common_rows<Params>(),
                                         for_papers<Params>({metric_row()}),
                                         for_papers(alpha_rows<Params>()),
                                         for_papers(additive_rows()),
                                         for_papers(custom_quadric_rows()),
                                         for_papers(custom_run_rows()),
                                         for_papers<Params>({pair_distance_row()}),
                                         keep_rows<Params>()});
  }

  static ResultRows<Report, Params> results() {
    const auto paired = [](const Report&, const Params& params) {
      return params.pair_distance > 0.0;
    };
    return joined<ResultRow<Report, Params>>(
        {count_results<Report, Params>(),
         {bound_result<Report, Params>(),
          only_if(paired, result<Report, Params>(
                              "pairs_contracted", "pairs",
                              "unconnected vertices that merged; only with `PairDistance`",
                              &Report::pairs_contracted))},
         topology_results<Report, Params>(),
         collapse_results<Report, Params>()});
  }

 private:
  static ParameterRow<Params> preset_row() {
    return enum_row<Params>(
        &Params::preset, "Preset", "Preset",
        "Speed against quality, as a named setting of <i>Quadrics</i>, <i>Weight of a plane</i>, "
        "<i>Placement</i>, <i>Scheduler</i> and <i>Refinement sweeps</i>. The metric and its "
        "weights stay as given.",
        {{Preset::Fast, "least time",
          "most collapses in passes over the whole mesh: the least time"},
         {Preset::Balanced, "little error, fast",
          "single collapses count near the target: lower error"},
         {Preset::Best, "a sixth less error, slower",
          "the same, then the result is fitted to the input: slower, a sixth less error"},
         {Preset::Custom, "by the parameters below", "every parameter as given below"}});
  }

  static ParameterRow<Params> metric_row() {
    return enum_row<Params>(
        &Params::metric, "Metric", "Cost of an edge", "What decides which edge is collapsed next.",
        {{Metric::Quadric, "all places alike",
          "squared distance to the planes of the faces around (Garland and Heckbert)"},
         {Metric::CurvatureWeighted, "more where curved",
          "the same, times a factor that grows with the curvature (Pellizzoni and Savio)"},
         {Metric::CurvatureAdditive, "more where bent",
          "the same, plus a term that grows with the bend at the edge (Yao and others)"}});
  }

  static ParameterRows<Params> additive_rows() {
    return {
        row<Params>(
            &Params::lambda, "Lambda", "Weight of the bend (lambda)",
            {"CurvatureAdditive adds lambda times the bend at the edge to the cost, with lengths "
             "relative to the bounding box's diagonal. More lowers the largest error and raises "
             "the mean one a little. 0 is plain quadrics.",
             "Weight of the bend at the edge; 0 is plain quadrics."}),
        enum_row<Params>(
            &Params::curvature_term, "CurvatureTerm", "Reading of the bend",
            "The printed formula has two readings; only CurvatureAdditive uses it.",
            {{CurvatureTerm::Melax, "turn of the faces around",
              "edge length times the largest turn from the edge's own faces to a face around: the "
              "intent"},
             {CurvatureTerm::Literal, "the formula as printed",
              "the formula as printed, which amounts to the edge length"}})};
  }

  static ParameterRows<Params> custom_quadric_rows() {
    constexpr const char* help = "Used with the preset Custom.";
    return {enum_row<Params>(&Params::quadrics, "Quadrics", "Quadrics (Custom)", help,
                             {{Quadrics::Memoryless, "lower error",
                               "computed from the current mesh: lower error (Lindstrom and Turk)"},
                              {Quadrics::Accumulated, "faster",
                               "summed up along the collapses: faster (Garland and Heckbert)"}}),
            enum_row<Params>(
                &Params::plane_weight, "PlaneWeight", "Weight of a plane (Custom)", help,
                {{PlaneWeight::Area, "by the area of the face",
                  "a plane counts by the area of its face: independent of the tessellation"},
                 {PlaneWeight::Unit, "all alike, as in the papers",
                  "every plane counts 1, as in the papers"}}),
            enum_row<Params>(&Params::placement, "Placement", "Placement (Custom)", help,
                             {{Placement::Optimal, "free", "where the quadric error is least"},
                              {Placement::Line, "along", "where it is least on the edge"},
                              {Placement::EndpointOrMidpoint, "ends or middle",
                               "the best of both ends and the midpoint"},
                              {Placement::HalfEdge, "an end",
                               "the better end: the result has original vertices only"}})};
  }

  static ParameterRows<Params> custom_run_rows() {
    return {
        enum_row<Params>(
            &Params::scheduler, "Scheduler", "Scheduler (Custom)", "Used with the preset Custom.",
            {{Scheduler::Rounds, "on all cores",
              "many collapses at once on all cores, the cheapest first"},
             {Scheduler::Lazy, "strict order",
              "one by one, cheapest first; costs are brought up to date when they come up"},
             {Scheduler::Eager, "lower error",
              "one by one, cheapest first; costs around are brought up to date at once"},
             {Scheduler::FewRounds, "faster", "as Rounds, with more collapses at once"}}),
        refine_sweeps_row<Params>(
            "Refinement sweeps (Custom)",
            {"After the collapses each sweep moves the vertices to where both surfaces come "
             "closest and flips edges where that helps; the number of faces stays. 0: none, and "
             "none with <i>Maximum error</i> or the placement HalfEdge. Used with the preset "
             "Custom; Best has 3.",
             "Fits the result to the input; Best has 3."})};
  }

  static ParameterRow<Params> pair_distance_row() {
    return row<Params>(
        &Params::pair_distance, "PairDistance", "Join closer than",
        {"Two vertices that no edge connects may merge, too, where they were closer than this in "
         "the input: parts join and gaps close, and many small parts become few instead of "
         "vanishing (Garland and Heckbert). Given as a length or as per cent of the bounding box's "
         "diagonal. Turns <i>Preserve topology</i> off, and the presets to one step at a time; "
         "edges of three faces may result. Not together with <i>Maximum error</i>. 0: only edges "
         "collapse.",
         "Parts join across gaps. Turns <i>Preserve topology</i> off. 0: nothing."});
  }
};

}  // namespace curvdecim::glue
