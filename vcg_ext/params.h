// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <tuple>

#include "vcg_ext/field.h"

namespace curvdecim {

/// What an edge collapse costs.
enum class Metric {
  Quadric,            ///< squared distance to planes @cite garland1997
  CurvatureWeighted,  ///< Quadric times a curvature factor @cite pellizzoni2020
  CurvatureAdditive,  ///< Quadric plus a curvature term @cite yao2015
};
constexpr auto labels(Metric) {
  return std::array{"Quadric", "CurvatureWeighted", "CurvatureAdditive"};
}

/// In which unit curvature enters alpha.
enum class AlphaUnits {
  ScaleFree,   ///< curvature is compared with the most curved fifth of the input's area
  ModelUnits,  ///< curvature in the model's own unit of length, as printed @cite pellizzoni2020
};
constexpr auto labels(AlphaUnits) { return std::array{"ScaleFree", "ModelUnits"}; }

enum class CurvatureKind {
  Gaussian,  ///< |K|, 1/length^2, from Gauss-Bonnet @cite pellizzoni2020
  Absolute,  ///< |k1| + |k2|, 1/length: also sees cylinders and straight ridges
};
constexpr auto labels(CurvatureKind) { return std::array{"Gaussian", "Absolute"}; }

/// Where the curvature is taken from.
enum class CurvatureOf {
  Input,    ///< the input, averaged over the one-ring; a merged vertex has it by area from its two
  Current,  ///< the mesh as it is after each collapse @cite pellizzoni2020
};
constexpr auto labels(CurvatureOf) { return std::array{"Input", "Current"}; }

/// The two readings of the printed curvature term @cite yao2015.
enum class CurvatureTerm {
  Melax,    ///< edge length x max over faces of min over the edge's faces of (1 - n.n') / 2
  Literal,  ///< edge length x max over faces of max over the edge's faces of n.n'
};
constexpr auto labels(CurvatureTerm) { return std::array{"Melax", "Literal"}; }

enum class Quadrics {
  Memoryless,   ///< recomputed from the current mesh @cite lindstrom1998
  Accumulated,  ///< summed along the collapses @cite garland1997
};
constexpr auto labels(Quadrics) { return std::array{"Memoryless", "Accumulated"}; }

enum class PlaneWeight {
  Area,  ///< a plane counts by the area of its face
  Unit,  ///< every plane counts 1, as in the papers
};
constexpr auto labels(PlaneWeight) { return std::array{"Area", "Unit"}; }

/// Where the merged vertex goes.
enum class Placement {
  Optimal,             ///< the minimum of the quadric in space
  Line,                ///< the minimum of the quadric along the edge
  EndpointOrMidpoint,  ///< the best of both ends and the midpoint
  HalfEdge,            ///< the better end: only original vertices remain
};
constexpr auto labels(Placement) {
  return std::array{"Optimal", "Line", "EndpointOrMidpoint", "HalfEdge"};
}

/// In which order edges collapse, and which costs are computed anew after a collapse.
enum class Scheduler {
  Rounds,     ///< many at once on all cores, in passes, then the cheapest that lie apart
  Lazy,       ///< one by one, the cheapest first; new edges' costs, others when they come up
  Eager,      ///< one by one, the cheapest first; costs of all edges around: slower, more exact
  FewRounds,  ///< as Rounds, with more passes and more collapses a round: faster, less exact
};
constexpr auto labels(Scheduler) { return std::array{"Rounds", "Lazy", "Eager", "FewRounds"}; }

/// Speed against quality: a named setting of quadrics, plane_weight, placement, scheduler and
/// refine_sweeps.
enum class Preset { Fast, Balanced, Best, Custom };
constexpr auto labels(Preset) { return std::array{"Fast", "Balanced", "Best", "Custom"}; }

/// Groups of faces whose borders stay lines of the mesh.
enum class KeepBordersOf {
  Nothing,
  FaceColor,       ///< faces of one colour, as of one material
  FaceQuality,     ///< faces of one quality, as of one segment
  FaceAttributes,  ///< faces that are the same in all custom attributes of numbers and points
};
constexpr auto labels(KeepBordersOf) {
  return std::array{"Nothing", "FaceColor", "FaceQuality", "FaceAttributes"};
}

/// What every decimation has. Here and below fields() has the range and the unit of every member.
struct CommonParams {
  double target_fraction = 0.0;  ///< part of the faces to keep; 0: not used, else it wins
  double boundary_weight = 1.0;  ///< of the boundary, and of sharp edges, against the surface
  bool selected_only = false;    ///< only selected faces change, and targets count these
  bool quality_weight = false;   ///< per-vertex quality multiplies the cost
  bool keep_map = false;         ///< which vertices became which (vcg_ext/vertex_map.h)
  int threads = 0;               ///< 0: all cores; never changes the result

