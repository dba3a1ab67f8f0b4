// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>

#include "filter_curvdecim/filters/common_results.h"
#include "filter_curvdecim/filters/common_rows.h"
#include "filter_curvdecim/table/filter.h"
#include "filter_curvdecim/table/joined.h"
#include "filter_curvdecim/table/references.h"
#include "vcg_ext/vertex_clustering.h"

namespace curvdecim::glue {

/// One vertex for all in a cell of a grid.
struct VertexClusteringFilter {
  using Params = ClusteringParams;
  using Report = ClusteringReport;

  template <class MeshType>
  static Report run(MeshType& mesh, const Params& params, const Progress& progress) {
    return decimate_vertex_clustering(mesh, params, progress);
  }

  /// A run that made cells changed the mesh, even where no vertex is gone.
  static Changes changed(const Report& report) { return {report.cell_size > 0.0, false}; }

  static std::string headline(const Report& report) { return headline_of(report, changed(report)); }

  static About about() {
    return {"Simplification: Vertex Clustering with Representatives",
            "meshing_decimation_vertex_clustering",
            Category::Remeshing,
            {true, false},
            "Simplify (decimate, reduce) in the least time, by a grid." +
                bibliography({rossignac_borrel, lindstrom}),
            "One vertex of all in a cell of a grid: the fastest way to a coarse mesh, of any "
            "input. No vertex moves further than the size of a cell. Thin parts may vanish and "
            "edges get more than two faces; edge collapse keeps both, and more of the shape."};
  }

  static ParameterRows<Params> parameters() {
    return {cell_size_row(),
            faces_row(),
            target_fraction_row<Params>(),
            bound_row(),
            representative_row(),
            manifold_edges_row(),
            selected_row<Params>(),
            tuning(mean_weight_row()),
            tuning(weight_row()),
            tuning(quality_row()),
            paper(keep_map_row<Params>()),
            tuning(threads_row<Params>())};
  }

  static ResultRows<Report, Params> results() {
    return joined<ResultRow<Report, Params>>(
        {count_results<Report, Params>(),
         {result<Report, Params>("cell_size", length_unit, "diameter of the cells",
                                 &Report::cell_size),
          result<Report, Params>("largest_move", length_unit,
                                 "the furthest that a vertex went to that of its cell",
                                 &Report::largest_move),
          bound_result<Report, Params>(),
          cost_last_result<Report, Params>(
              "the largest cost of a cell; 0 without the representative Quadric")},
         loss_results(),
         {seconds_result<Report, Params>()}});
  }

 private:
  static constexpr Reference rossignac_borrel = {"Rossignac, Borrel",
                                                 "Modeling in Computer Graphics, 1993"};
  static constexpr Reference lindstrom = {"Lindstrom", "SIGGRAPH 2000"};

  static Value percent_of_diagonal(const MeshFacts& mesh) {
    return std::isfinite(mesh.diagonal) ? 0.01 * mesh.diagonal : 0.0;
  }

  static ParameterRow<Params> cell_size_row() {
    return row<Params>(
        &Params::cell_size, "CellSize", "Size of a cell",
        {"The largest diameter of a cell: no vertex moves further. Given as a length or as per "
         "cent of the bounding box's diagonal. Not used with a <i>Target number of faces</i> or "
         "<i>Fraction of the faces</i>.",
         "Its largest diameter: no vertex moves further than this."},
        MeshDefault{percent_of_diagonal, "1 % of the bounding box's diagonal"});
  }

  static ParameterRow<Params> faces_row() {
    return target_faces_row<Params>(
        {"Instead of <i>Size of a cell</i>: the size is looked for at which this many faces are "
         "left, of the selected ones with <i>Simplify only selected faces</i>. The result has up "
         "to 2 % more or less, or the nearest number that there is. 0: not used.",
         "0: not used. Wins over the size of a cell."},
        std::nullopt);
  }

  static ParameterRow<Params> bound_row() {
    return row<Params>(
        &Params::max_error, "MaxError", "Maximum error",
        {"No point of the result is further from the original surface than this, and no point of "
         "the original further from the result: where it would be, the cells are smaller than "
         "asked for. With a <i>Size of a cell</i> of 0 they are as large as this allows. 0: no "
         "bound.",
         "No point of either surface is further from the other. 0: no bound."});
  }

  static ParameterRow<Params> representative_row() {
    return enum_row<Params>(
        &Params::representative, "Representative", "Representative of a cell",
        "Where the vertex of a cell goes. It stays within the cell.",
        {{Representative::Quadric, "lowest error",
          "where the squared distance to the planes of the faces is least, or, where that leaves a "
          "choice, near the mean: the lowest error (Lindstrom)"},
         {Representative::Mean, "smooth", "the mean of the cell's vertices"},
         {Representative::WeightedMean, "as below", "the same, with the weights chosen below"},
         {Representative::Median, "an original vertex",
          "the vertex nearest to the median of every coordinate: the result has original vertices "
          "only"},
         {Representative::CellCenter, "a regular pattern", "the middle of the cell"}});
  }

  static ParameterRow<Params> mean_weight_row() {
    return enum_row<Params>(
        &Params::mean_weight, "MeanWeight", "Weight in WeightedMean",
        "What a vertex counts in the representative WeightedMean.",
        {{MeanWeight::Area, "of the faces around",
          "the area around it: independent of the tessellation"},
         {MeanWeight::Curvature, "drawn to what is curved",
          "the area around it times its curvature |k1| + |k2|: drawn to what is curved"},
         {MeanWeight::Quality, "of the vertex",
          "its quality: paint or compute a high one on what matters"}});
  }

  static ParameterRow<Params> manifold_edges_row() {
    return row<Params>(
        &Params::manifold_edges, "ManifoldEdges", "At most two faces at an edge",
        {"Drop faces until no edge has more than two, and keep as many as possible. This leaves "
         "holes.",
         "Drops faces, and so leaves holes."});
  }

  static ParameterRow<Params> weight_row() {
    return boundary_weight_row<Params>(
        {"Weight of open borders against the surface in the representative Quadric, 1 counting "
         "both alike.",
         "Of open borders, in the representative Quadric."});
  }

  static ParameterRow<Params> quality_row() {
    return quality_weight_row<Params>(
        {"The quality of the vertices multiplies the planes of the representative Quadric: paint "
         "or compute a high quality on what matters.",
         "Vertex quality multiplies the quadrics."});
  }

  static ResultRows<Report, Params> loss_results() {
    return {
        result<Report, Params>("rejected_degenerate", "faces", "gone with two vertices in one cell",
                               &Report::degenerate),
        result<Report, Params>("rejected_duplicate", "faces",
                               "gone between the same three cells as another", &Report::duplicate),
        result<Report, Params>("rejected_crowded_edge", "faces",
                               "gone because an edge had more than two; only with `ManifoldEdges`",
                               &Report::crowded)};
  }
};

}  // namespace curvdecim::glue
