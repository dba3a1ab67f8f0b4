// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_curvdecim/filters/common_results.h"
#include "filter_curvdecim/filters/common_rows.h"
#include "filter_curvdecim/table/filter.h"
#include "filter_curvdecim/table/joined.h"
#include "filter_curvdecim/table/references.h"
#include "vcg_ext/algebraic_sphere.h"

namespace curvdecim::glue {

/// Edge collapse by spheres fitted to the input.
struct AlgebraicSphereFilter {
  using Params = SphereParams;
  using Report = DecimationReport;

  template <class MeshType>
  static Report run(MeshType& mesh, const Params& params, const Progress& progress) {
    return decimate_algebraic_sphere(mesh, params, progress);
  }

  static Changes changed(const Report& report) { return change_of_shape(report); }

  static std::string headline(const Report& report) { return headline_of(report, changed(report)); }

  static About about() {
    return {
        "Simplification: Algebraic Sphere Edge Collapse",
        "meshing_decimation_algebraic_sphere",
        Category::Remeshing,
        {true, false},
        "Simplify (decimate, reduce) a smooth shape, by fitted spheres." + bibliography({michaud}),
        "Spheres are fitted to the original surface (Guennebaud, Germann, Gross). Edges collapse "
        "by "
        "how far the new faces are from them, and vertices go where spheres and planes are "
        "nearest: on smooth shapes less error than the preset Balanced of <i>Curvature-Enhanced "
        "Edge Collapse</i>, in about twice its time. A closed manifold stays one; borders and "
        "sharp "
        "edges are kept."};
  }

  static ParameterRows<Params> parameters() {
    return joined<ParameterRow<Params>>({collapse_target_rows<Params>(),
                                         {also_for_assemblies(sweeps_row())},
                                         common_rows<Params>(),
                                         for_papers(kernel_rows()),
                                         for_papers<Params>({energy_row(), placement_row()}),
                                         keep_rows<Params>()});
  }

  static ResultRows<Report, Params> results() {
    return joined<ResultRow<Report, Params>>({count_results<Report, Params>(),
                                              {bound_result<Report, Params>()},
                                              topology_results<Report, Params>(),
                                              collapse_results<Report, Params>()});
  }

 private:
  static constexpr Reference michaud = {"Michaud, Mellado, Paulin", "Eurographics posters, 2017"};

  static ParameterRows<Params> kernel_rows() {
    return {row<Params>(
                &Params::kernel_scale, "KernelScale", "Size of the kernel (edges)",
                {"Radius of the neighbourhood that a sphere is fitted to, in mean edges around its "
                 "vertex. More smooths noise and blurs what is small.",
                 "Radius of a fit; more smooths noise and blurs small shapes."}),
            row<Params>(
                &Params::adaptive_kernel, "AdaptiveKernel", "Adapt the kernel to the shape",
                {"The kernel shrinks where its sphere is far from the vertices that it was fitted "
                 "to, and grows where it is near to them.",
                 "Smaller where the fit is bad, larger where it is good."})};
  }

  static ParameterRow<Params> energy_row() {
    return enum_row<Params>(
        &Params::energy, "Energy", "Distance to the spheres",
        "How the distances of the new faces to the spheres are summed up.",
        {{SphereEnergy::Squared, "lower error",
          "the integral of the squared distance: lower error"},
         {SphereEnergy::Poster, "as printed",
          "the sum over the faces of the mean distance times the area, as printed (Michaud and "
          "others)"}});
  }

  static ParameterRow<Params> placement_row() {
    return enum_row<Params>(
        &Params::placement, "Placement", "Placement",
        "Where the merged vertex goes, and which sphere it keeps.",
        {{SpherePlacement::Free3D, "free, lower error",
          "where spheres and planes are nearest, with a sphere fitted to all of the original that "
          "the vertex stands for: lower error"},
         {SpherePlacement::OnSphereAlongEdge, "as printed",
          "on the sphere between those of both ends, which it keeps, as printed: forgets the "
          "original step by step"}});
  }

  static ParameterRow<Params> sweeps_row() {
    return refine_sweeps_row<Params>(
        "Refinement sweeps (0: none)",
        {"After the collapses each sweep moves the vertices to where both surfaces come closest "
         "and flips edges where that helps; the number of faces stays. 3 take about a sixth off "
         "the error, and several times the time. 0: none, and none with <i>Maximum error</i>.",
         "Fits the result to the input: slower, a sixth less error."});
  }
};

}  // namespace curvdecim::glue