  static constexpr auto fields() {
    using P = CommonParams;
    return std::tuple(Field("target_fraction", &P::target_fraction, between(0.0, 1.0)),
                      Field("boundary_weight", &P::boundary_weight, at_least(0.0)),
                      Field("selected_only", &P::selected_only),
                      Field("quality_weight", &P::quality_weight), Field("keep_map", &P::keep_map),
                      Field("threads", &P::threads, at_least(0.0, "threads")));
  }
};

/// What every decimation step by step has.
struct DecimationParams : CommonParams {
  static constexpr int no_target = std::numeric_limits<int>::max();

  int target_faces = no_target;  ///< stop at this many faces
  int target_vertices = 0;       ///< stop at this many vertices; 0: not used
  double max_error = 0.0;        ///< no point of either surface is further from the other; 0: no
                                 ///< bound
  bool max_error_one_sided = false;  ///< no point of the result is further from the input
  bool preserve_boundary = true;     ///< boundary vertices stay on the boundary curve
  bool preserve_normal = true;       ///< refuse a face whose normal turns more than normal_angle
  double normal_angle = 90.0;        ///< largest turn of a face
  bool preserve_topology = false;    ///< link condition @cite dey1999; off: gives way by size
  bool join_borders = true;          ///< those that lie on each other, for the run
  double attribute_weight = 0.01;    ///< of texture and colours against the error of the surface
  double feature_angle = 60.0;       ///< dihedral angle from which an edge is sharp; 180: none is
  KeepBordersOf keep_borders_of = KeepBordersOf::Nothing;  ///< beside those of textures
  /// No face crosses another that it did not cross before.
  bool prevent_intersections = false;

  static constexpr auto fields() {
    using P = DecimationParams;
    return std::tuple_cat(
        CommonParams::fields(),
        std::tuple(Field("target_faces", &P::target_faces, at_least(0.0, "faces")),
                   Field("target_vertices", &P::target_vertices, at_least(0.0, "vertices")),
                   Field("max_error", &P::max_error, at_least(0.0, length_unit)),
                   Field("max_error_one_sided", &P::max_error_one_sided),
                   Field("preserve_boundary", &P::preserve_boundary),
                   Field("preserve_normal", &P::preserve_normal),
                   Field("normal_angle", &P::normal_angle, above_up_to(0.0, 180.0, "degrees")),
                   Field("preserve_topology", &P::preserve_topology),
                   Field("join_borders", &P::join_borders),
                   Field("attribute_weight", &P::attribute_weight, at_least(0.0)),
                   Field("feature_angle", &P::feature_angle, between(0.0, 180.0, "degrees")),
                   Field("keep_borders_of", &P::keep_borders_of),
                   Field("prevent_intersections", &P::prevent_intersections)));
  }
};

/// How curvature becomes a factor on the cost @cite pellizzoni2020.
struct CurvatureParams {
  double alpha = 0.5;            ///< 0 or less: infinite, that is plain quadrics
  double curvature_floor = 0.3;  ///< factor of a flat vertex with AlphaUnits::ScaleFree
  AlphaUnits alpha_units = AlphaUnits::ScaleFree;
  CurvatureKind curvature_kind = CurvatureKind::Absolute;
  CurvatureOf curvature_of = CurvatureOf::Input;

