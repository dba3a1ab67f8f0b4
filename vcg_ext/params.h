// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace curvdecim {

/// What an edge collapse costs.
enum class Metric {
  Quadric,            ///< squared distance to planes @cite garland1997
  CurvatureWeighted,  ///< Quadric times a curvature factor @cite pellizzoni2020
  CurvatureAdditive,  ///< Quadric plus a curvature term @cite yao2015
};

/// In which unit curvature enters alpha.
enum class AlphaUnits {
  ScaleFree,   ///< curvature is compared with the most curved fifth of the input's area
  ModelUnits,  ///< curvature in the model's own unit of length, as printed @cite pellizzoni2020
};

enum class CurvatureKind {
  Gaussian,  ///< |K|, 1/length^2, from Gauss-Bonnet @cite pellizzoni2020
  Absolute,  ///< |k1| + |k2|, 1/length: also sees cylinders and straight ridges
};

/// Where the curvature is taken from.
enum class CurvatureOf {
  Input,    ///< the input, averaged over the one-ring; a merged vertex has it by area from its two
  Current,  ///< the mesh as it is after each collapse @cite pellizzoni2020
};

/// The two readings of the printed curvature term @cite yao2015.
enum class CurvatureTerm {
  Melax,    ///< edge length x max over faces of min over the edge's faces of (1 - n.n') / 2
  Literal,  ///< edge length x max over faces of max over the edge's faces of n.n'
};

enum class Quadrics {
  Memoryless,   ///< recomputed from the current mesh @cite lindstrom1998
  Accumulated,  ///< summed along the collapses @cite garland1997
};

enum class PlaneWeight {
  Area,  ///< a plane counts by the area of its face
  Unit,  ///< every plane counts 1, as in the papers
};

/// Where the merged vertex goes.
enum class Placement {
  Optimal,             ///< the minimum of the quadric in space
  Line,                ///< the minimum of the quadric along the edge
  EndpointOrMidpoint,  ///< the best of both ends and the midpoint
  HalfEdge,            ///< the better end: only original vertices remain
};

/// In which order edges collapse, and which costs are computed anew after a collapse.
enum class Scheduler {
  Rounds,     ///< many at once on all cores, the cheapest that lie apart; new edges' costs
  Lazy,       ///< one by one, the cheapest first; new edges' costs, others when they come up
  Eager,      ///< one by one, the cheapest first; costs of all edges around: slower, more exact
  FewRounds,  ///< as Rounds, with more collapses a round: faster, further from the greedy order
};

/// Speed against quality: a named setting of quadrics, plane_weight, placement, scheduler and
/// refine_sweeps.
enum class Preset { Fast, Balanced, Best, Custom };

/// What every decimation shares. Lengths are in the mesh's unit, angles in degrees.
struct DecimationParams {
  static constexpr int no_target = std::numeric_limits<int>::max();

  int target_faces = no_target;  ///< stop at this many faces (selected faces with selected_only)
  int target_vertices = 0;       ///< stop at this many vertices; 0: not used
  double target_fraction =
      0.0;                 ///< (0, 1]: fraction of the faces to keep; 0: not used, else it wins
  double max_error = 0.0;  ///< >= 0, length: two-sided distance bound; 0: no bound
  bool preserve_boundary = true;  ///< boundary vertices stay on the boundary curve
  double boundary_weight = 1.0;   ///< >= 0: weight of the boundary and feature quadrics
  bool preserve_normal = true;    ///< refuse a face whose normal turns more than normal_angle
  double normal_angle = 90.0;     ///< (0, 180], degrees
  bool preserve_topology = true;  ///< link condition @cite dey1999
  double feature_angle = 60.0;    ///< [0, 180], degrees: dihedral angle of a feature; 180: none
  bool selected_only = false;     ///< only selected faces change
  bool quality_weight = false;    ///< per-vertex quality multiplies the cost
  int threads = 0;                ///< >= 0; 0: all cores; never changes the result
};

/// How curvature becomes a factor on the cost @cite pellizzoni2020.
struct CurvatureParams {
  double alpha = 0.5;            ///< <= 0: infinite, that is plain quadrics
  double curvature_floor = 0.3;  ///< [0, 1]: factor of a flat vertex with AlphaUnits::ScaleFree
  AlphaUnits alpha_units = AlphaUnits::ScaleFree;
  CurvatureKind curvature_kind = CurvatureKind::Absolute;
  CurvatureOf curvature_of = CurvatureOf::Input;
};

