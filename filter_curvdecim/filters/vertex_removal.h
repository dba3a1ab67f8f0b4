// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

#include <vcg/space/color4.h>

#include "filter_curvdecim/filters/common_results.h"
#include "filter_curvdecim/filters/common_rows.h"
#include "filter_curvdecim/table/filter.h"
#include "filter_curvdecim/table/joined.h"
#include "filter_curvdecim/table/references.h"
#include "vcg_ext/vertex_removal.h"

namespace curvdecim::glue {

/// Vertex removal, and what it shows.
struct RemovalParams : VertexRemovalParams {
  bool show_classes = false;  ///< writes the classes of the vertices to their quality and colour

  static constexpr auto fields() {
    return std::tuple_cat(VertexRemovalParams::fields(),
                          std::tuple(Field("show_classes", &RemovalParams::show_classes)));
  }
};

/// How many vertices of the result are of each class.
using ClassCounts = std::array<std::int64_t, labels(VertexClass()).size()>;

struct RemovalReport : DecimationReport {
  std::optional<ClassCounts> classes;  ///< where they are shown
};

inline vcg::Color4b color_of(VertexClass vertex_class) {
  switch (vertex_class) {
    case VertexClass::Simple: return {200, 200, 200, 255};
    case VertexClass::Complex: return {220, 50, 47, 255};
    case VertexClass::Boundary: return {38, 139, 210, 255};
    case VertexClass::InteriorEdge: return {133, 153, 0, 255};
    case VertexClass::Corner: return {203, 75, 22, 255};
  }
  return {0, 0, 0, 255};
}

inline const char* meaning_of(VertexClass vertex_class) {
  switch (vertex_class) {
    case VertexClass::Simple: return "inside the surface, on no sharp edge";
    case VertexClass::Complex: return "whose faces are no fan, or not oriented alike";
    case VertexClass::Boundary: return "on a border, on no sharp edge";
    case VertexClass::InteriorEdge: return "on a line of sharp edges";
    case VertexClass::Corner: return "where a line of sharp edges ends, or more than two meet";
  }
  return "";
}

/// Writes the class of every vertex of a face to its quality, by number, and to its colour.
template <class MeshType>
ClassCounts show_classes(MeshType& mesh, const VertexRemovalParams& params) {
  ClassCounts counts{};
  const auto classes = vertex_classes(mesh, params);
  for (std::size_t v = 0; v < classes.size(); ++v) {
    if (!classes[v]) continue;
    ++counts[static_cast<std::size_t>(*classes[v])];
    mesh.vert[v].Q() = static_cast<typename MeshType::ScalarType>(*classes[v]);
    mesh.vert[v].C() = color_of(*classes[v]);
  }
  return counts;
}

/// Removal of vertices one by one.
struct VertexRemovalFilter {
  using Params = RemovalParams;
  using Report = RemovalReport;

  template <class MeshType>
  static Report run(MeshType& mesh, const Params& params, const Progress& progress) {
    Report report{decimate_vertex_removal(mesh, params, progress), std::nullopt};
    if (params.show_classes && report.stopped_by != StopReason::Cancelled)
      report.classes = show_classes(mesh, params);
    return report;
  }

  static Changes changed(const Report& report) {
    return {change_of_shape(report).shape, report.classes.has_value()};
  }

  static std::string headline(const Report& report) {
    const std::string headline = headline_of(report, changed(report));
    if (!headline.empty() || !report.classes) return headline;
    return "Every vertex has its class as quality and as colour.";
  }

  static About about() {
    constexpr Reference schroeder = {"Schroeder, Zarge, Lorensen", "SIGGRAPH 1992"};
    return {
        "Simplification: Vertex Removal (Schroeder)",
        "meshing_decimation_vertex_removal",
        Category::Remeshing,
        {true, true},
        "Simplify (decimate, reduce) to some of the original vertices." + bibliography({schroeder}),
        "Vertices go one by one, those nearest to the surface that is left first, and the holes "
        "are filled with triangles. Those that stay keep all that they carry, to the bit. A "
        "manifold stays one. Edge collapse moves vertices and has a lower error.",
        {"preserve_topology", "attribute_weight", "prevent_intersections", "max_error_one_sided"}};
  }

  static ParameterRows<Params> parameters() {
    return joined<ParameterRow<Params>>(
        {target_rows<Params>(),
         {selected_row<Params>(), show_classes_row(), tuning(quality_weight_row<Params>()),
          paper(keep_map_row<Params>()), tuning(threads_row<Params>())},
         for_papers<Params>({criterion_row(), distance_bound_row(), aspect_ratio_min_row()}),
         under<Params>("Keep", guard_rows())});
  }