  static constexpr auto fields() {
    using P = CurvatureParams;
    return std::tuple(
        Field("alpha", &P::alpha), Field("curvature_floor", &P::curvature_floor, between(0.0, 1.0)),
        Field("alpha_units", &P::alpha_units), Field("curvature_kind", &P::curvature_kind),
        Field("curvature_of", &P::curvature_of));
  }
};

/// How quadrics are made, and where their merged vertices go.
struct QuadricParams {
  Quadrics quadrics = Quadrics::Memoryless;
  PlaneWeight plane_weight = PlaneWeight::Area;
  Placement placement = Placement::Optimal;

  static constexpr auto fields() {
    using P = QuadricParams;
    return std::tuple(Field("quadrics", &P::quadrics), Field("plane_weight", &P::plane_weight),
                      Field("placement", &P::placement));
  }
};

struct EdgeCollapseParams : DecimationParams, CurvatureParams, QuadricParams {
  Preset preset = Preset::Balanced;
  Metric metric = Metric::CurvatureWeighted;
  double lambda = 1e-3;  ///< weight of the additive term, for a mesh of diagonal 1
  CurvatureTerm curvature_term = CurvatureTerm::Melax;
  Scheduler scheduler = Scheduler::Rounds;
  int refine_sweeps = 0;  ///< fits of the vertices and flips of edges after the collapses; none
                          ///< with HalfEdge
  double pair_distance = 0.0;  ///< unconnected vertices of the input that are closer may merge;
                               ///< turns preserve_topology off, not with max_error

  static constexpr auto fields() {
    using P = EdgeCollapseParams;
    return std::tuple_cat(
        DecimationParams::fields(), CurvatureParams::fields(), QuadricParams::fields(),
        std::tuple(Field("preset", &P::preset), Field("metric", &P::metric),
                   Field("lambda", &P::lambda, at_least(0.0)),
                   Field("curvature_term", &P::curvature_term), Field("scheduler", &P::scheduler),
                   Field("refine_sweeps", &P::refine_sweeps, at_least(0.0, "sweeps")),
                   Field("pair_distance", &P::pair_distance, at_least(0.0, length_unit))));
  }
};

/// What a collapse costs between the spheres and the faces around @cite michaud2017.
enum class SphereEnergy {
  Squared,  ///< integral of the squared distance
  Poster,   ///< sum over the faces of |mean signed distance| times area, as printed
};
constexpr auto labels(SphereEnergy) { return std::array{"Squared", "Poster"}; }

/// Where the merged vertex goes, and so which sphere it gets.
enum class SpherePlacement {
  Free3D,             ///< where spheres and planes are nearest; the sphere of all that it has met
  OnSphereAlongEdge,  ///< on the sphere between those of the edge's ends, as printed
};
constexpr auto labels(SpherePlacement) { return std::array{"Free3D", "OnSphereAlongEdge"}; }

/// The neighbourhood that a sphere is fitted to.
struct KernelParams {
  double kernel_scale = 2.0;    ///< its radius, to the mean edge around the vertex
  bool adaptive_kernel = true;  ///< smaller where the fit is bad, larger where it is good

  static constexpr auto fields() {
    using P = KernelParams;
    return std::tuple(
        Field("kernel_scale", &P::kernel_scale, between(1.0, 10.0, "times the mean edge around")),
        Field("adaptive_kernel", &P::adaptive_kernel));
  }
};

/// Edge collapse by algebraic spheres @cite michaud2017.
struct SphereParams : DecimationParams, KernelParams {
  SphereEnergy energy = SphereEnergy::Squared;
  SpherePlacement placement = SpherePlacement::Free3D;
  int refine_sweeps = 0;  ///< as EdgeCollapseParams::refine_sweeps