/// How quadrics are made, and where their merged vertices go.
struct QuadricParams {
  Quadrics quadrics = Quadrics::Memoryless;
  PlaneWeight plane_weight = PlaneWeight::Area;
  Placement placement = Placement::Optimal;
};

struct EdgeCollapseParams : DecimationParams, CurvatureParams, QuadricParams {
  Preset preset = Preset::Balanced;
  Metric metric = Metric::CurvatureWeighted;
  double lambda = 1e-3;  ///< >= 0: weight of the additive term, for a mesh of diagonal 1
  CurvatureTerm curvature_term = CurvatureTerm::Melax;
  Scheduler scheduler = Scheduler::Rounds;
  int refine_sweeps = 0;  ///< >= 0: fits of the vertices and flips of edges after the collapses;
                          ///< none with max_error or HalfEdge
  double pair_distance = 0.0;  ///< >= 0, length: unconnected vertices of the input that are closer
                               ///< may merge; turns preserve_topology off, not with max_error
};

/// What a collapse costs between the spheres and the faces around @cite michaud2017.
enum class SphereEnergy {
  Squared,  ///< integral of the squared distance
  Poster,   ///< sum over the faces of |mean signed distance| times area, as printed
};

/// Where the merged vertex goes, and so which sphere it gets.
enum class SpherePlacement {
  Free3D,             ///< where spheres and planes are nearest; the sphere of all that it has met
  OnSphereAlongEdge,  ///< on the sphere between those of the edge's ends, as printed
};

/// Edge collapse by algebraic spheres @cite michaud2017.
struct SphereParams : DecimationParams {
  static constexpr double least_kernel_scale = 1.0, largest_kernel_scale = 10.0;

  double kernel_scale = 2.0;    ///< [1, 10]: radius of a fit, to the mean edge around the vertex
  bool adaptive_kernel = true;  ///< smaller where the fit is bad, larger where it is good
  SphereEnergy energy = SphereEnergy::Squared;
  SpherePlacement placement = SpherePlacement::Free3D;
  int refine_sweeps = 0;  ///< >= 0: as EdgeCollapseParams::refine_sweeps
};

/// Which vertex goes next @cite schroeder1992.
enum class RemovalCriterion {
  Heap,    ///< the one with the least distance
  Passes,  ///< in turn, all within a threshold that rises from pass to pass, as in the paper
};

/// Topology is kept always: preserve_topology does not count. boundary_weight is a factor on
/// distances to boundary and feature lines; without preserve_boundary those to boundaries count 0.
struct VertexRemovalParams : DecimationParams {
  RemovalCriterion criterion = RemovalCriterion::Heap;
  double distance_bound = 0.0;     ///< >= 0, length: on the sum of distances at a vertex; 0: none
  double aspect_ratio_min = 0.01;  ///< [0, 0.5]: of the lines that split a loop
  bool preserve_features = false;  ///< nothing leaves a sharp edge, and corners stay
};

/// Where the vertices of a cell go @cite ciolczyk.
enum class Representative {
  Quadric,       ///< the least squared distance to the planes of the faces, within the cell
  Mean,          ///< the mean of the vertices
  WeightedMean,  ///< the same, by MeanWeight
  Median,        ///< the vertex nearest to the median of every coordinate
  CellCenter,    ///< the middle of the cell
};

/// By what WeightedMean weighs a vertex.
enum class MeanWeight {
  Area,       ///< a third of the faces around it
  Curvature,  ///< the same times |k1| + |k2|
  Quality,    ///< the vertex quality
};

/// Lengths are in the mesh's unit.
struct ClusteringParams {
  double cell_size = 0.0;  ///< >= 0: largest diameter of a cell; no vertex moves further
  int target_faces = 0;    ///< >= 0: instead of cell_size, this many faces (selected faces with
                           ///< selected_only), within 2 % or the nearest; 0: not used
  double target_fraction =
      0.0;  ///< [0, 1]: fraction of the faces to keep; 0: not used, else it wins
  Representative representative = Representative::Quadric;
  MeanWeight mean_weight = MeanWeight::Area;
  double boundary_weight = 1.0;  ///< >= 0: weight of the boundary in the quadrics
  bool quality_weight = false;   ///< per-vertex quality multiplies the quadrics
  bool manifold_edges = false;   ///< drop faces until no edge has more than two
  bool selected_only = false;    ///< only selected faces change
  int threads = 0;               ///< >= 0; 0: all cores; never changes the result
};

/// What the Curvature Importance filter shows.
struct ImportanceParams : CurvatureParams {
  bool as_factor = false;  ///< the factor on the cost instead of the curvature itself
};

}  // namespace curvdecim