  static ResultRows<Report, Params> results() {
    return joined<ResultRow<Report, Params>>(
        {count_results<Report, Params>(),
         {max_error_result<Report, Params>(),
          cost_last_result<Report, Params>("the cost of the last removal")},
         rejection_results<Report, Params>(
             "removals", {Rejection::VertexClass, Rejection::LoopSplit, Rejection::LinkCondition,
                          Rejection::NormalFlip, Rejection::TriangleShape, Rejection::ErrorBound}),
         {seconds_result<Report, Params>()},
         class_results()});
  }

 private:
  static ParameterRow<Params> distance_bound_row() {
    return row<Params>(
        &Params::distance_bound, "DistanceBound", "Accumulated distance",
        {"The distances between old and new faces add up at the vertices around. A vertex stays "
         "whose removal would bring the sum above this. No point of the result is then further "
         "from the original surface, nor the other way round. <i>Maximum error</i> promises that, "
         "too, by distances that are measured, and leaves fewer faces. 0: none.",
         "No sum of distances is larger, and so no error. 0: no bound."});
  }

  static ParameterRow<Params> criterion_row() {
    return enum_row<Params>(
        &Params::criterion, "Criterion", "Which vertex goes next",
        "The distance is that of a vertex to the average plane of its faces, to the border or to "
        "the sharp edge that it is on, and then between the old and the new faces.",
        {{RemovalCriterion::Heap, "the nearest, lower error",
          "the one whose removal costs least: its squared distance times the area around, with "
          "what went before near it"},
         {RemovalCriterion::Passes, "all within a threshold",
          "in turn all whose accumulated distance is within a threshold, which rises from pass to "
          "pass, as in the paper"}});
  }

  static ParameterRow<Params> aspect_ratio_min_row() {
    return row<Params>(
        &Params::aspect_ratio_min, "AspectRatioMin", "Least aspect ratio of a split",
        {"The loop around a removed vertex is split by lines between two of its vertices. A line "
         "is refused when another vertex of the loop is nearer to it than this part of its length. "
         "More gives rounder triangles and more error, and may stop before the target; a square "
         "has 0.5.",
         "More gives rounder triangles and may stop before the target."});
  }

  static ParameterRow<Params> preserve_features_row() {
    return row<Params>(
        &Params::preserve_features, "PreserveFeatures", "Preserve sharp edges and corners",
        {"Vertices on edges sharper than <i>Feature angle</i> go only along these edges, and "
         "corners, where an edge ends or more than two meet, stay. May stop before the target. "
         "Off: they go along them where they can, and in any other way where that costs little.",
         "Nothing leaves a sharp edge, and corners stay."});
  }

  static ParameterRow<Params> show_classes_row() {
    return row<Params>(
        &Params::show_classes, "ShowClasses", "Show the classes of the vertices",
        {"Write to quality and colour of every vertex of the result what stands around it: 0 "
         "simple (grey), 1 complex (red), 2 boundary (blue), 3 interior edge (green), 4 corner "
         "(orange). With a <i>Fraction of the faces</i> of 1 the mesh itself stays as it is.",
         "As quality and colour: simple, complex, boundary, interior edge, corner."});
  }

  static ParameterRows<Params> guard_rows() {
    return {preserve_boundary_row<Params>(
                {"The distance of a border vertex to the new border counts. Switch off to let "
                 "borders shrink.",
                 "Distances to open borders count."}),
            tuning(boundary_weight_row<Params>(
                {"Factor on distances to borders and sharp edges in the cost. Raise it to keep "
                 "more vertices on them.",
                 "Of distances to borders and sharp edges."})),
            preserve_normal_row<Params>(),
            tuning(normal_angle_row<Params>()),
            tuning(join_borders_row<Params>()),
            preserve_features_row(),
            tuning(feature_angle_row<Params>(
                {"An edge of the input between faces whose normals differ by at least this is "
                 "sharp: vertices on it go along it, and the loop around them is split there. 180: "
                 "no edge is.",
                 "Edges with at least this angle between their faces are sharp."})),
            tuning(keep_borders_of_row<Params>())};
  }

  static ResultRows<Report, Params> class_results() {
    ResultRows<Report, Params> rows;
    for (std::size_t i = 0; i < labels(VertexClass()).size(); ++i) {
      const auto vertex_class = static_cast<VertexClass>(i);
      rows.push_back({{std::string("vertices_") + label_of(vertex_class), "vertices",
                       meaning_of(vertex_class) + std::string("; only with `ShowClasses`")},
                      [i](const Report& report, const Params&) { return count_of(report, i); }});
    }
    return rows;
  }

  static std::optional<ResultValue> count_of(const Report& report, std::size_t vertex_class) {
    if (!report.classes) return std::nullopt;
    return (*report.classes)[vertex_class];
  }
};

}  // namespace curvdecim::glue