  static constexpr auto fields() {
    using P = SphereParams;
    return std::tuple_cat(
        DecimationParams::fields(), KernelParams::fields(),
        std::tuple(Field("energy", &P::energy), Field("placement", &P::placement),
                   Field("refine_sweeps", &P::refine_sweeps, at_least(0.0, "sweeps"))));
  }
};

/// Which vertex goes next @cite schroeder1992.
enum class RemovalCriterion {
  Heap,    ///< the one with the least distance
  Passes,  ///< in turn, all within a threshold that rises from pass to pass, as in the paper
};
constexpr auto labels(RemovalCriterion) { return std::array{"Heap", "Passes"}; }

/// Topology is kept always and nothing moves: preserve_topology, prevent_intersections and
/// attribute_weight do not count.
/// boundary_weight is a factor on distances to boundary and feature lines; without
/// preserve_boundary those to boundaries count 0.
struct VertexRemovalParams : DecimationParams {
  RemovalCriterion criterion = RemovalCriterion::Heap;
  double distance_bound = 0.0;     ///< on the sum of distances at a vertex; 0: none
  double aspect_ratio_min = 0.01;  ///< of the lines that split a loop
  bool preserve_features = false;  ///< nothing leaves a sharp edge, and corners stay

  static constexpr auto fields() {
    using P = VertexRemovalParams;
    return std::tuple_cat(
        DecimationParams::fields(),
        std::tuple(Field("criterion", &P::criterion),
                   Field("distance_bound", &P::distance_bound, at_least(0.0, length_unit)),
                   Field("aspect_ratio_min", &P::aspect_ratio_min, between(0.0, 0.5)),
                   Field("preserve_features", &P::preserve_features)));
  }
};

/// Where the vertices of a cell go @cite ciolczyk.
enum class Representative {
  Quadric,       ///< the least squared distance to the planes of the faces, within the cell
  Mean,          ///< the mean of the vertices
  WeightedMean,  ///< the same, by MeanWeight
  Median,        ///< the vertex nearest to the median of every coordinate
  CellCenter,    ///< the middle of the cell
};
constexpr auto labels(Representative) {
  return std::array{"Quadric", "Mean", "WeightedMean", "Median", "CellCenter"};
}

/// By what WeightedMean weighs a vertex.
enum class MeanWeight {
  Area,       ///< a third of the faces around it
  Curvature,  ///< the same times |k1| + |k2|
  Quality,    ///< the vertex quality
};
constexpr auto labels(MeanWeight) { return std::array{"Area", "Curvature", "Quality"}; }

/// boundary_weight and quality_weight are for the representative Quadric.
struct ClusteringParams : CommonParams {
  double cell_size = 0.0;  ///< largest diameter of a cell; no vertex moves further
  int target_faces = 0;    ///< instead of cell_size, this many faces, within 2 % or the nearest;
                           ///< 0: not used
  double max_error = 0.0;  ///< smaller cells where a point of either surface would be further from
                           ///< the other; alone: the largest cells; 0: no bound
  Representative representative = Representative::Quadric;
  MeanWeight mean_weight = MeanWeight::Area;
  bool manifold_edges = false;  ///< drop faces until no edge has more than two

  static constexpr auto fields() {
    using P = ClusteringParams;
    return std::tuple_cat(
        CommonParams::fields(),
        std::tuple(Field("cell_size", &P::cell_size, at_least(0.0, length_unit)),
                   Field("target_faces", &P::target_faces, at_least(0.0, "faces")),
                   Field("max_error", &P::max_error, at_least(0.0, length_unit)),
                   Field("representative", &P::representative),
                   Field("mean_weight", &P::mean_weight),
                   Field("manifold_edges", &P::manifold_edges)));
  }
};

/// What the curvature importance of a vertex is.
enum class ImportanceOf {
  Curvature,  ///< the curvature itself, in the mesh's unit
  Factor,     ///< the factor on the cost, 0..1
};
constexpr auto labels(ImportanceOf) { return std::array{"Curvature", "Factor"}; }

struct ImportanceParams : CurvatureParams {
  ImportanceOf output = ImportanceOf::Curvature;

  static constexpr auto fields() {
    return std::tuple_cat(CurvatureParams::fields(),
                          std::tuple(Field("output", &ImportanceParams::output)));
  }
};

}  // namespace curvdecim
