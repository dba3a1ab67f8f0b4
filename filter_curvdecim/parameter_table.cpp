// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/parameter_bindings.h"

namespace curvdecim {
namespace {

constexpr Range any;
constexpr Range fraction = {0.0, 1.0};

constexpr Range at_least(double low) { return {low}; }
constexpr Range above_up_to(double low, double high) { return {low, high, true}; }

// A row reads best as name, help, hint, values, binding.
// clang-format off
std::vector<Parameter> target_rows() {
  return {
      {"CellSize", "Size of a cell", Kind::Length, at_least(0), "in the mesh's unit",
       "The largest diameter of a cell: no vertex moves further. Given as a length or as per cent "
       "of the bounding box's diagonal. Not used with a <i>Target number of faces</i> or "
       "<i>Fraction of the faces</i>.",
       "Its largest diameter: no vertex moves further than this.",
       {}, {clustering<&ClusteringParams::cell_size>(MeshDefault::PercentOfDiagonal)}},
      {"TargetFaceNum", "Target number of faces", Kind::Int, at_least(0), "faces",
       "Stop at this many faces; with <i>Simplify only selected faces</i>, at this many selected "
       "faces. A last step removes two faces at once, so the result may have one face less. "
       "0: as few as the other parameters allow, for example up to <i>Maximum error</i>.",
       "Stop at this many faces (selected faces, if only those may change).",
       {}, decimation<&DecimationParams::target_faces>(MeshDefault::HalfOfFaces,
           {meaning(clustering<&ClusteringParams::target_faces>(),
                    "Instead of <i>Size of a cell</i>: the size is looked for at which this many "
                    "faces are left, of the selected ones with <i>Simplify only selected faces</i>. "
                    "The result has up to 2 % more or less, or the nearest number that there is. "
                    "0: not used.",
                    "0: not used. Wins over the size of a cell.")})},
      {"TargetPerc", "Fraction of the faces (0..1; 0: not used)", Kind::Float, fraction, "",
       "0.2 keeps a fifth of the faces, of the selected ones with <i>Simplify only selected "
       "faces</i>. 0: not used; otherwise it wins over <i>Target number of faces</i>.",
       "0.2 keeps a fifth of the faces. Wins over the number of faces.",
       {}, every_decimation<&DecimationParams::target_fraction,
                            &ClusteringParams::target_fraction>()},
      {"TargetVertNum", "Target number of vertices (0: not used)",
       Kind::Int, at_least(0), "vertices",
       "Stop at this many vertices of the whole mesh. 0: not used; otherwise it wins over "
       "<i>Target number of faces</i>.",
       "Stop at this many vertices. Wins over the number of faces.",
       {}, decimation<&DecimationParams::target_vertices>()},
      {"MaxError", "Maximum error (0: no bound)", Kind::Length, at_least(0), "in the mesh's unit",
       "No point of the result is further from the original surface than this, and no point of "
       "the original further from the result. Given as a length or as per cent of the bounding "
       "box's diagonal. Together with a target, whichever comes first stops. 0: no bound.",
       "No point of either surface is further than this from the other.",
       {}, decimation<&DecimationParams::max_error>()},
      {"DistanceBound", "Bound on accumulated distances (0: none)", Kind::Length, at_least(0),
       "in the mesh's unit",
       "The distances between old and new faces add up at the vertices around. A vertex stays whose "
       "removal would bring the sum above this. No point of the result is then further from the "
       "original surface, nor the other way round: the same promise as <i>Maximum error</i>, the "
       "smaller of both counts.",
       "No sum of distances is larger, and so no error.",
       {}, {removal<&VertexRemovalParams::distance_bound>()}},
  };
}

std::vector<Parameter> metric_rows() {
  return {
      {"Preset", "Preset", Kind::Enum, any, "",
       "Speed against quality, as a named setting of <i>Quadrics</i>, <i>Weight of a plane</i>, "
       "<i>Placement</i>, <i>Scheduler</i> and <i>Refinement sweeps</i>. The metric and its weights "
       "stay as given.", "",
       {{"Fast", "", "memoryless quadrics, few rounds: the least time"},
        {"Balanced", "", "more rounds: lower error"},
        {"Best", "slower",
         "the same, then the result is fitted to the input: slower, a sixth less error"},
        {"Custom", "as below", "every parameter as given below"}},
       {edge_collapse<&EdgeCollapseParams::preset>()}},
      {"Metric", "Cost of an edge", Kind::Enum, any, "",
       "What decides which edge is collapsed next.", "",
       {{"Quadric", "plain",
         "squared distance to the planes of the faces around (Garland and Heckbert)"},
        {"CurvatureWeighted", "",
         "the same, times a factor that grows with the curvature (Pellizzoni and Savio)"},
        {"CurvatureAdditive", "plus bend",
         "the same, plus a term that grows with the bend at the edge (Yao and others)"}},
       {edge_collapse<&EdgeCollapseParams::metric>()}},
  };
}

std::vector<Parameter> sphere_rows() {
  return {
      {"KernelScale", "Size of the kernel (edges)", Kind::Float,
       {SphereParams::least_kernel_scale, SphereParams::largest_kernel_scale},
       "times the mean edge around",
       "Radius of the neighbourhood that a sphere is fitted to, in mean edges around its vertex. "
       "More smooths noise and blurs what is small.",
       "Radius of a fit; more smooths noise and blurs small shapes.",
       {}, {sphere<&SphereParams::kernel_scale>()}},
      {"AdaptiveKernel", "Adapt the kernel to the shape", Kind::Bool, any, "",
       "The kernel shrinks where its sphere is far from the vertices that it was fitted to, and "
       "grows where it is near to them.",
       "Smaller where the fit is bad, larger where it is good.",
       {}, {sphere<&SphereParams::adaptive_kernel>()}},
      {"Energy", "Distance to the spheres", Kind::Enum, any, "",
       "How the distances of the new faces to the spheres are summed up.", "",
       {{"Squared", "lower error", "the integral of the squared distance: lower error"},
        {"Poster", "as printed",
         "the sum over the faces of the mean distance times the area, as printed (Michaud and "
         "others)"}},
       {sphere<&SphereParams::energy>()}},
      {"Placement", "Placement", Kind::Enum, any, "",
       "Where the merged vertex goes, and which sphere it keeps.", "",
       {{"Free3D", "free, lower error",
         "where spheres and planes are nearest, with a sphere fitted to all of the original that "
         "the vertex stands for: lower error"},
        {"OnSphereAlongEdge", "as printed",
         "on the sphere between those of both ends, which it keeps, as printed: forgets the "
         "original step by step"}},
       {sphere<&SphereParams::placement>()}},
  };
}

std::vector<Parameter> removal_rows() {
  return {
      {"Criterion", "Which vertex goes next", Kind::Enum, any, "",
       "The distance is that of a vertex to the average plane of its faces, to the border or to the "
       "sharp edge that it is on, and then between the old and the new faces.", "",
       {{"Heap", "the nearest, lower error",
         "the one whose removal costs least: its squared distance times the area around, with what "
         "went before near it"},
        {"Passes", "all within a threshold",
         "in turn all whose accumulated distance is within a threshold, which rises from pass to "
         "pass, as in the paper"}},
       {removal<&VertexRemovalParams::criterion>()}},
      {"AspectRatioMin", "Least aspect ratio of a split", Kind::Float, {0.0, 0.5}, "",
       "The loop around a removed vertex is split by lines between two of its vertices. A line is "
       "refused when another vertex of the loop is nearer to it than this part of its length. More "
       "gives rounder triangles and more error, and may stop before the target; a square has 0.5.",
       "More gives rounder triangles and may stop before the target.",
       {}, {removal<&VertexRemovalParams::aspect_ratio_min>()}},
      {"PreserveFeatures", "Preserve sharp edges and corners", Kind::Bool, any, "",
       "Vertices on edges sharper than <i>Feature angle</i> go only along these edges, and corners, "
       "where an edge ends or more than two meet, stay. May stop before the target. Off: they go "
       "along them where they can, and in any other way where that costs little.",
       "Nothing leaves a sharp edge, and corners stay.",
       {}, {removal<&VertexRemovalParams::preserve_features>()}},
      {"ShowClasses", "Show the classes of the vertices", Kind::Bool, any, "",
       "Write to quality and colour of every vertex of the result what stands around it: 0 simple "
       "(grey), 1 complex (red), 2 boundary (blue), 3 interior edge (green), 4 corner (orange). "
       "With a <i>Fraction of the faces</i> of 1 the mesh itself stays as it is.",
       "As quality and colour: simple, complex, boundary, interior edge, corner.",
       {}, {removal<&VertexRemovalTask::show_classes>()}},
  };
}

std::vector<Parameter> clustering_rows() {
  return {
      {"Representative", "Representative of a cell", Kind::Enum, any, "",
       "Where the vertex of a cell goes. It stays within the cell.", "",
       {{"Quadric", "lowest error",
         "where the squared distance to the planes of the faces is least, or, where that leaves a "
         "choice, near the mean: the lowest error (Lindstrom)"},
        {"Mean", "", "the mean of the cell's vertices"},
        {"WeightedMean", "as below", "the same, with the weights chosen below"},
        {"Median", "an original vertex",
         "the vertex nearest to the median of every coordinate: the result has original vertices "
         "only"},
        {"CellCenter", "", "the middle of the cell"}},
       {clustering<&ClusteringParams::representative>()}},
      {"MeanWeight", "Weight in WeightedMean", Kind::Enum, any, "",
       "What a vertex counts in the representative WeightedMean.", "",
       {{"Area", "of the faces around", "the area around it: independent of the tessellation"},
        {"Curvature", "", "the area around it times its curvature |k1| + |k2|: drawn to what is "
         "curved"},
        {"Quality", "of the vertex", "its quality: paint or compute a high one on what matters"}},
       {clustering<&ClusteringParams::mean_weight>()}},
      {"ManifoldEdges", "At most two faces at an edge", Kind::Bool, any, "",
       "Drop faces until no edge has more than two, and keep as many as possible. This leaves "
       "holes.",
       "Drops faces, and so leaves holes.",
       {}, {clustering<&ClusteringParams::manifold_edges>()}},
  };
}

std::vector<Parameter> curvature_rows() {
  return {
      {"Alpha", "Curvature weight (alpha; 0: infinite)", Kind::Float, any, "",
       "CurvatureWeighted multiplies the cost by F + (1 - F) (1 - exp(-alpha k&sup2;)), where F is "
       "the <i>Factor of flat places</i> and k the curvature, 1 where the most curved fifth of the "
       "area begins. With the unit ModelUnits the factor is the paper's 1 - exp(-alpha k). A small "
       "alpha protects only the most curved places; a large one brings the factor to 1 everywhere. "
       "0 or less: infinite, that is plain quadrics.",
       "Small protects only the most curved places; 0 or less: plain quadrics.",
       {}, curvature<&CurvatureParams::alpha>()},
      {"CurvatureFloor", "Factor of flat places", Kind::Float, fraction, "",
       "F in the formula of <i>Curvature weight</i>: the factor where the curvature is 0, with "
       "the unit ScaleFree. Lower spends more triangles on curved places and fewer on flat ones: "
       "the default takes about a tenth off the error of the most curved fifth of the area for a "
       "fiftieth more on the whole, 0.01 about a quarter for a quarter more. 1 is plain quadrics. "
       "With ModelUnits it is 0, as in the paper.",
       "Lower protects curved places more (strong: 0.01); 1: plain quadrics.",
       {}, curvature<&CurvatureParams::curvature_floor>()},
      {"AlphaUnits", "Unit of the curvature in alpha", Kind::Enum, any, "",
       "Choose ModelUnits only to repeat published figures: the effect of an alpha then depends "
       "on the size of the model.", "",
       {{"ScaleFree", "1: most curved fifth",
         "curvature is 1 where the most curved fifth of the area begins, so that an alpha means "
         "the same at every size; open borders count as curved"},
        {"ModelUnits", "as in the paper", "the model's own unit of length, as in the paper"}},
       curvature<&CurvatureParams::alpha_units>()},
      {"CurvatureKind", "Kind of curvature", Kind::Enum, any, "",
       "Choose Gaussian for the metric as published; it is blind to cylinders and straight ridges.",
       "",
       {{"Gaussian", "as in the paper", "|K| from the angles around a vertex, in 1/length&sup2;"},
        {"Absolute", "also sees cylinders",
         "|k1| + |k2| of the principal curvatures, in 1/length; with ScaleFree |K| and 0.03 of its "
         "square"}},
       curvature<&CurvatureParams::curvature_kind>()},
      {"CurvatureOf", "Curvature of", Kind::Enum, any, "",
       "Choose Current for the metric as published; it costs time and protects less.", "",
       {{"Input", "the input, faster",
         "the input, averaged with the neighbours; merged vertices average theirs by area"},
        {"Current", "each step, as in the paper",
         "the mesh as it is after each collapse, as in the paper"}},
       curvature<&CurvatureParams::curvature_of>()},
      {"Output", "Value to show", Kind::Enum, any, "",
       "What is written to the quality of the vertices.", "",
       {{"Curvature", "in the model's unit", "the curvature itself, in the model's unit of length"},
        {"Factor", "on the cost, 0 to 1", "the factor on the cost, 0 to 1"}},
       {bind<&Settings::importance, &ImportanceParams::as_factor, int>(
           FilterId::CurvatureImportance)}},
      {"Lambda", "Weight of the additive term (lambda)", Kind::Float, at_least(0), "",
       "CurvatureAdditive adds lambda times the bend at the edge to the cost, with lengths "
       "relative to the bounding box's diagonal. More lowers the largest error and raises the "
       "mean one a little. 0 is plain quadrics.",
       "Weight of the bend at the edge; 0 is plain quadrics.",
       {}, {edge_collapse<&EdgeCollapseParams::lambda>()}},
      {"CurvatureTerm", "Reading of the additive term", Kind::Enum, any, "",
       "The printed formula has two readings; only CurvatureAdditive uses it.", "",
       {{"Melax", "turn of the faces around",
         "edge length times the largest turn from the edge's own faces to a face around: the "
         "intent"},
        {"Literal", "the formula as printed",
         "the formula as printed, which amounts to the edge length"}},
       {edge_collapse<&EdgeCollapseParams::curvature_term>()}},
  };
}

std::vector<Parameter> custom_rows() {
  return {
      {"Quadrics", "Quadrics (preset Custom)", Kind::Enum, any, "",
       "Used with the preset Custom.", "",
       {{"Memoryless", "lower error",
         "computed from the current mesh: lower error (Lindstrom and Turk)"},
        {"Accumulated", "faster", "summed up along the collapses: faster (Garland and Heckbert)"}},
       {edge_collapse<&EdgeCollapseParams::quadrics>()}},
      {"PlaneWeight", "Weight of a plane (preset Custom)", Kind::Enum, any, "",
       "Used with the preset Custom.", "",
       {{"Area", "by the area of the face",
         "a plane counts by the area of its face: independent of the tessellation"},
        {"Unit", "all alike, as in the papers", "every plane counts 1, as in the papers"}},
       {edge_collapse<&EdgeCollapseParams::plane_weight>()}},
      {"Placement", "Placement (preset Custom)", Kind::Enum, any, "",
       "Used with the preset Custom.", "",
       {{"Optimal", "free", "where the quadric error is least"},
        {"Line", "along", "where it is least on the edge"},
        {"EndpointOrMidpoint", "", "the best of both ends and the midpoint"},
        {"HalfEdge", "an end",
         "the better end: the result has original vertices only"}},
       {edge_collapse<&EdgeCollapseParams::placement>()}},
      {"Scheduler", "Scheduler (preset Custom)", Kind::Enum, any, "",
       "Used with the preset Custom.", "",
       {{"Rounds", "",
         "many collapses at once on all cores, the cheapest that lie apart"},
        {"Lazy", "strict order",
         "one by one, cheapest first; costs are brought up to date when they come up"},
        {"Eager", "lower error",
         "one by one, cheapest first; costs around are brought up to date at once"},
        {"FewRounds", "", "as Rounds, with more collapses a round"}},
       {edge_collapse<&EdgeCollapseParams::scheduler>()}},
      {"RefineSweeps", "Refinement sweeps (preset Custom)", Kind::Int, at_least(0), "sweeps",
       "After the collapses each sweep moves the vertices to where both surfaces come closest and "
       "flips edges where that helps; the number of faces stays. 0: none, and none with <i>Maximum "
       "error</i> or the placement HalfEdge. Used with the preset Custom; Best has 3.",
       "Fits the result to the input; Best has 3.",
       {}, {edge_collapse<&EdgeCollapseParams::refine_sweeps>(),
            meaning(sphere<&SphereParams::refine_sweeps>(),
                    "After the collapses each sweep moves the vertices to where both surfaces come "
                    "closest and flips edges where that helps; the number of faces stays. 3 take "
                    "about a sixth off the error, and several times the time. 0: none, and none "
                    "with <i>Maximum error</i>.",
                    "Fits the result to the input: slower, a sixth less error.")}},
  };
}

std::vector<Parameter> guard_rows() {
  return {
      {"PreserveBoundary", "Preserve boundary of the mesh", Kind::Bool, any, "",
       "Vertices of open borders stay on the border's curve, and the error along it counts. "
       "Switch off to let borders shrink.",
       "Open borders stay on their curve.",
       {}, collapse<&DecimationParams::preserve_boundary>(MeshDefault::None,
           {meaning(removal<&DecimationParams::preserve_boundary>(),
                    "The distance of a border vertex to the new border counts. Switch off to let "
                    "borders shrink.",
                    "Distances to open borders count.")})},
      {"BoundaryWeight", "Boundary preserving weight", Kind::Float, at_least(0), "",
       "Weight of borders and sharp edges against the surface, 1 counting both alike. Raise it to "
       "keep more vertices on them.",
       "Of borders and sharp edges; more keeps more vertices on them.",
       {}, collapse<&DecimationParams::boundary_weight>(MeshDefault::None,
           {meaning(removal<&DecimationParams::boundary_weight>(),
                    "Factor on distances to borders and sharp edges in the cost. Raise it to keep "
                    "more vertices on them.",
                    "Of distances to borders and sharp edges."),
            meaning(clustering<&ClusteringParams::boundary_weight>(),
                    "Weight of open borders against the surface in the representative Quadric, 1 "
                    "counting both alike.",
                    "Of open borders, in the representative Quadric.")})},
      {"PreserveNormal", "Preserve normal", Kind::Bool, any, "",
       "Refuse a step that turns a face by more than <i>Largest turn of a face</i>. Switch "
       "off only when folded faces do not matter.",
       "Up to the angle below.",
       {}, decimation<&DecimationParams::preserve_normal>()},
      {"NormalAngle", "Largest turn of a face (degrees)",
       Kind::Float, above_up_to(0, 180), "degrees",
       "Used with <i>Preserve normal</i>. Less keeps the orientation of faces closer and may stop "
       "before the target; above 90 faces may flip.",
       "Less may stop before the target; above 90 faces may flip.",
       {}, decimation<&DecimationParams::normal_angle>()},
      {"PreserveTopology", "Preserve topology", Kind::Bool, any, "",
       "Refuse a collapse that closes a hole, pinches a handle, joins parts or makes an edge of "
       "three faces. With <i>Maximum error</i> such a collapse is always refused.",
       "Keep holes, handles and parts.",
       {}, collapse<&DecimationParams::preserve_topology>()},
      {"PairDistance", "Join what is closer than (0: nothing)", Kind::Length, at_least(0),
       "in the mesh's unit",
       "Two vertices that no edge connects may merge, too, where they were closer than this in the "
       "input: parts join and gaps close, and many small parts become few instead of vanishing "
       "(Garland and Heckbert). Given as a length or as per cent of the bounding box's diagonal. "
       "Turns <i>Preserve topology</i> off, and the presets to one step at a time; edges of three "
       "faces may result. Not together with <i>Maximum error</i>. 0: only edges collapse.",
       "Turns <i>Preserve topology</i> off.",
       {}, {edge_collapse<&EdgeCollapseParams::pair_distance>()}},
      {"FeatureAngle", "Feature angle (degrees; 180: no features)",
       Kind::Float, {0.0, 180.0}, "degrees",
       "An edge between faces whose normals differ by at least this is sharp, and is kept like a "
       "border. 180: no edge is.",
       "Edges with at least this angle between their faces are kept.",
       {}, collapse<&DecimationParams::feature_angle>(MeshDefault::None,
           {meaning(removal<&DecimationParams::feature_angle>(),
                    "An edge of the input between faces whose normals differ by at least this is "
                    "sharp: vertices on it go along it, and the loop around them is split there. "
                    "180: no edge is.",
                    "Edges with at least this angle between their faces are sharp.")})},
      {"Selected", "Simplify only selected faces", Kind::Bool, any, "",
       "The rest of the mesh stays as it is, to the bit. The targets then count selected faces.",
       "Targets count selected faces.",
       {}, every_decimation<&DecimationParams::selected_only,
                            &ClusteringParams::selected_only>(MeshDefault::FacesSelected)},
      {"QualityWeight", "Weighted simplification", Kind::Bool, any, "",
       "The quality of the vertices multiplies the cost: paint or compute a high quality on what "
       "matters.",
       "Vertex quality multiplies the cost.",
       {}, decimation<&DecimationParams::quality_weight>(MeshDefault::None,
           {meaning(clustering<&ClusteringParams::quality_weight>(),
                    "The quality of the vertices multiplies the planes of the representative "
                    "Quadric: paint or compute a high quality on what matters.",
                    "Vertex quality multiplies the quadrics.")})},
      {"Threads", "Number of threads (0: all cores)", Kind::Int, at_least(0), "threads",
       "0: all cores. It never changes the result.",
       "It never changes the result.",
       {}, every_decimation<&DecimationParams::threads, &ClusteringParams::threads>()},
  };
}

// clang-format on

}  // namespace

const std::vector<Parameter>& parameter_table() {
  static const std::vector<Parameter> table = [] {
    std::vector<Parameter> rows;
    for (const auto& group :
         {target_rows(), removal_rows(), clustering_rows(), metric_rows(), sphere_rows(),
          curvature_rows(), custom_rows(), guard_rows()})
      rows.insert(rows.end(), group.begin(), group.end());
    return rows;
  }();
  return table;
}

}  // namespace curvdecim
